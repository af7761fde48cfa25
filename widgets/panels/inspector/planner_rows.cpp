#include "widgets/panels/inspector/field_inputs.h"

using namespace Qt::StringLiterals;

namespace berg {
std::vector<InspectorRow> plannerRows()
{
    const FieldInputs<Scenario> planner("planner.", {}, plannerFields());
    NumberRow reach = planner.inSi("reach_radius_m");
    reach.unit = u" m"_s;
    return {reach, planner.number("planning_delay_s"), planner.flag("clusters"),
            planner.choice("fov_shape",
                           {InspectorRows::tr("turns with the UAV"),
                            InspectorRows::tr("aligned with north"), InspectorRows::tr("a disk")}),
            planner.choice("formulation",
                           {InspectorRows::tr("by position"), InspectorRows::tr("as printed"),
                            InspectorRows::tr("reduced")})};
}

} // namespace berg
