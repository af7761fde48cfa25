#pragma once

#include "core/vehicle/dubins.h"

#include <algorithm>

namespace berg {

/** Gains of the line-of-sight law. */
struct LosGains
{
    double lookahead_m = 150;  ///< Delta
    double integral_mps = 0.5; ///< k
    double turn_1ps = 1;       ///< turn rate per radian of course error
    bool operator==(const LosGains&) const = default;
};

/** Airspeed and turn limit of a UAV, and the wind it flies in. */
struct Motion
{
    double airspeed_mps = 22;
    double limit_radps = 0.2079; ///< largest turn rate
    Point wind_mps = Point::Zero();
    /** Strongest wind to come; circles and fences leave room for it. */
    double windLimit_mps = 0;

    /** Returns the wind speed that turns must leave room for. */
    [[nodiscard]] double widestWind_mps() const { return std::max(wind_mps.norm(), windLimit_mps); }
};

/**
 * Line-of-sight path following with integral action (Fossen 2011, section 10.3; anti-windup of
 * Caharija et al. 2012). Follows the straight leg from a fixed start to a possibly moving end:
 *
 *    psi_d = chi - atan((e + k y) / Delta),   dy/dt = Delta e / ((e + k y)^2 + Delta^2)
 *
 * with e the cross-track error (positive left of the leg) and y the integral state in seconds,
 * which is frozen while the turn rate saturates and reset on a new leg.
 */
struct LosGuidance
{
    LosGains gains;
    Point start_m = Point::Zero(); ///< start of the leg
    double integral_s = 0;         ///< y, in seconds

    /** Starts a leg at `from_m` and resets the integral. */
    void startLeg(const Point& from_m);

    /** Command of one time step. */
    struct Command
    {
        double u_radps = 0;      ///< within the limit
        double crossTrack_m = 0; ///< e
        double course_rad = 0;   ///< psi_d, desired course over ground
        bool passedEnd = false;  ///< the UAV is beyond the end, along the leg
    };

    /**
     * Returns the command for this time step and advances the integral by `dt_s`. In wind, psi_d is
     * a course over ground that is held with a crab angle.
     */
    [[nodiscard]] Command steer(const DubinsState& state, const Point& end_m, const Motion& motion,
                                double dt_s);

    bool operator==(const LosGuidance&) const = default;
};

/**
 * Returns the turn rate, rad/s and within the limit, that steers to the course `course_rad` over
 * ground: gain times the error of the heading psi = course + crab angle asin(-w_n / U).
 */
[[nodiscard]] double turnRateForCourse(double psi_rad, double course_rad, const Motion& motion,
                                       double gain_1ps);

} // namespace berg
