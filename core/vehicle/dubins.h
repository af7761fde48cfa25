#pragma once

#include "core/base/geometry.h"

namespace berg {

/** Position and course angle psi (from the x = east axis, counter-clockwise), Eq. (15). */
struct DubinsState
{
    Point position_m = Point::Zero();
    double psi_rad = 0;
    bool operator==(const DubinsState&) const = default;
};

/**
 * One step of Eq. (15) with constant turn rate `u_radps` (mid-point course) in air that moves with
 * `wind_mps` over ground. Psi stays in [-pi, pi].
 */
[[nodiscard]] DubinsState step(const DubinsState& state, double airspeed_mps, double u_radps,
                               double dt_s, const Point& wind_mps);

/**
 * Time to fly straight over `displacement_m` (over ground) at airspeed U in wind W, seconds:
 * d / (w_par + sqrt(U^2 - w_n^2)); 0 at d = 0. Needs |W| < U.
 */
[[nodiscard]] double flightTime_s(const Point& displacement_m, double airspeed_mps,
                                  const Point& wind_mps);

} // namespace berg
