#include "core/link/aircraft_state.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace berg {

namespace {

constexpr double kUnitsPerDegree = 1e7;
constexpr double kWindMemory_s = 60; ///< Time constant of the running mean.
constexpr double kStrongestWind_mps = 150;

std::optional<LatLon> placeIn(const LinkMessage& message, const char* latitude,
                              const char* longitude)
{
    const LatLon place{.latitude_deg = message.real(latitude) / kUnitsPerDegree,
                       .longitude_deg = message.real(longitude) / kUnitsPerDegree};
    // Autopilots without a position send zeros.
    const bool isNowhere = place.latitude_deg == 0 && place.longitude_deg == 0;
    if (isNowhere || std::abs(place.latitude_deg) > 90 || std::abs(place.longitude_deg) > 180)
        return std::nullopt;
    return place;
}

std::optional<double> finite(double value)
{
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

double fullTurn(double angle_rad)
{
    const double turn = 2 * std::numbers::pi;
    const double rest = std::fmod(angle_rad, turn);
    return rest < 0 ? rest + turn : rest;
}

void updatePosition(AircraftState& state, const LinkMessage& message, double now_s)
{
    const std::optional<LatLon> place = placeIn(message, "lat", "lon");
    if (!place)
        return;
    AircraftPosition position{.place = *place,
                              .altitude_m = message.real("alt") / 1000,
                              .aboveHome_m = message.real("relative_alt") / 1000,
                              .north_mps = message.real("vx") / 100,
                              .east_mps = message.real("vy") / 100,
                              .down_mps = message.real("vz") / 100,
                              .received_s = now_s};
    if (const std::int64_t heading_cdeg = message.integer("hdg"); heading_cdeg < 36000)
        position.heading_rad = static_cast<double>(heading_cdeg) / 100 * std::numbers::pi / 180;
    state.position = position;
}

void updateWind(AircraftState& state, double north_mps, double east_mps, double now_s)
{
    // Rejects NaN, which means "unknown".
    if (!(std::hypot(north_mps, east_mps) <= kStrongestWind_mps))
        return;
    AircraftWind wind = state.wind.value_or(
        AircraftWind{.meanNorth_mps = north_mps, .meanEast_mps = east_mps, .received_s = now_s});
    const double weight = 1 - std::exp(-std::max(0.0, now_s - wind.received_s) / kWindMemory_s);
    const double north = north_mps - wind.meanNorth_mps;
    const double east = east_mps - wind.meanEast_mps;
    wind.meanNorth_mps += weight * north;
    wind.meanEast_mps += weight * east;
    const double square = (north * north + east * east) * weight;
    wind.scatter_mps = std::sqrt((1 - weight) * (wind.scatter_mps * wind.scatter_mps + square));
    wind.north_mps = north_mps;
    wind.east_mps = east_mps;
    wind.received_s = now_s;
    state.wind = wind;
}

void updateBattery(AircraftState& state, const LinkMessage& message, double now_s)
{
    const bool isSystem = message.id() == MessageId::SysStatus;
    if (!isSystem && message.integer("id") != 0) // battery 0 powers the flight
        return;
    AircraftBattery battery = state.battery.value_or(AircraftBattery{});
    const std::int64_t percent = message.integer("battery_remaining");
    if (percent >= 0 && percent <= 100)
        battery.remaining = static_cast<double>(percent) / 100;
    if (message.integer("current_battery") >= 0)
        battery.current_a = message.real("current_battery") / 100;
    if (isSystem) {
        if (message.integer("voltage_battery") != 65535)
            battery.voltage_v = message.real("voltage_battery") / 1000;
    } else if (message.integer("time_remaining") > 0) {
        battery.timeRemaining_s = message.real("time_remaining");
    }
    battery.received_s = now_s;
    state.battery = battery;
}

} // namespace

void updateState(AircraftState& state, const LinkMessage& message, double now_s)
{
    switch (message.id()) {
    case MessageId::GlobalPositionInt:
        return updatePosition(state, message, now_s);
    case MessageId::Attitude:
        if (std::isfinite(message.real("roll") + message.real("pitch") + message.real("yaw")))
            state.attitude = {.roll_rad = message.real("roll"),
                              .pitch_rad = message.real("pitch"),
                              .heading_rad = fullTurn(message.real("yaw")),
                              .received_s = now_s};
        return;
    case MessageId::Wind: { // the direction from which it blows
        const double from_rad = message.real("direction") * std::numbers::pi / 180;
        const double speed_mps = message.real("speed");
        return updateWind(state, -speed_mps * std::cos(from_rad), -speed_mps * std::sin(from_rad),
                          now_s);
    }
    case MessageId::WindCov:
        return updateWind(state, message.real("wind_x"), message.real("wind_y"), now_s);
    case MessageId::SysStatus:
    case MessageId::BatteryStatus:
        return updateBattery(state, message, now_s);
    case MessageId::VfrHud:
        state.airspeed_mps = finite(message.real("airspeed"));
        state.groundSpeed_mps = finite(message.real("groundspeed"));
        return;
    case MessageId::MissionCurrent: {
        const std::int64_t total = message.integer("total");
        const auto id = static_cast<std::uint32_t>(message.integer("mission_id"));
        state.mission = {.item = static_cast<int>(message.integer("seq")),
                         .total = total > 0 && total < 65535
                                      ? std::optional(static_cast<int>(total))
                                      : std::nullopt,
                         .state = static_cast<int>(message.integer("mission_state")),
                         .missionId = id != 0 ? std::optional(id) : std::nullopt,
                         .received_s = now_s};
        return;
    }
    case MessageId::MissionItemReached:
        state.reachedItem = static_cast<int>(message.integer("seq"));
        return;
    case MessageId::ExtendedSysState:
        if (const std::int64_t landed = message.integer("landed_state"); landed != 0)
            state.isFlying = landed != 1;
        return;
    case MessageId::HomePosition:
        if (const std::optional<LatLon> home = placeIn(message, "latitude", "longitude")) {
            state.home = home;
            state.homeAltitude_m = message.real("altitude") / 1000;
        }
        return;
    default:
        return;
    }
}

} // namespace berg
