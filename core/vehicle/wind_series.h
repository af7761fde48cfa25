#pragma once

#include "core/geometry/geometry.h"

#include <memory>
#include <vector>

namespace berg {

/** Wind over ground that changes in steps, in seconds of the run. */
struct WindSeries
{
    std::vector<double> from_s;  ///< times rise; the first wind also blows before the first time
    std::vector<Point> wind_mps; ///< as many as times, at least one; consecutive ones differ
};

/** Componentwise least and greatest wind of a period. */
struct WindRange
{
    Point low_mps = Point::Zero();
    Point high_mps = Point::Zero();
};

/** Wind from now on: constant, or that of a series. Copies share the series. */
class WindAhead
{
public:
    /** Calm. */
    WindAhead() = default;
    /** A constant wind. */
    template <class Derived>
    // NOLINTNEXTLINE(google-explicit-constructor): a constant wind is a wind
    WindAhead(const Eigen::MatrixBase<Derived>& constant_mps) : m_constant_mps(constant_mps)
    {
    }
    /** The wind of a series, which must not be null, from run time `now_s` on. */
    WindAhead(std::shared_ptr<const WindSeries> series, double now_s)
        : m_series(std::move(series)), m_now_s(now_s)
    {
    }

    /** Returns the wind `after_s` >= 0 from now. */
    [[nodiscard]] Point at_mps(double after_s) const;
    /** Returns the time from now of the next change after `after_s`; infinity if there is none. */
    [[nodiscard]] double nextChange_s(double after_s) const;
    /** Returns the range of the wind between two times from now, both included. */
    [[nodiscard]] WindRange range(double from_s, double until_s) const;
    /**
     * Returns the mean of the next `duration_s` > 0; exactly the wind of now if it does not change
     * by then.
     */
    [[nodiscard]] Point mean_mps(double duration_s) const;

private:
    Point m_constant_mps = Point::Zero();
    std::shared_ptr<const WindSeries> m_series; ///< null if the wind is constant
    double m_now_s = 0;
};

/**
 * Returns the strongest wind of a series, m/s, between two run times, both included.
 */
[[nodiscard]] double strongest_mps(const WindSeries& series, double from_s, double until_s);

/**
 * Returns the time, s, to fly straight over `displacement_m` to a place that moves with
 * `drift_mps`, from `from_s` after now on, at an airspeed in a changing wind: the crab angle
 * follows the wind, so that the course is kept, and speeds over ground are summed up. For a wind
 * that does not change by then it is exactly `flightTime_s` of the wind minus the drift.
 * Infinity if the wind never lets the UAV arrive.
 */
[[nodiscard]] double flightTime_s(const Point& displacement_m, double airspeed_mps,
                                  const Point& drift_mps, const WindAhead& wind, double from_s);

} // namespace berg
