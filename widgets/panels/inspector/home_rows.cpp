#include "widgets/panels/inspector/field_inputs.h"
#include "widgets/theme/quantity_text.h"

using namespace Qt::StringLiterals;

namespace berg {
namespace {

bool hasHome(const Scenario& scenario, const std::string& id)
{
    const Uav* uav = findById(scenario.uavs, id);
    return isLimited(scenario, id) || (uav != nullptr && uav->home_m);
}

/**
 * Returns the row of a coordinate of the landing place; editing it separates the place from the
 * start.
 */
NumberRow homeRow(const QString& key, int axis)
{
    NumberRow row = FieldInputs<Uav>("uavs.", hasHome).inSi("home_m", axis);
    row.read = [axis](const Scenario& scenario, const std::string& id) {
        const Uav* uav = findById(scenario.uavs, id);
        return uav == nullptr ? 0 : uav->home_m.value_or(uav->position_m)[axis];
    };
    row.write = [axis](Scenario& scenario, const std::string& id, double value) {
        Uav* uav = findById(scenario.uavs, id);
        if (uav == nullptr)
            return;
        Point home_m = uav->home_m.value_or(uav->position_m);
        home_m[axis] = value;
        uav->home_m = home_m;
    };
    return asDistance(named(row, key, InspectorRows::tr("Change home")));
}

PartRow ownHomeRow()
{
    return {.words = {.key = u"uavHomeClear"_s,
                      .label = InspectorRows::tr("Home"),
                      .toolTip = InspectorRows::tr("Landing place other than the start."),
                      .undoText = InspectorRows::tr("Land where it starts")},
            .removeText = InspectorRows::tr("Clear"),
            .text = [](const Scenario& scenario, const std::string& id,
                       const QLocale& locale) -> QString {
                const Uav* uav = findById(scenario.uavs, id);
                if (uav == nullptr || !uav->home_m)
                    return {};
                return InspectorRows::tr("%1 from the start")
                    .arg(distanceText((*uav->home_m - uav->position_m).norm(), locale));
            },
            .remove =
                [](Scenario& scenario, const std::string& id) {
                    if (Uav* uav = findById(scenario.uavs, id))
                        uav->home_m.reset();
                }};
}

} // namespace

std::vector<InspectorRow> homeRows()
{
    return {homeRow(u"uavHomeEast"_s, 0), homeRow(u"uavHomeNorth"_s, 1), ownHomeRow()};
}

} // namespace berg
