#include "core/scenario/advice.h"
#include "widgets/panels/inspector/inspector_row_makers.h"

#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

NumberRow headingRow()
{
    // Kept as the file has it; shown, and written when edited, within one turn.
    const auto oneTurn = [](double heading_deg) {
        const double within_deg = std::fmod(heading_deg, 360);
        return within_deg < 0 ? within_deg + 360 : within_deg;
    };
    return {.words = {.key = u"uavHeading"_s,
                      .label = InspectorRows::tr("Heading"),
                      .toolTip = InspectorRows::tr("Clockwise from north, at the start."),
                      .undoText = InspectorRows::tr("Change heading")},
            .unit = u"°"_s,
            .decimals = {.least = 0, .most = 1},
            .step = 5,
            .read =
                [oneTurn](const Scenario& scenario, const std::string& id) {
                    const Uav* uav = findById(scenario.uavs, id);
                    return uav == nullptr ? 0 : oneTurn(uav->heading_deg);
                },
            .write =
                [oneTurn](Scenario& scenario, const std::string& id, double heading_deg) {
                    if (Uav* uav = findById(scenario.uavs, id))
                        uav->heading_deg = oneTurn(heading_deg);
                },
            // Wide enough to step across north either way.
            .range = always({.low = -360, .high = 720})};
}

NumberRow airspeedRow()
{
    NumberRow row = uavRow({.key = u"uavAirspeed"_s,
                            .label = InspectorRows::tr("Airspeed"),
                            .toolTip = InspectorRows::tr("Always faster than the wind."),
                            .undoText = InspectorRows::tr("Change airspeed")},
                           {}, &UavSpec::airspeed_mps, {});
    row.decimals = {.least = 0, .most = 2};
    row.range = [](const Scenario& scenario) {
        const double wind_mps = scenario.wind_mps.norm();
        return Limits{.low =
                          std::max(limits::kAirspeed_mps.low, std::floor(100 * wind_mps + 1) / 100),
                      .high = limits::kAirspeed_mps.high};
    };
    return asSpeed(row);
}

std::vector<InspectorRow> fieldOfViewRows()
{
    const auto row = [](const QString& key, const QString& label, const QString& toolTip,
                        auto number) {
        return objectRow<Uav>({.key = key,
                               .label = label,
                               .toolTip = toolTip,
                               .undoText = InspectorRows::tr("Change field of view")},
                              u" m"_s, number, limits::kExtent_m, 50);
    };
    return {row(
                u"uavFovAlong"_s, InspectorRows::tr("View along-track"),
                InspectorRows::tr("Extent of the field of view along the heading."),
                [](auto& uav) -> auto& { return uav.fov_m.x(); }),
            row(
                u"uavFovAcross"_s, InspectorRows::tr("View cross-track"),
                InspectorRows::tr("Extent of the field of view across the heading."),
                [](auto& uav) -> auto& { return uav.fov_m.y(); })};
}

} // namespace

std::vector<InspectorRow> uavRows()
{
    std::vector<InspectorRow> rows{nameRow<Uav>(u"uavName"_s)};
    rows.emplace_back(
        GroupRow{.key = u"uavPositionGroup"_s, .title = InspectorRows::tr("Position and heading")});
    append(rows, positionRows<Uav>(u"uav"_s));
    rows.emplace_back(headingRow());
    rows.emplace_back(
        GroupRow{.key = u"uavAircraftGroup"_s, .title = InspectorRows::tr("Aircraft")});
    rows.emplace_back(airspeedRow());
    rows.emplace_back(uavRow({.key = u"uavBank"_s,
                              .label = InspectorRows::tr("Maximum bank angle"),
                              .toolTip = InspectorRows::tr("Bank in a turn; the larger, the "
                                                           "tighter the turns."),
                              .undoText = InspectorRows::tr("Change maximum bank angle")},
                             u"°"_s, &UavSpec::maxBank_deg, limits::kBank_deg));
    append(rows, fieldOfViewRows());
    rows.emplace_back(asHeight(
        uavRow({.key = u"uavAltitude"_s,
                .label = InspectorRows::tr("Altitude"),
                .toolTip = InspectorRows::tr("Height above the sea: UAVs that are %1 apart in it "
                                             "pass each other.")
                               .arg(heightText(kLayerHeight_m, QLocale())),
                .undoText = InspectorRows::tr("Change altitude")},
               {}, &UavSpec::altitude_m, limits::kExtent_m, 10)));
    NumberRow autopilot =
        uavRow({.key = u"uavAutopilot"_s,
                .label = InspectorRows::tr("Autopilot rate"),
                .toolTip = InspectorRows::tr("Time between two commands of the autopilot; at 0 it "
                                             "commands at each time step."),
                .undoText = InspectorRows::tr("Change autopilot rate")},
               u" s"_s, &UavSpec::autopilot_s, limits::kAutopilot_s);
    autopilot.decimals = {.least = 0, .most = 2};
    autopilot.lowestText = InspectorRows::tr("each time step");
    rows.emplace_back(autopilot);
    rows.emplace_back(
        GroupRow{.key = u"uavEnduranceGroup"_s, .title = InspectorRows::tr("Endurance and home")});
    NumberRow endurance =
        uavRow({.key = u"uavEndurance"_s,
                .label = InspectorRows::tr("Endurance"),
                .toolTip = InspectorRows::tr("Longest flight: it is home before that; at 0 "
                                             "it lands only when told to return."),
                .undoText = InspectorRows::tr("Change endurance")},
               u" s"_s, &UavSpec::endurance_s, limits::kTime_s, 60);
    endurance.lowestText = InspectorRows::tr("unlimited");
    rows.emplace_back(endurance);
    append(rows, reserveRows());
    append(rows, homeRows());
    rows.emplace_back(
        GroupRow{.key = u"uavWeatherGroup"_s, .title = InspectorRows::tr("Weather limits")});
    append(rows, weatherLimitRows());
    return rows;
}

} // namespace berg
