#pragma once

#include "widgets/charts/decimate.h"

#include <array>
#include <vector>

namespace berg {

/**
 * Growing series of points ascending in time, with the extremes of every run of 8, 64 and 512
 * points, so that a long series is thinned for a chart without visiting each point. Values must be
 * finite. Memory: about 1.3 times that of the points.
 */
class TimeSeries
{
public:
    /** Appends a point, not earlier than the last one. */
    void append(const QPointF& p);

    [[nodiscard]] const std::vector<QPointF>& points() const { return m_points; }

    /**
     * Thins as `decimate` does (at most two points per column, every peak kept), but by the runs'
     * extremes. Cost: linear in the columns, not in the points.
     */
    [[nodiscard]] QList<QPointF> thinned(const DecimationWindow& window) const;

private:
    static constexpr std::array<std::size_t, 3> kRuns = {8, 64, 512};

    std::vector<QPointF> m_points;
    std::array<std::vector<Extremes>, kRuns.size()> m_runs;
};

} // namespace berg
