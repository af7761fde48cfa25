#pragma once

#include "core/vehicle/safety_guard.h"

namespace berg {

// Holding: circles over ground, in wind too.

/** Direction of the course over ground. */
[[nodiscard]] Point aheadOf(const DubinsState& pose, const Motion& motion);

/** Middle of the circle over ground tangent to the course; `side`: 1 left, -1 right. */
[[nodiscard]] Point middleBeside_m(const DubinsState& pose, const Motion& motion, double side);

/**
 * Round the middle: the turn rate after which the circle tangent to the course lies there again,
 * but for what lies across the course, which the turn itself takes along.
 */
[[nodiscard]] double holdingRate_radps(const SafetyGuard& guard, const DubinsState& pose,
                                       const Point& middle_m, double side);

/** Of a disc that the UAV does not leave while it holds, from any course: commands that are held do
 * not follow the circle exactly in wind. */
[[nodiscard]] double holdingRadius_m(const SafetyGuard& guard);

} // namespace berg
