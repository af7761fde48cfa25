#pragma once

#include "core/base/geometry.h"

#include <optional>

namespace berg {

/** Where one body is seen from another, both on straight courses. */
struct RelativeMotion
{
    Point offset_m = Point::Zero(); ///< now
    Point velocity_mps = Point::Zero();
};

struct ClosestApproach
{
    double time_s = 0; ///< from now; the earliest, when the distance stays the same
    double distance_m = 0;
};

/** Within [now, horizon_s]. */
[[nodiscard]] ClosestApproach closestApproach(const RelativeMotion& motion, double horizon_s);

/** When the distance first is `radius_m` or less, 0: it is now; none: not within the horizon. */
[[nodiscard]] std::optional<double> entryTime_s(const RelativeMotion& motion, double radius_m,
                                                double horizon_s);

} // namespace berg
