#include "core/io/mission_items.h"

#include "core/io/export_numbers.h"
#include "core/io/visits.h"
#include "core/sim/clusters.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

/** Largest radius of 8 bits; above it ArduPlane counts in steps. */
constexpr double kLargestByte_m = 255;
constexpr double kRadiusStep_m = 10;

/** p1 0: airspeed (1 is ground speed); p3 -1: throttle unchanged. */
MavItem changeSpeed(double airspeed_mps)
{
    return {.command = MavCommand::DoChangeSpeed,
            .frame = MavFrame::Mission,
            .params = {0, airspeed_mps, -1, 0},
            .place = {},
            .altitude_m = 0};
}

} // namespace

double acceptanceRadius_m(const Scenario& scenario, double spread_m)
{
    const double seen_m =
        surelySeen_m({.fov_m = scenario.uavs.at(0).fov_m, .shape = scenario.fovShape});
    return std::clamp(std::floor(scenario.reachRadius_m.value_or(seen_m) - spread_m), 1.0,
                      kLargestByte_m);
}

double loiterRadius_m(const Scenario& scenario)
{
    const UavSpec& spec = scenario.uavs.at(0).spec;
    const double faster = 1 + scenario.wind_mps.norm() / spec.airspeed_mps;
    const double least_m = std::ceil(turnRadius_m(spec) * faster * faster);
    return least_m <= kLargestByte_m ? std::max(1.0, least_m)
                                     : std::ceil(least_m / kRadiusStep_m) * kRadiusStep_m;
}

MavMission mavMission(const ExportSource& source)
{
    const Uav& uav = source.scenario.uavs.at(0);
    const LocalFrame frame(source.scenario.origin);
    const auto place = [&](const Point& position_m) {
        return roundedPlace(frame.toGeographic(position_m));
    };
    MavMission mission{.home = place(uav.home_m.value_or(uav.position_m)),
                       .airspeed_mps = uav.spec.airspeed_mps,
                       .items = {changeSpeed(uav.spec.airspeed_mps)}};
    // Param 4, the yaw at a waypoint, is 0 and not "none": a fixed wing ignores it, and Mission
    // Planner reads numbers only.
    MavItem loiter{.command = MavCommand::NavLoiterUnlimited,
                   .params = {0, 0, loiterRadius_m(source.scenario), 0},
                   .place = mission.home,
                   .altitude_m = uav.spec.altitude_m};
    for (const Visit& visit : visitsOf(source)) {
        loiter.place = place(visit.position_m);
        if (visit.iceberg >= 0)
            mission.items.push_back(
                {.command = MavCommand::NavWaypoint,
                 .params = {0, acceptanceRadius_m(source.scenario, visit.spread_m), 0, 0},
                 .place = loiter.place,
                 .altitude_m = uav.spec.altitude_m});
    }
    mission.items.push_back(loiter);
    return mission;
}

} // namespace berg
