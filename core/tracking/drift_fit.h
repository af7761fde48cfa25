#pragma once

#include "core/base/geometry.h"
#include "core/tracking/drift.h"

#include <span>

namespace berg {

/** One time-stamped position of an iceberg. */
struct Fix
{
    double time_s = 0; ///< on any clock
    Point position_m = Point::Zero();
    double variance_m2 = 0; ///< of the position along an axis; 0: exact or not known
    bool operator==(const Fix&) const = default;
};

/** What is known of an iceberg at the last of its fixes. */
struct DriftFit
{
    Point position_m = Point::Zero();
    Point velocity_mps = Point::Zero();
    DriftVariances variances;
    double q_m2ps = 0;
};

/**
 * Position and velocity at the last of these fixes, times rising and at least one: the Kalman
 * filter of the process, from a velocity that is its mean give or take its spread. With
 * `mostGrowth_m2ps` above 0, q is that of the greatest likelihood of the fixes, up to it (Harvey
 * 1989, Forecasting, Structural Time Series Models and the Kalman Filter, section 3.4: prediction
 * errors), else that of the process. Of more than a thousand fixes so many, evenly chosen, are
 * used. Cost: some fifty filters of those.
 */
[[nodiscard]] DriftFit fitDrift(std::span<const Fix> fixes, const DriftProcess& process,
                                const Point& mean_mps, double mostGrowth_m2ps = 0);

} // namespace berg
