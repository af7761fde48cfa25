#include "core/vehicle/wind_series.h"

#include "core/vehicle/dubins.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace berg {

namespace {

constexpr double kNoChange = std::numeric_limits<double>::infinity();

/** Returns the number of the wind that blows at a run time. */
std::size_t entryAtTime(const WindSeries& series, double time_s)
{
    const auto after = std::ranges::upper_bound(series.from_s, time_s) - series.from_s.begin();
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, after) - 1);
}

} // namespace

Point WindAhead::at_mps(double after_s) const
{
    return m_series ? m_series->wind_mps[entryAtTime(*m_series, m_now_s + after_s)]
                    : m_constant_mps;
}

double WindAhead::nextChange_s(double after_s) const
{
    if (!m_series)
        return kNoChange;
    const std::size_t next = entryAtTime(*m_series, m_now_s + after_s) + 1;
    return next < m_series->from_s.size() ? m_series->from_s[next] - m_now_s : kNoChange;
}

WindRange WindAhead::range(double from_s, double until_s) const
{
    const Point first_mps = at_mps(from_s);
    WindRange range{.low_mps = first_mps, .high_mps = first_mps};
    if (!m_series)
        return range;
    const std::size_t last = entryAtTime(*m_series, m_now_s + until_s);
    for (std::size_t i = entryAtTime(*m_series, m_now_s + from_s); i <= last; ++i) {
        range.low_mps = range.low_mps.cwiseMin(m_series->wind_mps[i]);
        range.high_mps = range.high_mps.cwiseMax(m_series->wind_mps[i]);
    }
    return range;
}

Point WindAhead::mean_mps(double duration_s) const
{
    Point sum_m = Point::Zero();
    double time_s = 0;
    while (nextChange_s(time_s) < duration_s) {
        const double next_s = nextChange_s(time_s);
        sum_m += (next_s - time_s) * at_mps(time_s);
        time_s = next_s;
    }
    if (time_s == 0)
        return at_mps(0);
    return (sum_m + (duration_s - time_s) * at_mps(time_s)) / duration_s;
}

double strongest_mps(const WindSeries& series, double from_s, double until_s)
{
    double strongest_mps = 0;
    const std::size_t last = entryAtTime(series, until_s);
    for (std::size_t i = entryAtTime(series, from_s); i <= last; ++i)
        strongest_mps = std::max(strongest_mps, series.wind_mps[i].norm());
    return strongest_mps;
}

double flightTime_s(const Point& displacement_m, double airspeed_mps, const Point& drift_mps,
                    const WindAhead& wind, double from_s)
{
    double left_m = displacement_m.norm();
    if (left_m == 0)
        return 0;
    const Point along = displacement_m / left_m;
    Point whole_m = displacement_m;
    double time_s = from_s;
    for (;;) {
        const Point relative_mps = wind.at_mps(time_s) - drift_mps;
        const double next_s = wind.nextChange_s(time_s);
        if (next_s == kNoChange || relative_mps.norm() < airspeed_mps) {
            const double rest_s = flightTime_s(whole_m, airspeed_mps, relative_mps);
            if (!(time_s + rest_s > next_s)) // also if it is no number
                return time_s == from_s ? rest_s : time_s - from_s + rest_s;
        }
        const double across_mps = cross(along, relative_mps);
        const double ahead2_m2ps2 = airspeed_mps * airspeed_mps - across_mps * across_mps;
        // If the wind is too strong for the course, the UAV is carried back at its speed.
        const double over_mps = along.dot(relative_mps) + std::sqrt(std::max(0.0, ahead2_m2ps2));
        left_m -= over_mps * (next_s - time_s);
        left_m = std::max(left_m, std::numeric_limits<double>::min());
        whole_m = left_m * along;
        time_s = next_s;
    }
}

} // namespace berg
