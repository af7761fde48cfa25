#pragma once

#include "core/geometry/geometry.h"

namespace berg {

/** Position (m) and heading psi of a UAV, from the x = east axis, counter-clockwise, Eq. (15). */
struct DubinsState
{
    Point position_m = Point::Zero();
    double psi_rad = 0;
    bool operator==(const DubinsState&) const = default;
};

/**
 * Returns the state one time step `dt_s` later, Eq. (15): constant turn rate `u_radps`, integrated
 * by the mid-point rule, in air that moves with `wind_mps` over ground. Psi is wrapped to [-pi,
 * pi].
 */
[[nodiscard]] DubinsState step(const DubinsState& state, double airspeed_mps, double u_radps,
                               double dt_s, const Point& wind_mps);

/**
 * Returns the time, s, to fly straight over `displacement_m` (over ground) at airspeed U in wind W:
 * d / (w_par + sqrt(U^2 - w_n^2)), and 0 for d = 0. Requires |W| < U.
 */
[[nodiscard]] double flightTime_s(const Point& displacement_m, double airspeed_mps,
                                  const Point& wind_mps);

} // namespace berg
