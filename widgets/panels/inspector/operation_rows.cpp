// What keeps a flight safe: reserve, limits of the weather, the weather itself, the radio link.

#include "core/sim/sortie_outlook.h"
#include "widgets/panels/inspector/inspector_row_makers.h"
#include "widgets/theme/quantity_text.h"

using namespace Qt::StringLiterals;

namespace berg {
namespace {

bool hasStation(const Scenario& scenario, const std::string& /*id*/)
{
    return scenario.groundStation.has_value();
}

NumberRow sortieRow(const RowWords& words, double UavSpec::*member, const Limits& limits,
                    const QString& unit)
{
    NumberRow row = uavRow(words, unit, member, limits, 5);
    row.words.isShown = isLimited;
    return row;
}

PickRow icingRow()
{
    return choiceRow({.key = u"uavIcing"_s,
                      .label = InspectorRows::tr("Icing conditions"),
                      .toolTip = InspectorRows::tr("Whether it may be flown below 0 °C in air that "
                                                   "is nearly saturated."),
                      .undoText = InspectorRows::tr("Change icing limit")},
                     {InspectorRows::tr("do not fly"), InspectorRows::tr("flying allowed")},
                     memberOf<Uav>([](auto& uav) -> auto& { return uav.weather.icing; }));
}

NumberRow stationPlaceRow(const QString& key, const QString& label, const QString& toolTip,
                          int axis)
{
    const auto coordinate = [axis](auto& station) -> auto&
    {
        return station.position_m[axis];
    };
    return asDistance(numberRow({.key = key,
                                 .label = label,
                                 .toolTip = toolTip,
                                 .undoText = InspectorRows::tr("Move ground station"),
                                 .isShown = hasStation},
                                {}, ofPart(&Scenario::groundStation, coordinate),
                                always(limits::kCoordinate_m), 10));
}

std::vector<InspectorRow> stationRows()
{
    const FlagRow station{
        .words = {.key = u"scenarioStation"_s,
                  .label = InspectorRows::tr("Ground station"),
                  .toolTip = InspectorRows::tr("Where the radio link to the UAVs is kept from. Its "
                                               "range is a ring on the map."),
                  .undoText = InspectorRows::tr("Change ground station")},
        .read = [](const Scenario& scenario) { return scenario.groundStation.has_value(); },
        .write =
            [](Scenario& scenario, bool on) {
                scenario.groundStation.reset();
                if (on)
                    scenario.groundStation = GroundStation{
                        .position_m = scenario.uavs.empty() ? Point(Point::Zero())
                                                            : scenario.uavs.front().position_m};
            }};
    const NumberRow antenna = numberRow(
        {.key = u"stationAntenna"_s,
         .label = InspectorRows::tr("Antenna height"),
         .toolTip = InspectorRows::tr("Height above the sea."),
         .undoText = InspectorRows::tr("Change antenna height"),
         .isShown = hasStation},
        {}, ofPart(&Scenario::groundStation, &GroundStation::antenna_m), always(limits::kLength_m));
    NumberRow range = optionalRow(
        {.key = u"stationRange"_s,
         .label = InspectorRows::tr("Link range"),
         .toolTip = InspectorRows::tr("How far the link reaches; at the lowest value to the radio "
                                      "horizon of the antenna and the UAV's altitude."),
         .undoText = InspectorRows::tr("Change link range"),
         .isShown = hasStation},
        {}, ofPart(&Scenario::groundStation, &GroundStation::range_m), limits::kLength_m,
        InspectorRows::tr("radio horizon"), limits::kExtent_m.low);
    range.step = 1000;
    return {station,
            stationPlaceRow(u"stationEast"_s, InspectorRows::tr("Station east"),
                            InspectorRows::tr("East of the scenario's origin."), 0),
            stationPlaceRow(u"stationNorth"_s, InspectorRows::tr("Station north"),
                            InspectorRows::tr("North of the scenario's origin."), 1),
            asHeight(antenna), asDistance(range)};
}

} // namespace

std::vector<InspectorRow> reserveRows()
{
    return {sortieRow({.key = u"uavReserve"_s,
                       .label = InspectorRows::tr("Reserve"),
                       .toolTip = InspectorRows::tr("Part of the endurance that no flight is "
                                                    "planned to use."),
                       .undoText = InspectorRows::tr("Change reserve")},
                      &UavSpec::reservePercent, limits::kReservePercent, u" %"_s),
            optionalRow({.key = u"uavFixedReserve"_s,
                         .label = InspectorRows::tr("Fixed reserve"),
                         .toolTip = InspectorRows::tr("A time in place of the percentage."),
                         .undoText = InspectorRows::tr("Change reserve"),
                         .isShown = isLimited},
                        u" s"_s,
                        memberOf<Uav>([](auto& uav) -> auto& { return uav.spec.reserve_s; }),
                        limits::kTime_s, InspectorRows::tr("by percentage")),
            sortieRow({.key = u"uavClimb"_s,
                       .label = InspectorRows::tr("Climb"),
                       .toolTip = InspectorRows::tr("Time from take-off to the altitude."),
                       .undoText = InspectorRows::tr("Change climb time")},
                      &UavSpec::climb_s, limits::kTime_s, u" s"_s),
            sortieRow({.key = u"uavLanding"_s,
                       .label = InspectorRows::tr("Landing"),
                       .toolTip = InspectorRows::tr("Time from the altitude, over home, to the "
                                                    "ground."),
                       .undoText = InspectorRows::tr("Change landing time")},
                      &UavSpec::landing_s, limits::kTime_s, u" s"_s)};
}

std::vector<InspectorRow> weatherLimitRows()
{
    return {asSpeed(optionalRow(
                {.key = u"uavMaxWind"_s,
                 .label = InspectorRows::tr("Wind limit"),
                 .toolTip = InspectorRows::tr("Strongest wind in which it is flown."),
                 .undoText = InspectorRows::tr("Change wind limit")},
                {}, memberOf<Uav>([](auto& uav) -> auto& { return uav.weather.wind_mps; }),
                limits::kWindSpeed_mps, InspectorRows::tr("none"))),
            asSpeed(optionalRow(
                {.key = u"uavMaxGust"_s,
                 .label = InspectorRows::tr("Gust limit"),
                 .toolTip = InspectorRows::tr("Strongest gusts in which it is flown."),
                 .undoText = InspectorRows::tr("Change gust limit")},
                {}, memberOf<Uav>([](auto& uav) -> auto& { return uav.weather.gust_mps; }),
                limits::kWindSpeed_mps, InspectorRows::tr("none"))),
            icingRow()};
}

std::vector<InspectorRow> surroundingsRows()
{
    const auto degrees = [](const QString& key, const QString& label, const QString& toolTip,
                            auto member) {
        return optionalRow({.key = key,
                            .label = label,
                            .toolTip = toolTip,
                            .undoText = InspectorRows::tr("Change weather")},
                           u" °C"_s, ofScenario(member), limits::kTemperature_degC,
                           InspectorRows::tr("not known"));
    };
    std::vector<InspectorRow> rows{
        asSpeed(optionalRow(
            {.key = u"scenarioGusts"_s,
             .label = InspectorRows::tr("Gusts"),
             .toolTip = InspectorRows::tr("Speed of the gusts, compared with the "
                                          "limits of the UAVs."),
             .undoText = InspectorRows::tr("Change weather")},
            {}, ofScenario([](auto& scenario) -> auto& { return scenario.weather.gust_mps; }),
            limits::kWindSpeed_mps, InspectorRows::tr("not known"))),
        degrees(
            u"scenarioTemperature"_s, InspectorRows::tr("Temperature"),
            InspectorRows::tr("Of the air at the sea."),
            [](auto& scenario) -> auto& { return scenario.weather.temperature_degC; }),
        degrees(
            u"scenarioDewPoint"_s, InspectorRows::tr("Dew point"),
            InspectorRows::tr("With the temperature it tells whether ice may form."),
            [](auto& scenario) -> auto& { return scenario.weather.dewPoint_degC; })};
    append(rows, stationRows());
    return rows;
}

} // namespace berg
