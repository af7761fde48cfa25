#include "core/link/traffic.h"

#include "core/base/angles.h"
#include "core/link/nmea/ais_message.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

constexpr std::ptrdiff_t kMostOfKind = 250;
constexpr double kAircraftKept_s = 60;
constexpr double kShipKept_s = 600;
constexpr double kIceKept_s = 120;
constexpr double kAtShip_m = 300;     ///< Length of a ship, and the error of a radar.
constexpr double kShipPlaced_s = 180; ///< Anchored ships report every three minutes.
// Flags of valid fields.
constexpr std::int64_t kAdsbPosition = 1;
constexpr std::int64_t kAdsbAltitude = 2;
constexpr std::int64_t kAdsbHeading = 4;
constexpr std::int64_t kAdsbVelocity = 8;
constexpr std::int64_t kAisCourse = 2;
constexpr std::int64_t kAisVelocity = 4;

double hundredths(const LinkMessage& message, const char* field)
{
    return message.real(field) / 100;
}

TrafficTarget aircraftOf(const LinkMessage& message)
{
    const std::int64_t flags = message.integer("flags");
    TrafficTarget target{.kind = TrafficTarget::Kind::Aircraft,
                         .id = static_cast<std::uint32_t>(message.integer("ICAO_address")),
                         .name = message.text("callsign")};
    if ((flags & kAdsbAltitude) != 0)
        target.altitude_m = message.real("altitude") / 1000;
    if ((flags & kAdsbHeading) != 0)
        target.course_rad = radFromDeg(hundredths(message, "heading"));
    if ((flags & kAdsbVelocity) != 0)
        target.speed_mps = hundredths(message, "hor_velocity");
    return target;
}

TrafficTarget shipOf(const LinkMessage& message)
{
    const std::int64_t flags = message.integer("flags");
    TrafficTarget target{.kind = TrafficTarget::Kind::Ship,
                         .id = static_cast<std::uint32_t>(message.integer("MMSI")),
                         .name = message.text("name")};
    if ((flags & kAisCourse) != 0)
        target.course_rad = radFromDeg(hundredths(message, "COG"));
    if ((flags & kAisVelocity) != 0)
        target.speed_mps = hundredths(message, "velocity");
    return target;
}

} // namespace

void TrafficList::receive(const LinkMessage& message, double now_s)
{
    const bool isAircraft = message.id() == MessageId::AdsbVehicle;
    if (!isAircraft && message.id() != MessageId::AisVessel)
        return;
    if (isAircraft && (message.integer("flags") & kAdsbPosition) == 0)
        return;
    TrafficTarget target = isAircraft ? aircraftOf(message) : shipOf(message);
    target.place = {.latitude_deg = message.real("lat") / 1e7,
                    .longitude_deg = message.real("lon") / 1e7};
    // AIS reports 91 and 181 degrees for an unknown position.
    if (std::abs(target.place.latitude_deg) > 90 || std::abs(target.place.longitude_deg) > 180)
        return;
    keep(std::move(target), now_s);
}

void TrafficList::receive(const NmeaTarget& reported, double now_s)
{
    const bool isShip = reported.kind == NmeaTarget::Kind::Ship;
    if (reported.kind == NmeaTarget::Kind::Aid && !saysIce(reported.name))
        return;
    if (reported.kind == NmeaTarget::Kind::Radar && isAtShip(reported.place, now_s))
        return;
    TrafficTarget target{.kind = isShip ? TrafficTarget::Kind::Ship : TrafficTarget::Kind::Ice,
                         .id = reported.id,
                         .name = reported.name,
                         .place = reported.place,
                         .speed_mps = reported.speed_mps.value_or(0)};
    if (reported.course_deg)
        target.course_rad = radFromDeg(*reported.course_deg);
    keep(std::move(target), now_s);
}

bool TrafficList::isAtShip(const LatLon& place, double now_s) const
{
    return std::ranges::any_of(m_targets, [&](const auto& entry) {
        const TrafficTarget& target = entry.second;
        if (target.kind != TrafficTarget::Kind::Ship || now_s - target.received_s > kShipPlaced_s)
            return false;
        return LocalFrame(target.place).toPlane(place).norm() <= kAtShip_m;
    });
}

void TrafficList::keep(TrafficTarget target, double now_s)
{
    target.received_s = now_s;
    const std::pair key(target.kind, target.id);
    const std::ptrdiff_t known =
        std::count_if(m_targets.begin(), m_targets.end(),
                      [&](const auto& entry) { return entry.first.first == target.kind; });
    if (known < kMostOfKind || m_targets.contains(key))
        m_targets[key] = std::move(target);
}

void TrafficList::advance(double now_s)
{
    std::erase_if(m_targets, [now_s](const auto& entry) {
        const TrafficTarget& target = entry.second;
        const double age_s = now_s - target.received_s;
        switch (target.kind) {
        case TrafficTarget::Kind::Aircraft:
            return age_s > kAircraftKept_s;
        case TrafficTarget::Kind::Ship:
            return age_s > kShipKept_s;
        case TrafficTarget::Kind::Ice:
            return age_s > kIceKept_s;
        }
        return true;
    });
}

std::vector<TrafficTarget> TrafficList::targets() const
{
    std::vector<TrafficTarget> targets;
    for (const auto& [key, target] : m_targets)
        targets.push_back(target);
    return targets;
}

} // namespace berg
