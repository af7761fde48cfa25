#include "core/vehicle/path_home.h"

#include "core/vehicle/side_turn.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace berg {

namespace {

/** Returns the side, left 1 or right -1, on which the place lies. */
double sideOf(const Point& place_m, const DubinsState& start)
{
    const Point ahead(std::cos(start.psi_rad), std::sin(start.psi_rad));
    return cross(ahead, place_m - start.position_m) >= 0 ? 1 : -1;
}

/**
 * Returns a bound on the turn to a place at this distance. Seen from afar the required heading
 * turns by less than a third of pi during two thirds of a circle, and one side has at most pi to
 * turn at first.
 */
double longestTurn_rad(double away_m, const Motion& motion, double command_s)
{
    constexpr double kFarTurn_rad = 4 * kPi / 3;
    const double wind_mps = motion.wind_mps.norm();
    const double slowest_mps =
        std::sqrt(motion.airspeed_mps * motion.airspeed_mps - wind_mps * wind_mps);
    const double astray_m =
        (motion.airspeed_mps + wind_mps) * (kFarTurn_rad / motion.limit_radps + command_s);
    const bool isFar = away_m >= astray_m * (2 + wind_mps / slowest_mps);
    return isFar ? kFarTurn_rad : kMostTurn_rad;
}

} // namespace

std::optional<Path> pathTo(const DubinsState& start, const MovingPlace& place, const Motion& motion,
                           double command_s)
{
    if ((motion.wind_mps - place.drift_mps).norm() >= motion.airspeed_mps)
        return std::nullopt;
    const double nearSide = sideOf(place.place_m, start);
    const std::optional<Path> path = SideTurn(start, place, motion, command_s, nearSide).find();
    const SideTurn farTurn(start, place, motion, command_s, -nearSide);
    const std::optional<Path> other = path ? farTurn.find(path->time_s) : farTurn.find();
    return other && (!path || other->time_s < path->time_s) ? other : path;
}

double longestPath_s(const DubinsState& start, const Point& place_m, const Motion& motion,
                     double command_s)
{
    const double wind_mps = motion.wind_mps.norm();
    const Point path_m = place_m - start.position_m;
    const double turn_s =
        longestTurn_rad(path_m.norm(), motion, command_s) / motion.limit_radps + command_s;
    // The turn may end this far from here; flight times obey the triangle inequality.
    const double astray_m = 2 * motion.airspeed_mps / motion.limit_radps +
                            motion.airspeed_mps * command_s + wind_mps * turn_s;
    return turn_s + astray_m / (motion.airspeed_mps - wind_mps) +
           flightTime_s(path_m, motion.airspeed_mps, motion.wind_mps);
}

bool reachesWithin(double left_s, const DubinsState& start, const Point& place_m,
                   const Motion& motion, double command_s)
{
    if (longestPath_s(start, place_m, motion, command_s) <= left_s)
        return true;
    if (flightTime_s(place_m - start.position_m, motion.airspeed_mps, motion.wind_mps) > left_s)
        return false;
    const double nearSide = sideOf(place_m, start);
    return std::ranges::any_of(std::array{nearSide, -nearSide}, [&](double side) {
        const std::optional<Path> path =
            SideTurn(start, {.place_m = place_m}, motion, command_s, side).find(left_s);
        return path && path->time_s <= left_s;
    });
}

double turnRateOf(const Path& path, const Motion& motion, double command_s)
{
    return std::clamp(path.turn_rad / command_s, -motion.limit_radps, motion.limit_radps);
}

} // namespace berg
