#include "widgets/panels/inspector/field_inputs.h"

using namespace Qt::StringLiterals;

namespace berg {
namespace {

/**
 * Returns the row of the heading. The file's value is kept; it is shown and edited within one turn.
 */
NumberRow headingRow(const FieldInputs<Uav>& uav)
{
    const auto oneTurn = [](double heading_deg) {
        const double within_deg = std::fmod(heading_deg, 360);
        return within_deg < 0 ? within_deg + 360 : within_deg;
    };
    NumberRow row = uav.number("heading_deg");
    row.read = [read = row.read, oneTurn](const Scenario& scenario, const std::string& id) {
        return oneTurn(read(scenario, id));
    };
    row.write = [write = row.write, oneTurn](Scenario& scenario, const std::string& id,
                                             double heading_deg) {
        write(scenario, id, oneTurn(heading_deg));
    };
    // Allows stepping across north in both directions.
    row.range = always({.low = -360, .high = 720});
    return row;
}

NumberRow airspeedRow(const FieldInputs<Uav>& uav)
{
    NumberRow row = uav.inSi("airspeed_mps");
    row.range = [](const Scenario& scenario) {
        const double wind_mps = scenario.wind_mps.norm();
        return Limits{.low =
                          std::max(limits::kAirspeed_mps.low, std::floor(100 * wind_mps + 1) / 100),
                      .high = limits::kAirspeed_mps.high};
    };
    return asSpeed(row);
}

} // namespace

std::vector<InspectorRow> uavRows()
{
    const FieldInputs<Uav> uav("uavs.");
    const FieldInputs<Uav> sortie("uavs.", isLimited);
    std::vector<InspectorRow> rows = uav.rows("name");
    beginGroup(rows, u"uavPositionGroup"_s, InspectorRows::tr("Position and heading"));
    append(rows, positionRows<Uav>(u"uav"_s, "uavs."));
    rows.emplace_back(headingRow(uav));
    beginGroup(rows, u"uavAircraftGroup"_s, InspectorRows::tr("Aircraft"));
    rows.emplace_back(airspeedRow(uav));
    append(rows, uav.rows("max_bank_deg", "altitude_m"));
    append(rows, uav.rows("autopilot_s"));
    beginGroup(rows, u"uavEnduranceGroup"_s, InspectorRows::tr("Endurance and home"));
    append(rows, uav.rows("endurance_s"));
    append(rows, sortie.rows("reserve_percent", "landing_s"));
    append(rows, homeRows());
    append(rows, sortie.rows("turnaround_s"));
    beginGroup(rows, u"uavMissionGroup"_s, InspectorRows::tr("Autopilot mission"), true);
    append(rows, aircraftRows());
    beginGroup(rows, u"uavWeatherGroup"_s, InspectorRows::tr("Weather limits"));
    append(rows, uav.rows("max_wind_mps", "min_ceiling_m"));
    rows.emplace_back(uav.choice(
        "icing", {InspectorRows::tr("do not fly"), InspectorRows::tr("flying allowed")}));
    return rows;
}

} // namespace berg
