#pragma once

#include "core/vehicle/dubins.h"

namespace berg {

/** Gains of the line-of-sight law. */
struct LosGains
{
    double lookahead_m = 150;  ///< Delta
    double integral_mps = 0.5; ///< k
    double turn_1ps = 1;       ///< turn rate per radian of course error
    bool operator==(const LosGains&) const = default;
};

/** The air the UAV moves in and how fast it turns there. */
struct Motion
{
    double airspeed_mps = 22;
    double limit_radps = 0.2079; ///< largest turn rate
    Point wind_mps = Point::Zero();
};

/**
 * Line-of-sight path following with integral action (Fossen 2011, section 10.3; anti-windup of
 * Caharija et al. 2012). Follows the straight leg from a fixed start to a possibly moving end:
 *
 *   psi_d = chi - atan((e + k y) / Delta),   dy/dt = Delta e / ((e + k y)^2 + Delta^2)
 *
 * with e the cross-track error (positive left of the leg) and y the integral state in seconds,
 * frozen while the turn rate saturates and zeroed on a new leg.
 */
struct LosGuidance
{
    LosGains gains;
    Point start_m = Point::Zero(); ///< where the leg starts
    double integral_s = 0;         ///< y, in seconds

    void startLeg(const Point& from_m);

    struct Command
    {
        double u_radps = 0;      ///< within the limit
        double crossTrack_m = 0; ///< e
        double course_rad = 0;   ///< psi_d, the course over ground wanted
        bool passedEnd = false;  ///< the UAV is beyond the end, along the leg
    };

    /**
     * Turn rate for this step; advances the integral by dt. In wind, psi_d is a course over
     * ground, kept by the crab angle.
     */
    [[nodiscard]] Command steer(const DubinsState& state, const Point& end_m, const Motion& motion,
                                double dt_s);

    bool operator==(const LosGuidance&) const = default;
};

/** Turn rate that holds `course_rad` over ground: heading = course + crab asin(-w_n / U). */
[[nodiscard]] double turnRateForCourse(double psi_rad, double course_rad, const Motion& motion,
                                       double gain_1ps);

} // namespace berg
