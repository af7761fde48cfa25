#pragma once

#include "core/scenario/scenario.h"
#include "core/tracking/closest_approach.h"

namespace berg {

/** Time ahead in which the closest approach of an iceberg to an asset is computed, s. */
inline constexpr double kApproachHorizon_s = 3600;

/**
 * Returns position and velocity of the iceberg relative to the asset at `time_s`. The asset's
 * position is the one at the start of the run.
 */
[[nodiscard]] RelativeMotion relativeToAsset(const Asset& asset, double time_s,
                                             const Point& iceberg_m, const Point& velocity_mps);

/**
 * Returns the factor of sigma in planning (zeta stays unweighted): 1 + gain exp(-(d / range)^2)
 * with d the least distance between asset and iceberg within `kApproachHorizon_s` from now.
 */
[[nodiscard]] double priority(const Asset& asset, const RelativeMotion& motion);

/**
 * Returns the radius of the inner ring, which raises alarms: `alarm_m`, or half the range if that
 * is 0.
 */
[[nodiscard]] double alarmRadius_m(const Asset& asset);

} // namespace berg
