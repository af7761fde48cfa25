#include "core/tracking/wind_drift.h"

#include "core/base/angles.h"

#include <cmath>

namespace berg {

Point currentTo_mps(double speed_mps, double to_deg)
{
    const double to_rad = radFromDeg(to_deg);
    return speed_mps * Point(std::sin(to_rad), std::cos(to_rad));
}

Point windFrom_mps(double speed_mps, double from_deg)
{
    return -currentTo_mps(speed_mps, from_deg);
}

double directionTo_deg(const Point& velocity_mps)
{
    if (velocity_mps == Point::Zero())
        return 0;
    return headingFromPsi(std::atan2(velocity_mps.y(), velocity_mps.x()));
}

double windShare(const IcebergDimensions& dimensions, const DragCoefficients& drag)
{
    const double k = drag.air_kgpm3 * drag.air * dimensions.sail_m2 /
                     (drag.water_kgpm3 * drag.water * dimensions.keel_m2);
    return std::sqrt(k) / (1 + std::sqrt(k));
}

DriftLaw driftLaw(double length_m, const DragCoefficients& drag)
{
    if (length_m < kShortestIceberg_m)
        return kSmallIceDrift;
    const double share = windShare(dimensionsOfLength(length_m), drag);
    return {.currentShare = 1 - share, .windShare = share};
}

Point driftVelocity_mps(const DriftLaw& law, const Forcing& forcing, double latitude_deg)
{
    const double left_rad = radFromDeg(latitude_deg < 0 ? law.turn_deg : -law.turn_deg);
    return law.currentShare * forcing.current_mps +
           law.windShare * turned(forcing.wind_mps, left_rad);
}

} // namespace berg
