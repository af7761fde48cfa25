#pragma once

#include "core/scenario/scenario.h"
#include "core/tracking/closest_approach.h"

namespace berg {

/** So far ahead the way of an iceberg past an asset is looked at. */
inline constexpr double kApproachHorizon_s = 3600;

/** The iceberg as seen from the asset; the asset's position is that of the start of the run. */
[[nodiscard]] RelativeMotion relativeToAsset(const Asset& asset, double time_s,
                                             const Point& iceberg_m, const Point& velocity_mps);

/**
 * What multiplies sigma in planning (zeta stays unweighted): 1 + gain exp(-(d / range)^2), d the
 * least distance between asset and iceberg from now until `kApproachHorizon_s`.
 */
[[nodiscard]] double priority(const Asset& asset, const RelativeMotion& motion);

/** Inside this an iceberg is an alarm: `alarm_m`, half the range where that is not set. */
[[nodiscard]] double alarmRadius_m(const Asset& asset);

} // namespace berg
