#include "widgets/panels/inspector/inspector_row_makers.h"

using namespace Qt::StringLiterals;

namespace berg {
std::vector<InspectorRow> plannerRows()
{
    // 0 stands for "none": the file leaves the member out.
    NumberRow reach{
        .words = {.key = u"scenarioReach"_s,
                  .label = InspectorRows::tr("Acceptance radius"),
                  .toolTip = InspectorRows::tr("How near the UAV has to come to an iceberg; at 0 "
                                               "it is reached when it is in view."),
                  .undoText = InspectorRows::tr("Change acceptance radius")},
        .unit = u" m"_s,
        .decimals = {.least = 0, .most = 1},
        .step = 10,
        .read = [](const Scenario& scenario,
                   const std::string&) { return scenario.reachRadius_m.value_or(0); },
        .write =
            [](Scenario& scenario, const std::string&, double value) {
                scenario.reachRadius_m = value > 0
                                             ? std::optional(std::max(value, limits::kExtent_m.low))
                                             : std::nullopt;
            },
        .range = always(limits::kLength_m),
        .lowestText = InspectorRows::tr("in view")};
    NumberRow latency{
        .words = {.key = u"scenarioLatency"_s,
                  .label = InspectorRows::tr("Planning time"),
                  .toolTip = InspectorRows::tr("How long a plan takes in flight; until it is there "
                                               "the UAV continues with the previous "
                                               "plan."),
                  .undoText = InspectorRows::tr("Change planning time")},
        .unit = u" s"_s,
        .decimals = {.least = 0, .most = 1},
        .step = 1,
        .read = [](const Scenario& scenario,
                   const std::string&) { return scenario.planningTime_s; },
        .write = [](Scenario& scenario, const std::string&,
                    double value) { scenario.planningTime_s = value; },
        .range = always(limits::kPlanningDelay_s)};
    const FlagRow clusters{
        .words = {.key = u"scenarioClusters"_s,
                  .label = InspectorRows::tr("Group nearby icebergs"),
                  .toolTip = InspectorRows::tr("Icebergs that fit into one field of view are "
                                               "planned as one point, from which all are seen."),
                  .undoText = InspectorRows::tr("Change grouping of nearby icebergs")},
        .read = [](const Scenario& scenario) { return scenario.clusters; },
        .write = [](Scenario& scenario, bool on) { scenario.clusters = on; }};
    return {reach, latency, clusters,
            choiceRow(
                {.key = u"scenarioFovShape"_s,
                 .label = InspectorRows::tr("Field of view"),
                 .toolTip = InspectorRows::tr("Shape of what the camera covers."),
                 .undoText = InspectorRows::tr("Change field of view")},
                {InspectorRows::tr("turns with the UAV"), InspectorRows::tr("along the north"),
                 InspectorRows::tr("a disk")},
                [](auto& scenario) -> auto& { return scenario.fovShape; }),
            choiceRow(
                {.key = u"scenarioFormulation"_s,
                 .label = InspectorRows::tr("Formulation"),
                 .toolTip = InspectorRows::tr("Integer program that COIN-OR CBC solves when it is "
                                              "the solver."),
                 .undoText = InspectorRows::tr("Change formulation")},
                {InspectorRows::tr("by position"), InspectorRows::tr("as printed"),
                 InspectorRows::tr("reduced")},
                [](auto& scenario) -> auto& { return scenario.planner.formulation; })};
}

} // namespace berg
