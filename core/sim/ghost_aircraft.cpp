#include "core/sim/ghost_aircraft.h"

#include "core/base/angles.h"
#include "core/base/error.h"
#include "core/link/autopilot_modes.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

RehearsalOptions optionsOf(const LastContact& last)
{
    require(last.vehicle.state.position.has_value(), "GhostAircraft: a position");
    const AircraftState& state = last.vehicle.state;
    const AircraftPosition& position = *state.position;
    UavSpec uav = last.uav;
    if (state.airspeed_mps && *state.airspeed_mps > 0)
        uav.airspeed_mps = *state.airspeed_mps;
    const double homeAltitude_m =
        state.homeAltitude_m.value_or(position.altitude_m - position.aboveHome_m);
    const double course_rad = std::atan2(position.east_mps, position.north_mps);
    return {.side = {.autopilot = last.vehicle.autopilot},
            .uav = uav,
            .home = state.home.value_or(position.place),
            .homeAltitude_m = homeAltitude_m,
            .wind_mps = last.wind_mps,
            .start = position.place,
            .heading_deg = degFromRad(position.heading_rad.value_or(course_rad))};
}

LinkTime timeOf(double now_s)
{
    return {.monotonic_s = now_s, .unix_us = 1};
}

} // namespace

GhostAircraft::GhostAircraft(const LastContact& last)
    : m_flight(*m_link, optionsOf(last)), m_now_s(last.vehicle.state.position->received_s)
{
    const AircraftState& state = last.vehicle.state;
    const AutopilotKind kind = last.vehicle.autopilot;
    const int home = kind == AutopilotKind::ArduPilot ? 1 : 0; // its item 0
    m_flight.load(MissionType::Mission, last.onBoard);
    m_flight.setProgress(state.position->altitude_m,
                         state.mission ? state.mission->item - home : 0);
    m_flight.setMode(last.vehicle.mode);
    if (last.onBoard.empty() && last.vehicle.mode == autopilotModes(kind).mission)
        m_flight.flyStraightOn(); // the end of an empty mission would lead it home
    m_flight.advance(timeOf(m_now_s));
}

void GhostAircraft::advance(double now_s)
{
    m_now_s = std::max(m_now_s, now_s);
    m_flight.advance(timeOf(m_now_s));
}

std::optional<ExpectedContact> GhostAircraft::expectedContact(const LatLon& station, double range_m,
                                                              double horizon_s) const
{
    constexpr double kStep_s = 2;
    GhostAircraft ahead = *this;
    for (const double end_s = m_now_s + horizon_s; ahead.m_now_s <= end_s;
         ahead.advance(ahead.m_now_s + kStep_s))
        if (greatCircle_m(ahead.readings().place, station) <= range_m)
            return ExpectedContact{.place = ahead.readings().place, .at_s = ahead.m_now_s};
    return std::nullopt;
}

} // namespace berg
