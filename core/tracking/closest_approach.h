#pragma once

#include "core/geometry/geometry.h"

#include <optional>

namespace berg {

/** Position and velocity of one body relative to another, both on straight courses. */
struct RelativeMotion
{
    Point offset_m = Point::Zero(); ///< present position relative to the other body
    Point velocity_mps = Point::Zero();
};

/** Time and distance of the closest approach of two bodies. */
struct ClosestApproach
{
    double time_s = 0; ///< time from now; the earliest if the distance stays the same
    double distance_m = 0;
};

/** Returns the closest approach within `horizon_s` from now. */
[[nodiscard]] ClosestApproach closestApproach(const RelativeMotion& motion, double horizon_s);

/**
 * Returns the first time, s from now, at which the distance is `radius_m` or less; 0 if it is so
 * now. Returns nullopt if that does not happen within the horizon.
 */
[[nodiscard]] std::optional<double> entryTime_s(const RelativeMotion& motion, double radius_m,
                                                double horizon_s);

} // namespace berg
