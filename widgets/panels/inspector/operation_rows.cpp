// Surroundings of a flight: the weather and the radio link.

#include "widgets/panels/inspector/field_inputs.h"

using namespace Qt::StringLiterals;

namespace berg {
namespace {

bool hasStation(const Scenario& scenario, const std::string& /*id*/)
{
    return scenario.groundStation.has_value();
}

std::vector<InspectorRow> stationRows()
{
    const FlagRow station{
        .words = {.key = u"scenarioStation"_s,
                  .label = InspectorRows::tr("Ground station"),
                  .toolTip = InspectorRows::tr(
                      "Position of the radio link to the UAVs. Its range is a ring on the map."),
                  .undoText = InspectorRows::tr("Change ground station")},
        .read = hasStation,
        .write = [](Scenario& scenario, const std::string&, bool on) {
            scenario.groundStation.reset();
            if (on)
                scenario.groundStation = GroundStation{
                    .position_m = scenario.uavs.empty() ? Point(Point::Zero())
                                                        : scenario.uavs.front().position_m};
        }};
    const FieldInputs<GroundStation> inputs("ground_station.", hasStation);
    const QString move = InspectorRows::tr("Move ground station");
    std::vector<InspectorRow> rows{station,
                                   named(inputs.number("position_m", 0), u"stationEast"_s, move),
                                   named(inputs.number("position_m", 1), u"stationNorth"_s, move)};
    append(rows, inputs.rows("antenna_m", "range_m"));
    return rows;
}

} // namespace

std::vector<InspectorRow> surroundingsRows()
{
    const FieldInputs<Weather> weather("weather.");
    std::vector<InspectorRow> rows = weather.rows("gust_mps", "dew_point_degc");
    append(rows, stationRows());
    return rows;
}

} // namespace berg
