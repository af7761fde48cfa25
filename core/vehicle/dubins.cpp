#include "core/vehicle/dubins.h"

#include "core/base/angles.h"

#include <cmath>

namespace berg {

double reserve_s(const UavSpec& spec)
{
    constexpr double kPercent = 100;
    return spec.reserve_s.value_or(spec.endurance_s * spec.reservePercent / kPercent);
}

double usableEndurance_s(const UavSpec& spec)
{
    if (spec.endurance_s == 0)
        return 0;
    return spec.endurance_s - reserve_s(spec) - spec.climb_s - spec.landing_s;
}

double maxTurnRate_radps(const UavSpec& spec)
{
    return kGravity_mps2 / spec.airspeed_mps * std::tan(radFromDeg(spec.maxBank_deg));
}

double turnRadius_m(const UavSpec& spec)
{
    return spec.airspeed_mps / maxTurnRate_radps(spec);
}

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
