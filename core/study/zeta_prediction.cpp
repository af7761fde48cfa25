#include "core/study/zeta_prediction.h"

#include "core/base/error.h"
#include "core/study/statistics.h"

#include <algorithm>
#include <vector>

namespace berg {

ZetaPrediction predictionOf(std::span<const double> drawn_m2s)
{
    require(!drawn_m2s.empty(), "predictionOf: no flights");
    std::vector<double> sorted_m2s(drawn_m2s.begin(), drawn_m2s.end());
    std::ranges::sort(sorted_m2s);
    return {.mean_m2s = summarise(drawn_m2s).mean,
            .least_m2s = quantile(sorted_m2s, 0.05),
            .most_m2s = quantile(sorted_m2s, 0.95)};
}

std::optional<ZetaPrediction> predictZeta(const Scenario& scenario, const ParallelOptions& options)
{
    std::vector<double> drawn_m2s(kDrawnFlights);
    std::vector<char> isFlown(kDrawnFlights, 0);
    const auto fly = [&](std::size_t flight) {
        const std::optional<double> zeta_m2s = drawnZeta_m2s(
            scenario, scenario.planner.policy, static_cast<int>(flight), options.stop);
        drawn_m2s[flight] = zeta_m2s.value_or(0);
        isFlown[flight] = zeta_m2s ? 1 : 0;
    };
    if (!forEachIndex(drawn_m2s.size(), fly, options) || std::ranges::count(isFlown, 0) > 0)
        return std::nullopt;
    return predictionOf(drawn_m2s);
}

} // namespace berg
