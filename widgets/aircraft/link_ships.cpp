#include "widgets/aircraft/link_ships.h"

#include "widgets/aircraft/link_text.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

constexpr quint64 kTrackerKey = quint64{1} << 32U; ///< above every MMSI
constexpr double kUnderWay_mps = 0.2;              ///< slower courses are noise

} // namespace

quint64 shipKey(LinkAddress tracker)
{
    return isTracker(tracker) ? kTrackerKey + tracker.component : 0;
}

std::vector<LinkShip> shipsOf(const LinkStatus& status)
{
    std::vector<LinkShip> ships;
    for (const TrafficTarget& target : status.traffic)
        if (target.kind == TrafficTarget::Kind::Ship && target.id != 0)
            ships.push_back({.key = target.id,
                             .name = trafficName(target),
                             .place = target.place,
                             .course_rad = target.course_rad,
                             .speed_mps = target.speed_mps,
                             .received_s = target.received_s});
    for (const LinkVehicle& vehicle : status.vehicles) {
        const std::optional<AircraftPosition>& position = vehicle.state.position;
        if (!isTracker(vehicle.address) || !position)
            continue;
        LinkShip& ship = ships.emplace_back(
            LinkShip{.key = shipKey(vehicle.address),
                     .name = aircraftName(vehicle.address),
                     .place = position->place,
                     .speed_mps = std::hypot(position->north_mps, position->east_mps),
                     .received_s = position->received_s});
        if (ship.speed_mps > kUnderWay_mps)
            ship.course_rad = std::atan2(position->east_mps, position->north_mps);
        else
            ship.speed_mps = 0;
    }
    return ships;
}

std::optional<LinkShip> shipOf(const LinkStatus& status, quint64 key)
{
    std::vector<LinkShip> ships = shipsOf(status);
    const auto found = std::ranges::find(ships, key, &LinkShip::key);
    return found == ships.end() ? std::nullopt : std::optional(*found);
}

} // namespace berg
