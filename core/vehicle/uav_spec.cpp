#include "core/vehicle/uav_spec.h"

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

} // namespace berg
