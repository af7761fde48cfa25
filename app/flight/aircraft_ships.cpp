#include "app/flight/aircraft_controller.h"
#include "app/layout/panels.h"
#include "widgets/map/paint/graticule.h"
#include "widgets/sightings/flight_sightings.h"
#include "widgets/workspace/workspace.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

constexpr double kDeviation_m = 50;
constexpr double kDeviation_mps = 0.5;
constexpr double kPause_s = 10;
constexpr double kSamePad_m = 200; ///< homes this near to the first one keep their distance to it

/** Returns the position of a ship now, at the speed and course that it reported. */
Point placeNow_m(const DubinsState& pose, const LinkShip& ship, double now_s)
{
    return pose.position_m + ship.speed_mps * (now_s - ship.received_s) *
                                 Point(std::cos(pose.psi_rad), std::sin(pose.psi_rad));
}

} // namespace

/** Each move costs a plan, so that small deviations wait. */
void AircraftController::followAssetShip()
{
    const LinkStatus& status = workspace().link().status();
    const std::optional<LinkShip> ship = shipOf(status, m_assetShip.ship);
    const bool inFlight = workspace().inFlight();
    const std::optional<Asset>& asset =
        inFlight ? workspace().record().now.asset : workspace().document().scenario().asset;
    if (!ship || !asset || status.now_s - m_assetShip.moved_s < kPause_s)
        return;
    const DubinsState pose = poseAt(ship->place, ship->course_rad.value_or(0));
    const Point velocity_mps =
        ship->speed_mps * Point(std::cos(pose.psi_rad), std::sin(pose.psi_rad));
    const Point place_m = placeNow_m(pose, *ship, status.now_s);
    const double now_s = inFlight ? workspace().record().now.time_s : 0;
    if ((asset->position_m + now_s * asset->velocity_mps - place_m).norm() < kDeviation_m &&
        (asset->velocity_mps - velocity_mps).norm() < kDeviation_mps)
        return;
    m_assetShip.moved_s = status.now_s;
    workspace().setAssetMotion(place_m, velocity_mps);
}

std::vector<Point> AircraftController::homes_m() const
{
    const std::vector<Uav>& uavs = workspace().document().scenario().uavs;
    std::vector<Point> homes_m;
    for (const Uav& uav : uavs)
        homes_m.push_back(uav.home_m.value_or(uav.position_m));
    const std::vector<Point>& inFlight_m = workspace().record().now.homes_m;
    if (workspace().inFlight() && inFlight_m.size() == homes_m.size())
        return inFlight_m;
    return homes_m;
}

/**
 * Moves home in steps. Between them, and for plans, it stands still: the endurance must cover the
 * distance that the ship sails meanwhile.
 */
void AircraftController::followHomeShip()
{
    const LinkStatus& status = workspace().link().status();
    const std::optional<LinkShip> ship = shipOf(status, m_homeShip.ship);
    if (!ship || status.now_s - m_homeShip.moved_s < kPause_s)
        return;
    const DubinsState pose = poseAt(ship->place, ship->course_rad.value_or(0));
    const Point place_m = placeNow_m(pose, *ship, status.now_s);
    const std::vector<Point> now_m = homes_m();
    if (now_m.empty() || (now_m.front() - place_m).norm() < kDeviation_m)
        return;
    m_homeShip.moved_s = status.now_s;
    std::vector<Point> next_m;
    for (const Point& home_m : now_m) {
        const Point offset_m = home_m - now_m.front();
        next_m.push_back(offset_m.norm() <= kSamePad_m ? Point(place_m + offset_m) : place_m);
    }
    workspace().setHomes(next_m);
}

/** The crew takes ice that a radar tracks for a sighting by others. */
void AircraftController::reportIce(std::uint32_t id)
{
    const LinkStatus& status = workspace().link().status();
    for (const TrafficTarget& target : status.traffic)
        if (target.kind == TrafficTarget::Kind::Ice && target.id == id && workspace().inFlight())
            workspace().report(reportsOfIce(workspace().record(), target,
                                            std::max(0.0, status.now_s - target.received_s)));
}

} // namespace berg
