#pragma once

#include "widgets/charts/decimate.h"

#include <array>
#include <vector>

namespace berg {

/**
 * Points ascending in time that grow at their end, with the lowest and the highest of every run of
 * 8, 64 and 512 of them, so that a long series is thinned for a chart without looking at each point
 * of it. Numbers must be finite. About 1.3 times the memory of the points alone.
 */
class TimeSeries
{
public:
    void append(const QPointF& p);

    [[nodiscard]] const std::vector<QPointF>& points() const { return m_points; }

    /**
     * As `decimate`: at most two points for each column and every peak kept, but by way of the
     * runs. Cost: linear in the columns, not in the points.
     */
    [[nodiscard]] QList<QPointF> thinned(const DecimationWindow& window) const;

private:
    static constexpr std::array<std::size_t, 3> kRuns = {8, 64, 512};

    std::vector<QPointF> m_points;
    std::array<std::vector<Extremes>, kRuns.size()> m_runs;
};

} // namespace berg
