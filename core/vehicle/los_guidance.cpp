#include "core/vehicle/los_guidance.h"

#include "core/base/angles.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

double crabAngle_rad(double course_rad, const Motion& motion)
{
    if (motion.wind_mps.isZero(0))
        return 0;
    const Point along(std::cos(course_rad), std::sin(course_rad));
    const double across_mps = cross(along, motion.wind_mps);
    // A cross wind as fast as the UAV cannot be held; pointing into it is the best there is.
    return -std::asin(std::clamp(across_mps / motion.airspeed_mps, -1.0, 1.0));
}

} // namespace

double turnRateForCourse(double psi_rad, double course_rad, const Motion& motion, double gain_1ps)
{
    const double u_radps =
        wrapPi(course_rad + crabAngle_rad(course_rad, motion) - psi_rad) * gain_1ps;
    return std::clamp(u_radps, -motion.limit_radps, motion.limit_radps);
}

void LosGuidance::startLeg(const Point& from_m)
{
    start_m = from_m;
    integral_s = 0;
}

LosGuidance::Command LosGuidance::steer(const DubinsState& state, const Point& end_m,
                                        const Motion& motion, double dt_s)
{
    Command command;
    const Point leg_m = end_m - start_m;
    const double length_m = leg_m.norm();
    // A leg without length has no direction: hold the course that is flown.
    const double chi_rad = length_m > 0 ? std::atan2(leg_m.y(), leg_m.x()) : state.psi_rad;
    const Point along(std::cos(chi_rad), std::sin(chi_rad));
    const Point from_m = state.position_m - start_m;
    command.crossTrack_m = cross(along, from_m);
    command.passedEnd = along.dot(from_m) > length_m;

    const double e_m = command.crossTrack_m;
    const double offset_m = e_m + gains.integral_mps * integral_s;
    command.course_rad = chi_rad - std::atan(offset_m / gains.lookahead_m);
    command.u_radps = turnRateForCourse(state.psi_rad, command.course_rad, motion, gains.turn_1ps);
    const bool saturated = std::abs(command.u_radps) >= motion.limit_radps;
    if (!saturated)
        integral_s += dt_s * gains.lookahead_m * e_m /
                      (offset_m * offset_m + gains.lookahead_m * gains.lookahead_m);
    return command;
}

} // namespace berg
