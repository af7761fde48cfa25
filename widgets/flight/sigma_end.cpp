#include "widgets/flight/sigma_end.h"

#include "core/scenario/scenario.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

namespace berg {
namespace {

constexpr double kFar = 8; // multiple of the median from which an iceberg counts as good as lost
constexpr double kLargest_m2 = 1e12;

std::atomic<double> chosenEnd_m2{0}; // 0 without a choice: an atomic optional would need a lock

/**
 * Returns the time of a round tour of all icebergs, s: about 0.7124 sqrt(n A) for many of them
 * (Beardwood, Halton and Hammersley 1959), across the field and back for few.
 */
double tourTime_s(const Scenario& scenario)
{
    Point low_m = scenario.icebergs.front().position_m;
    Point high_m = low_m;
    const auto stretch = [&](const Point& p_m) {
        low_m = low_m.cwiseMin(p_m);
        high_m = high_m.cwiseMax(p_m);
    };
    double together_mps = 0;
    for (const Iceberg& iceberg : scenario.icebergs)
        stretch(iceberg.position_m);
    for (const Uav& uav : scenario.uavs) {
        stretch(uav.position_m);
        together_mps += uav.spec.airspeed_mps;
    }
    const Point size_m = high_m - low_m;
    const double many_m =
        0.7124 * std::sqrt(static_cast<double>(scenario.icebergs.size()) * size_m.x() * size_m.y());
    const double length_m = std::max(many_m, 2 * size_m.norm());
    return together_mps > 0 ? length_m / together_mps : scenario.duration_s;
}

} // namespace

double roundSigmaScale(double sigma_m2)
{
    if (!(sigma_m2 > 0))
        return 1;
    const double decade = std::pow(10.0, std::floor(std::log10(sigma_m2)));
    for (const double step : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0})
        if (sigma_m2 <= step * decade * (1 + 1e-12))
            return step * decade;
    return 10 * decade;
}

double ownSigmaEnd_m2(const Scenario& scenario)
{
    if (scenario.icebergs.empty())
        return roundSigmaScale(Iceberg().sigma0_m2);
    const double unseen_s = std::min(scenario.duration_s, tourTime_s(scenario));
    std::vector<double> sigmas_m2;
    sigmas_m2.reserve(scenario.icebergs.size());
    for (const Iceberg& iceberg : scenario.icebergs) {
        const Track track = initialTrack(iceberg, scenario.observer.model, scenario.current_mps);
        sigmas_m2.push_back(grown(track.variances(), track.process(), unseen_s).position_m2);
    }
    std::ranges::sort(sigmas_m2);
    const double limit_m2 = kFar * sigmas_m2[sigmas_m2.size() / 2];
    return roundSigmaScale(*std::prev(std::ranges::upper_bound(sigmas_m2, limit_m2)));
}

double sigmaEnd_m2(const Scenario& scenario)
{
    const std::optional<double> chosen_m2 = chosenSigmaEnd_m2();
    return chosen_m2 ? *chosen_m2 : ownSigmaEnd_m2(scenario);
}

std::optional<double> chosenSigmaEnd_m2()
{
    const double chosen_m2 = chosenEnd_m2.load();
    return chosen_m2 > 0 ? std::optional(chosen_m2) : std::nullopt;
}

void chooseSigmaEnd(std::optional<double> end_m2)
{
    chosenEnd_m2.store(end_m2.value_or(0));
}

std::optional<double> readSigmaEnd_m2(const QSettings& settings)
{
    const double end_m2 = settings.value(kSigmaEndKey).toDouble();
    return end_m2 > 0 && end_m2 <= kLargest_m2 ? std::optional(end_m2) : std::nullopt;
}

} // namespace berg
