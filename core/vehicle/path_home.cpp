#include "core/vehicle/path_home.h"

#include "core/vehicle/side_turn.h"

#include <algorithm>
#include <cmath>

namespace berg {

std::optional<Path> pathTo(const DubinsState& start, const MovingPlace& place, const Motion& motion,
                           double command_s)
{
    if ((motion.wind_mps - place.drift_mps).norm() >= motion.airspeed_mps)
        return std::nullopt;
    const Point ahead(std::cos(start.psi_rad), std::sin(start.psi_rad));
    const double nearSide = cross(ahead, place.place_m - start.position_m) >= 0 ? 1 : -1;
    const std::optional<Path> path = SideTurn(start, place, motion, command_s, nearSide).find();
    const SideTurn farTurn(start, place, motion, command_s, -nearSide);
    const std::optional<Path> other = path ? farTurn.find(path->time_s) : farTurn.find();
    return other && (!path || other->time_s < path->time_s) ? other : path;
}

double longestPath_s(const DubinsState& start, const Point& place_m, const Motion& motion,
                     double command_s)
{
    const double wind_mps = motion.wind_mps.norm();
    const double turn_s = kMostTurn_rad / motion.limit_radps + command_s;
    // The turn may end this far from here; flight times obey the triangle inequality.
    const double astray_m = 2 * motion.airspeed_mps / motion.limit_radps +
                            motion.airspeed_mps * command_s + wind_mps * turn_s;
    return turn_s + astray_m / (motion.airspeed_mps - wind_mps) +
           flightTime_s(place_m - start.position_m, motion.airspeed_mps, motion.wind_mps);
}

double turnRateOf(const Path& path, const Motion& motion, double command_s)
{
    return std::clamp(path.turn_rad / command_s, -motion.limit_radps, motion.limit_radps);
}

} // namespace berg
