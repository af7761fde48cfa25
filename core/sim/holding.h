#pragma once

#include "core/vehicle/safety_guard.h"

namespace berg {

// Holding patterns: circles over ground, in wind too.

/** Returns the unit vector of the course over ground. */
[[nodiscard]] Point aheadOf(const DubinsState& pose, const Motion& motion);

/**
 * Returns the centre of the circle over ground (`circleOverGround_m`) tangent to the course; `side`
 * is 1 for left, -1 for right.
 */
[[nodiscard]] Point middleBeside_m(const DubinsState& pose, const Motion& motion, double side);

/**
 * Returns the turn rate of a UAV that circles `middle_m`, rad/s: after one command the circle
 * tangent to the course is centred there again, as far as the displacement along the course is
 * concerned. The turn itself carries the displacement across it.
 */
[[nodiscard]] double holdingRate_radps(const SafetyGuard& guard, const DubinsState& pose,
                                       const Point& middle_m, double side);

/**
 * Returns the radius of a disc that the UAV does not leave while it holds, from any course, m. It
 * exceeds the circle because held commands do not follow the circle exactly in wind.
 */
[[nodiscard]] double holdingRadius_m(const SafetyGuard& guard);

} // namespace berg
