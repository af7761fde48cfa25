#include "core/tracking/closest_approach.h"

#include <algorithm>
#include <cmath>

namespace berg {

ClosestApproach closestApproach(const RelativeMotion& motion, double horizon_s)
{
    const double speed2 = motion.velocity_mps.squaredNorm();
    const double when_s = speed2 > 0 ? -motion.offset_m.dot(motion.velocity_mps) / speed2 : 0;
    const double time_s = std::clamp(when_s, 0.0, horizon_s);
    return {.time_s = time_s,
            .distance_m = (motion.offset_m + motion.velocity_mps * time_s).norm()};
}

std::optional<double> entryTime_s(const RelativeMotion& motion, double radius_m, double horizon_s)
{
    if (motion.offset_m.norm() <= radius_m)
        return 0;
    const double speed_mps = motion.velocity_mps.norm();
    if (!(speed_mps > 0))
        return std::nullopt;
    // Along the relative course: `ahead_m` until abeam, then half a chord back.
    const Point along = motion.velocity_mps / speed_mps;
    const double ahead_m = -motion.offset_m.dot(along);
    const double miss_m = std::abs(cross(along, motion.offset_m));
    if (ahead_m <= 0 || miss_m > radius_m)
        return std::nullopt;
    const double entry_s = (ahead_m - std::sqrt(radius_m * radius_m - miss_m * miss_m)) / speed_mps;
    return entry_s <= horizon_s ? std::optional(entry_s) : std::nullopt;
}

} // namespace berg
