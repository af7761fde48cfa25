#include "core/vehicle/dubins.h"

#include "core/base/angles.h"

#include <cmath>

namespace berg {

DubinsState step(const DubinsState& state, double airspeed_mps, double u_radps, double dt_s,
                 const Point& wind_mps)
{
    const double middle_rad = state.psi_rad + u_radps * dt_s / 2;
    const Point air_mps(airspeed_mps * std::cos(middle_rad), airspeed_mps * std::sin(middle_rad));
    return {.position_m = state.position_m + (air_mps + wind_mps) * dt_s,
            .psi_rad = wrapPi(state.psi_rad + u_radps * dt_s)};
}

double flightTime_s(const Point& displacement_m, double airspeed_mps, const Point& wind_mps)
{
    const double distance_m = displacement_m.norm();
    if (distance_m == 0)
        return 0;
    const Point along = displacement_m / distance_m;
    const double par_mps = along.dot(wind_mps);
    const double across_mps = cross(along, wind_mps);
    return distance_m /
           (par_mps + std::sqrt(airspeed_mps * airspeed_mps - across_mps * across_mps));
}

} // namespace berg
