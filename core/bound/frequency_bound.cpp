#include "core/bound/frequency_bound.h"

#include "core/bound/patrol_prices.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace berg {

namespace {

/** Slices are no shorter than this. */
constexpr double kShortestSlice_s = 240;
/** The search tries these numbers of slices; the first one that gives no better bound ends it. */
constexpr std::array kSliceCounts{1, 6, 24, 48, 96, 144};
/** Largest number of pairs of icebergs times slices; more would take longer than a second. */
constexpr double kMostPairs = 2e6;
/** Steps of the golden-section search for the scale of mu, and its range. */
constexpr int kScaleSteps = 8;
constexpr double kLeastLogScale = -1.5;
constexpr double kMostLogScale = 0.5;

std::vector<int> growing(const Scenario& scenario)
{
    std::vector<int> icebergs;
    for (std::size_t i = 0; i < scenario.icebergs.size(); ++i)
        if (scenario.icebergs[i].q_m2ps > 0)
            icebergs.push_back(static_cast<int>(i));
    return icebergs;
}

/**
 * Returns the bound with the best scale of mu for the end of the run. A golden-section search finds
 * it because the bound is concave in the scale.
 */
FrequencyBound bestScaled(const PatrolPrices& prices, const std::stop_token& stop)
{
    const double golden = (std::sqrt(5.0) - 1) / 2;
    double low = kLeastLogScale;
    double high = kMostLogScale;
    FrequencyBound best;
    const auto at = [&](double logScale) {
        FrequencyBound bound = prices.bound(std::exp(logScale));
        const double end_m2s = bound.zeta_m2s.back();
        if (best.zeta_m2s.empty() || end_m2s > best.zeta_m2s.back())
            best = std::move(bound);
        return end_m2s;
    };
    double left = high - golden * (high - low);
    double right = low + golden * (high - low);
    double atLeft = at(left);
    double atRight = at(right);
    for (int step = 2; step < kScaleSteps && !stop.stop_requested(); ++step) {
        if (atLeft > atRight) {
            high = right;
            right = left;
            atRight = atLeft;
            left = high - golden * (high - low);
            atLeft = at(left);
        } else {
            low = left;
            left = right;
            atLeft = atRight;
            right = low + golden * (high - low);
            atRight = at(right);
        }
    }
    return best;
}

} // namespace

double FrequencyBound::by_m2s(double time_s) const
{
    const auto after = std::ranges::upper_bound(times_s, time_s);
    return after == times_s.begin()
               ? 0
               : zeta_m2s[static_cast<std::size_t>(after - times_s.begin()) - 1];
}

std::optional<FrequencyBound> frequencyBound(const Scenario& scenario, const TrueMotion& motion,
                                             const std::stop_token& stop)
{
    const std::vector<int> icebergs = growing(scenario);
    if (scenario.observer.model != ObserverModel::Simple || icebergs.size() < 2)
        return std::nullopt;
    const auto n = static_cast<double>(icebergs.size());
    const double end_s = motion.edge_s(motion.blocks());
    std::optional<FrequencyBound> best;
    for (const int slices : kSliceCounts) {
        const bool areShort = end_s / slices < kShortestSlice_s || slices > motion.blocks();
        if ((slices > 1 && areShort) || n * n * slices > kMostPairs)
            break;
        const PatrolPrices prices(scenario, motion, icebergs, slices, stop);
        if (stop.stop_requested())
            return std::nullopt;
        FrequencyBound bound = bestScaled(prices, stop);
        const double known_m2s = best ? best->zeta_m2s.back() : 0;
        if (known_m2s > 0 && bound.zeta_m2s.back() <= known_m2s)
            break;
        best = std::move(bound);
    }
    if (stop.stop_requested())
        return std::nullopt;
    return best;
}

} // namespace berg
