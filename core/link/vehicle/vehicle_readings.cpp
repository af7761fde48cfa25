#include "core/link/vehicle/vehicle_readings.h"

#include "core/base/angles.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

constexpr double kE7 = 1e7;

std::int64_t rounded(double value)
{
    return std::isfinite(value) && std::abs(value) < 1e15 ? std::llround(value) : 0;
}

/** Returns the angle in degrees in [0, 360). */
double compass_deg(double angle_rad)
{
    const double degrees = std::fmod(angle_rad * 180 / kPi, 360);
    return degrees < 0 ? degrees + 360 : degrees;
}

LinkMessage positionOf(const VehicleReadings& r, std::int64_t boot_ms)
{
    return LinkMessage(MessageId::GlobalPositionInt)
        .with("time_boot_ms", boot_ms)
        .with("lat", rounded(kE7 * r.place.latitude_deg))
        .with("lon", rounded(kE7 * r.place.longitude_deg))
        .with("alt", rounded(1000 * r.altitude_m))
        .with("relative_alt", rounded(1000 * (r.altitude_m - r.homeAltitude_m)))
        .with("vx", rounded(100 * r.north_mps))
        .with("vy", rounded(100 * r.east_mps))
        .with("vz", rounded(100 * r.down_mps))
        .with("hdg", rounded(100 * compass_deg(r.heading_rad)) % 36000);
}

LinkMessage gpsOf(const VehicleReadings& r, double sinceBoot_s)
{
    const double course_rad = std::atan2(r.east_mps, r.north_mps);
    return LinkMessage(MessageId::GpsRawInt)
        .with("time_usec", rounded(1e6 * sinceBoot_s))
        .with("lat", rounded(kE7 * r.place.latitude_deg))
        .with("lon", rounded(kE7 * r.place.longitude_deg))
        .with("alt", rounded(1000 * r.altitude_m))
        .with("eph", 80)
        .with("epv", 120)
        .with("vel", rounded(100 * std::hypot(r.north_mps, r.east_mps)))
        .with("cog", rounded(100 * compass_deg(course_rad)) % 36000)
        .with("fix_type", 3)
        .with("satellites_visible", 12);
}

LinkMessage hudOf(const VehicleReadings& r)
{
    return LinkMessage(MessageId::VfrHud)
        .withReal("airspeed", r.airspeed_mps)
        .withReal("groundspeed", std::hypot(r.north_mps, r.east_mps))
        .withReal("alt", r.altitude_m)
        .withReal("climb", -r.down_mps)
        .with("heading", rounded(compass_deg(r.heading_rad)) % 360)
        .with("throttle", r.isFlying ? 50 : 0);
}

LinkMessage batteryOf(const VehicleReadings& r)
{
    LinkMessage message(MessageId::BatteryStatus);
    message.with("current_consumed", -1)
        .with("energy_consumed", -1)
        .with("temperature", 32767) // unknown
        .with("current_battery", rounded(100 * r.current_a))
        .with("battery_remaining", std::clamp<std::int64_t>(rounded(100 * r.battery), 0, 100))
        .with("time_remaining", rounded(r.timeRemaining_s.value_or(0)))
        .with("charge_state", 1);
    for (int cell = 0; cell < 10; ++cell)
        message.with("voltages", cell == 0 ? rounded(1000 * r.voltage_v) : 65535, cell);
    return message;
}

LinkMessage systemStatusOf(const VehicleReadings& r)
{
    return LinkMessage(MessageId::SysStatus)
        .with("voltage_battery", rounded(1000 * r.voltage_v))
        .with("current_battery", rounded(100 * r.current_a))
        .with("battery_remaining", std::clamp<std::int64_t>(rounded(100 * r.battery), 0, 100));
}

LinkMessage homeOf(const VehicleReadings& r)
{
    return LinkMessage(MessageId::HomePosition)
        .with("latitude", rounded(kE7 * r.home.latitude_deg))
        .with("longitude", rounded(kE7 * r.home.longitude_deg))
        .with("altitude", rounded(1000 * r.homeAltitude_m))
        .withReal("q", 1, 0);
}

LinkMessage attitudeOf(const VehicleReadings& r, std::int64_t boot_ms)
{
    return LinkMessage(MessageId::Attitude)
        .with("time_boot_ms", boot_ms)
        .withReal("roll", r.roll_rad)
        .withReal("pitch", r.pitch_rad)
        .withReal("yaw", std::remainder(r.heading_rad, 2 * kPi));
}

LinkMessage versionOf(AutopilotKind kind)
{
    // The flags are: missions and parameters as floats, missions and commands with integers,
    // MAVLink 2, fence and rally points by the mission protocol.
    constexpr std::int64_t kCapabilities = 1 | 2 | 4 | 8 | 8192 | 16384 | 32768;
    const std::int64_t version = kind == AutopilotKind::Px4 ? 0x010F00FF : 0x040600FF;
    return LinkMessage(MessageId::AutopilotVersion)
        .with("capabilities", kCapabilities)
        .with("flight_sw_version", version)
        .with("uid", 53);
}

/** Returns the wind: ArduPilot sends the direction from which it blows, PX4 a vector. */
std::optional<LinkMessage> windOf(MessageId id, const VehicleReadings& r, double sinceBoot_s)
{
    if (id == MessageId::Wind)
        return LinkMessage(id)
            .withReal("direction", compass_deg(std::atan2(-r.windEast_mps, -r.windNorth_mps)))
            .withReal("speed", std::hypot(r.windNorth_mps, r.windEast_mps));
    return LinkMessage(id)
        .with("time_usec", rounded(1e6 * sinceBoot_s))
        .withReal("wind_x", r.windNorth_mps)
        .withReal("wind_y", r.windEast_mps)
        .withReal("wind_z", 0)
        .withReal("wind_alt", r.altitude_m);
}

/**
 * Returns the flags of a mode in HEARTBEAT. Ground stations need them to name PX4's modes: an
 * automatic one has all of auto, guided and stabilise, and one that the pilot flies has manual.
 */
int modeFlags(std::uint32_t mode, AutopilotKind kind)
{
    constexpr int kAutomatic = 4 + 8 + 16;
    constexpr int kStabilised = 16;
    constexpr int kManual = 64;
    if (kind == AutopilotKind::Px4) {
        const std::uint32_t main = mode >> 16U & 0xFFU;
        const bool isAutomatic = main == 4 || main == 6; // 6 is "offboard"
        return isAutomatic ? kAutomatic : kManual + (main == 1 ? 0 : kStabilised);
    }
    const bool isManual = mode == 0 || mode == 3 || mode == 4; // MANUAL, TRAINING, ACRO
    const bool isAssisted = mode == 2 || (mode >= 5 && mode <= 8) || (mode >= 17 && mode <= 19);
    return isManual ? kManual : isAssisted ? kStabilised : kAutomatic;
}

} // namespace

LinkMessage heartbeatOf(const VehicleReadings& readings, const VehicleSideOptions& options)
{
    constexpr int kCustomMode = 1;
    constexpr int kArmed = 128;
    return LinkMessage(MessageId::Heartbeat)
        .with("custom_mode", readings.mode)
        .with("type", options.type)
        .with("autopilot", options.autopilot == AutopilotKind::Px4 ? 12 : 3)
        .with("base_mode", kCustomMode + modeFlags(readings.mode, options.autopilot) +
                               (readings.isArmed ? kArmed : 0))
        .with("system_status", readings.isArmed ? 4 : 3)
        .with("mavlink_version", 3);
}

std::optional<LinkMessage> readingsMessage(MessageId id, const VehicleReadings& readings,
                                           AutopilotKind kind, double sinceBoot_s)
{
    const std::int64_t boot_ms = rounded(1000 * sinceBoot_s);
    switch (id) {
    case MessageId::GlobalPositionInt:
        return positionOf(readings, boot_ms);
    case MessageId::GpsRawInt:
        return gpsOf(readings, sinceBoot_s);
    case MessageId::Attitude:
        return attitudeOf(readings, boot_ms);
    case MessageId::VfrHud:
        return hudOf(readings);
    case MessageId::BatteryStatus:
        return batteryOf(readings);
    case MessageId::SysStatus:
        return systemStatusOf(readings);
    case MessageId::HomePosition:
        return homeOf(readings);
    case MessageId::AutopilotVersion:
        return versionOf(kind);
    case MessageId::Wind:
    case MessageId::WindCov:
        return windOf(id, readings, sinceBoot_s);
    case MessageId::ExtendedSysState:
        return LinkMessage(id).with("landed_state", readings.isFlying ? 2 : 1);
    default:
        return std::nullopt;
    }
}

} // namespace berg
