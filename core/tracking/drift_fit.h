#pragma once

#include "core/geometry/geometry.h"
#include "core/tracking/drift.h"

#include <cstdint>
#include <optional>
#include <span>

namespace berg {

/** One time-stamped position of an iceberg. */
struct Fix
{
    double time_s = 0; ///< seconds on any clock
    Point position_m = Point::Zero();
    double variance_m2 = 0; ///< variance of the position along an axis; 0 means exact or unknown
    std::optional<Point> drift_mps; ///< velocity over ground stated by the source for this time
    double driftVariance_m2ps2 = 0; ///< variance of the stated velocity along an axis
    bool operator==(const Fix&) const = default;
};

/** Use of a stated drift in a fit. */
enum class DriftUse : std::uint8_t
{
    NotStated,
    Combined,
    Contradicted ///< the fixes exclude the stated drift, and the fit rests on them alone
};

/** Estimate of position and velocity at the last fix, with variances and q. */
struct DriftFit
{
    Point position_m = Point::Zero();
    Point velocity_mps = Point::Zero();
    DriftVariances variances;
    double q_m2ps = 0;
    DriftUse stated = DriftUse::NotStated;
};

/**
 * Returns position and velocity at the last of at least one fix, times rising: the Kalman filter of
 * the process, started with the mean velocity and its spread. With `mostGrowth_m2ps` above 0, q is
 * the value up to it for which the fixes are most likely (Harvey 1989, Forecasting, Structural Time
 * Series Models and the Kalman Filter, section 3.4: prediction errors), else the q of the process.
 * If there are more than a thousand fixes, at most about a thousand evenly chosen ones are used.
 * Cost: some fifty filter runs over these. Throws `std::logic_error` if there is no fix.
 *
 * The latest drift that a fix states is a measurement of the velocity at its time: filter and drift
 * are combined by their variances, so that a stated drift never makes position or velocity less
 * certain. q is estimated without it. The two contradict each other if the fixes determine the
 * velocity (its variance is below half of the squared spread) and the drift would move it by more
 * than errors do once in a thousand times, |v - v'|^2 / (V - V') > -2 ln 0.001 with v, V without
 * and v', V' with the drift. The stated drift is then not used: positions are measured, whereas a
 * stated drift may have the wrong unit or the opposite direction.
 */
[[nodiscard]] DriftFit fitDrift(std::span<const Fix> fixes, const DriftProcess& process,
                                const Point& mean_mps, double mostGrowth_m2ps = 0);

} // namespace berg
