#include "core/study/statistics.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace berg {

double quantile(std::span<const double> sorted, double p)
{
    require(!sorted.empty() && p >= 0 && p <= 1, "quantile: no values, or p outside [0, 1]");
    const double place = p * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(std::floor(place));
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - std::floor(place)) * (sorted[above] - sorted[below]);
}

Summary summarise(std::span<const double> values)
{
    Summary summary;
    summary.n = static_cast<int>(values.size());
    if (values.empty())
        return summary;
    const auto n = static_cast<double>(values.size());
    summary.mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
    if (values.size() > 1) {
        double squares = 0;
        for (const double v : values)
            squares += (v - summary.mean) * (v - summary.mean);
        summary.standardError = std::sqrt(squares / (n - 1) / n);
    }
    std::vector<double> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    summary.median = quantile(sorted, 0.5);
    summary.quartile1 = quantile(sorted, 0.25);
    summary.quartile3 = quantile(sorted, 0.75);
    summary.decile1 = quantile(sorted, 0.1);
    summary.decile9 = quantile(sorted, 0.9);
    return summary;
}

} // namespace berg
