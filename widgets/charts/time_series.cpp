#include "widgets/charts/time_series.h"

#include <algorithm>

namespace berg {

void TimeSeries::append(const QPointF& p)
{
    for (std::size_t k = 0; k < kRuns.size(); ++k) {
        if (m_points.size() % kRuns[k] == 0)
            m_runs[k].push_back({.lowest = p, .highest = p});
        else
            m_runs[k].back().include(p);
    }
    m_points.push_back(p);
}

QList<QPointF> TimeSeries::thinned(const DecimationWindow& window) const
{
    const auto byTime = [](const QPointF& p, double time) { return p.x() < time; };
    const auto begin = std::lower_bound(m_points.begin(), m_points.end(), window.from, byTime);
    const auto end = std::upper_bound(begin, m_points.end(), window.to,
                                      [](double time, const QPointF& p) { return time < p.x(); });
    // One neighbour on either side is included, so that lines reach the edges of the view.
    const auto first = static_cast<std::size_t>(std::max(begin - m_points.begin() - 1, {}));
    const auto last = std::min(static_cast<std::size_t>(end - m_points.begin()) + 1, //
                               m_points.size());

    std::size_t level = kRuns.size();
    while (level > 0 &&
           (last - first) / kRuns[level - 1] < static_cast<std::size_t>(window.columns))
        --level;
    const std::span<const QPointF> all(m_points);
    if (level == 0)
        return decimate(all.subspan(first, last - first), window);

    const std::size_t run = kRuns[level - 1];
    std::vector<QPointF> some;
    some.reserve(2 * (last - first) / run + 2 * run);
    for (std::size_t i = first; i < last;) {
        // The ends of the view are added point by point.
        if (i % run != 0 || i == first || i + run >= last) {
            some.push_back(all[i++]);
            continue;
        }
        const Extremes& extremes = m_runs[level - 1][i / run];
        const bool rising = extremes.lowest.x() <= extremes.highest.x();
        some.push_back(rising ? extremes.lowest : extremes.highest);
        if (extremes.lowest != extremes.highest)
            some.push_back(rising ? extremes.highest : extremes.lowest);
        i += run;
    }
    return decimate(some, window);
}

} // namespace berg
