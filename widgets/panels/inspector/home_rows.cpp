#include "widgets/panels/inspector/inspector_row_makers.h"
#include "widgets/theme/quantity_text.h"

using namespace Qt::StringLiterals;

namespace berg {
namespace {

bool hasHome(const Scenario& scenario, const std::string& id)
{
    const Uav* uav = findById(scenario.uavs, id);
    return isLimited(scenario, id) || (uav != nullptr && uav->home_m);
}

/** One coordinate of where it lands; setting it makes that a place of its own. */
NumberRow homeRow(const QString& key, const QString& label, const QString& toolTip, int axis)
{
    return asDistance({.words = {.key = key,
                                 .label = label,
                                 .toolTip = toolTip,
                                 .undoText = InspectorRows::tr("Change home"),
                                 .isShown = hasHome},
                       .unit = {},
                       .decimals = {.least = 0, .most = 1},
                       .step = 10,
                       .read =
                           [axis](const Scenario& scenario, const std::string& id) {
                               const Uav* uav = findById(scenario.uavs, id);
                               return uav == nullptr ? 0
                                                     : uav->home_m.value_or(uav->position_m)[axis];
                           },
                       .write =
                           [axis](Scenario& scenario, const std::string& id, double value) {
                               Uav* uav = findById(scenario.uavs, id);
                               if (uav == nullptr)
                                   return;
                               Point home_m = uav->home_m.value_or(uav->position_m);
                               home_m[axis] = value;
                               uav->home_m = home_m;
                           },
                       .range = always(limits::kCoordinate_m)});
}

PartRow ownHomeRow()
{
    return {.words = {.key = u"uavHomeClear"_s,
                      .label = InspectorRows::tr("Home"),
                      .toolTip = InspectorRows::tr("It lands elsewhere than it starts."),
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
    return {homeRow(u"uavHomeEast"_s, InspectorRows::tr("Home east"),
                    InspectorRows::tr("Where it lands, east of the scenario's origin."), 0),
            homeRow(u"uavHomeNorth"_s, InspectorRows::tr("Home north"),
                    InspectorRows::tr("Where it lands, north of the scenario's origin."), 1),
            ownHomeRow(),
            objectRow<Uav>({.key = u"uavTurnaround"_s,
                            .label = InspectorRows::tr("Turn-around"),
                            .toolTip = InspectorRows::tr(
                                "Time on the ground between landing and the next take-off."),
                            .undoText = InspectorRows::tr("Change turn-around"),
                            .isShown = isLimited},
                           u" s"_s, &Uav::turnaround_s, limits::kTime_s, 60)};
}

} // namespace berg
