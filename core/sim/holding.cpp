#include "core/sim/holding.h"

#include "core/base/angles.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace berg {

Point aheadOf(const DubinsState& pose, const Motion& motion)
{
    return (motion.airspeed_mps * Point(std::cos(pose.psi_rad), std::sin(pose.psi_rad)) +
            motion.wind_mps)
        .normalized();
}

Point middleBeside_m(const DubinsState& pose, const Motion& motion, double side)
{
    const Point ahead = aheadOf(pose, motion);
    return pose.position_m + side * circleOverGround_m(motion) * Point(-ahead.y(), ahead.x());
}

double holdingRate_radps(const SafetyGuard& guard, const DubinsState& pose, const Point& middle_m,
                         double side)
{
    const Motion& motion = guard.uav().motion;
    const double limit_radps = motion.limit_radps;
    const auto error_m = [&](double rate_radps) {
        const DubinsState after = guard.heldFor(pose, rate_radps, guard.uav().clock.steps);
        return aheadOf(after, motion).dot(middleBeside_m(after, motion, side) - middle_m);
    };
    constexpr double kNear_m = 1e-6;
    double last_radps = side * limit_radps;
    double rate_radps = 0.9 * last_radps;
    double last_m = error_m(last_radps);
    for (int round = 0; round < 6; ++round) {
        const double now_m = error_m(rate_radps);
        if (std::abs(now_m) < kNear_m || now_m == last_m)
            break;
        const double next_radps =
            std::clamp(rate_radps - now_m * (rate_radps - last_radps) / (now_m - last_m),
                       -limit_radps, limit_radps);
        last_radps = rate_radps;
        last_m = now_m;
        rate_radps = next_radps;
    }
    return rate_radps;
}

double holdingRadius_m(const SafetyGuard& guard)
{
    constexpr int kCourses = 8;
    constexpr double kRounding_m = 0.5;
    const Motion& motion = guard.uav().motion;
    if (motion.windLimit_mps > motion.wind_mps.norm()) { // the disc suits all winds to come
        GuardedUav widest{
            .motion = motion, .sortie = {}, .fence = nullptr, .clock = guard.uav().clock};
        widest.motion.wind_mps = {motion.windLimit_mps, 0};
        widest.motion.windLimit_mps = 0;
        return holdingRadius_m(SafetyGuard(std::move(widest)));
    }
    const double circle_m = circleOverGround_m(motion);
    double radius_m = circle_m;
    if (motion.wind_mps.isZero(0))
        return radius_m + kRounding_m;
    for (int course = 0; course < kCourses; ++course) { // circles to the right are mirror images
        DubinsState pose{.psi_rad = 2 * kPi * course / kCourses};
        const Point middle_m = middleBeside_m(pose, motion, 1);
        const double round_m = 3 * kPi * circle_m;
        for (double flown_m = 0; flown_m < round_m;) {
            const double rate_radps = holdingRate_radps(guard, pose, middle_m, 1);
            for (std::int64_t i = 0; i < guard.uav().clock.steps; ++i) {
                const DubinsState after = guard.heldFor(pose, rate_radps, 1);
                flown_m += (after.position_m - pose.position_m).norm();
                pose = after;
                radius_m = std::max(radius_m, (pose.position_m - middle_m).norm());
            }
        }
    }
    return radius_m + kRounding_m;
}

} // namespace berg
