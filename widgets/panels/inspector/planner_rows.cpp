#include "widgets/panels/inspector/inspector_row_makers.h"

using namespace Qt::StringLiterals;

namespace berg {
std::vector<InspectorRow> plannerRows()
{
    // 0 stands for "none": the file leaves the member out.
    NumberRow reach =
        optionalRow({.key = u"scenarioReach"_s,
                     .label = InspectorRows::tr("Acceptance radius"),
                     .toolTip = InspectorRows::tr("How near the UAV has to come to an iceberg; at "
                                                  "0 it is reached when it is in view."),
                     .undoText = InspectorRows::tr("Change acceptance radius")},
                    u" m"_s, ofScenario(&Scenario::reachRadius_m), limits::kLength_m,
                    InspectorRows::tr("in view"), limits::kExtent_m.low);
    reach.step = 10;
    return {reach,
            numberRow({.key = u"scenarioLatency"_s,
                       .label = InspectorRows::tr("Planning time"),
                       .toolTip = InspectorRows::tr("How long a plan takes in flight; until it is "
                                                    "there the UAV continues with the previous "
                                                    "plan."),
                       .undoText = InspectorRows::tr("Change planning time")},
                      u" s"_s, ofScenario(&Scenario::planningTime_s),
                      always(limits::kPlanningDelay_s)),
            flagRow({.key = u"scenarioClusters"_s,
                     .label = InspectorRows::tr("Group nearby icebergs"),
                     .toolTip = InspectorRows::tr("Icebergs that fit into one field of view are "
                                                  "planned as one point, from which all are seen."),
                     .undoText = InspectorRows::tr("Change grouping of nearby icebergs")},
                    &Scenario::clusters),
            choiceRow({.key = u"scenarioFovShape"_s,
                       .label = InspectorRows::tr("Field of view"),
                       .toolTip = InspectorRows::tr("Shape of what the camera covers."),
                       .undoText = InspectorRows::tr("Change field of view")},
                      {InspectorRows::tr("turns with the UAV"),
                       InspectorRows::tr("along the north"), InspectorRows::tr("a disk")},
                      ofScenario(&Scenario::fovShape)),
            choiceRow(
                {.key = u"scenarioFormulation"_s,
                 .label = InspectorRows::tr("Formulation"),
                 .toolTip = InspectorRows::tr("Integer program that COIN-OR CBC solves when it is "
                                              "the solver."),
                 .undoText = InspectorRows::tr("Change formulation")},
                {InspectorRows::tr("by position"), InspectorRows::tr("as printed"),
                 InspectorRows::tr("reduced")},
                ofScenario([](auto& scenario) -> auto& { return scenario.planner.formulation; }))};
}

} // namespace berg
