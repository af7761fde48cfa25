#include "core/tracking/drift_fit.h"

#include "core/base/error.h"
#include "core/tracking/observer.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace berg {

namespace {

constexpr std::size_t kMostFixes = 1000;
/** Fixes that are exact would make the likelihood infinite. */
constexpr double kLeastVariance_m2 = 1;
// The likelihood is looked at for powers of ten, then narrowed down between the best's neighbours.
constexpr double kLeastGrowth_m2ps = 1e-3;
constexpr double kGridStep = 0.5; ///< of the power
constexpr int kNarrowings = 30;

struct Filtered
{
    Track track;
    double misfit = 0; ///< minus the logarithm of the likelihood, but for a constant
};

Filtered filtered(std::span<const Fix> fixes, const DriftProcess& process, const Point& mean_mps)
{
    const auto variance_m2 = [](const Fix& fix) {
        return std::max(kLeastVariance_m2, fix.variance_m2);
    };
    Filtered at{.track = {.anchor_m = fixes.front().position_m,
                          .anchor_s = fixes.front().time_s,
                          .velocity_mps = mean_mps,
                          .sigma_m2 = variance_m2(fixes.front()),
                          .q_m2ps = process.q_m2ps,
                          .velocity_m2ps2 = process.velocitySpread_mps * process.velocitySpread_mps,
                          .mean_mps = mean_mps,
                          .velocitySpread_mps = process.velocitySpread_mps,
                          .velocityTime_s = process.velocityTime_s}};
    double before_s = fixes.front().time_s;
    for (const Fix& fix : fixes.subspan(1)) {
        at.track.grow(fix.time_s - before_s);
        before_s = fix.time_s;
        const double spread_m2 = at.track.sigma_m2 + variance_m2(fix);
        const Point off_m = fix.position_m - at.track.estimate_m(fix.time_s);
        at.misfit += std::log(spread_m2) + off_m.squaredNorm() / (2 * spread_m2); // both axes
        at.track.measured(fix.position_m, variance_m2(fix), fix.time_s);
    }
    return at;
}

/** Least of `misfit` between two powers of ten: golden section. */
template <class Misfit>
double narrowed(double low, double high, const Misfit& misfit)
{
    const double share = 1 / std::numbers::phi;
    double a = high - share * (high - low);
    double b = low + share * (high - low);
    double atA = misfit(a);
    double atB = misfit(b);
    for (int i = 0; i < kNarrowings; ++i)
        if (atA < atB) {
            high = b;
            b = a;
            atB = atA;
            atA = misfit(a = high - share * (high - low));
        } else {
            low = a;
            a = b;
            atA = atB;
            atB = misfit(b = low + share * (high - low));
        }
    return (low + high) / 2;
}

double likeliestGrowth_m2ps(std::span<const Fix> fixes, DriftProcess process, const Point& mean_mps,
                            double most_m2ps)
{
    const auto misfit = [&](double power) {
        process.q_m2ps = std::min(most_m2ps, std::pow(10, power));
        return filtered(fixes, process, mean_mps).misfit;
    };
    const double last = std::log10(most_m2ps);
    double best = std::log10(kLeastGrowth_m2ps);
    double least = misfit(best);
    for (double power = best + kGridStep; power <= last; power += kGridStep)
        if (const double at = misfit(power); at < least) {
            least = at;
            best = power;
        }
    best = narrowed(best - kGridStep, std::min(last, best + kGridStep), misfit);
    process.q_m2ps = 0;
    return filtered(fixes, process, mean_mps).misfit <= misfit(best)
               ? 0
               : std::min(most_m2ps, std::pow(10, best));
}

} // namespace

DriftFit fitDrift(std::span<const Fix> fixes, const DriftProcess& process, const Point& mean_mps,
                  double mostGrowth_m2ps)
{
    require(!fixes.empty(), "fitDrift: no fix");
    std::vector<Fix> used;
    const std::size_t stride = (fixes.size() - 1) / kMostFixes + 1;
    for (std::size_t i = (fixes.size() - 1) % stride; i < fixes.size(); i += stride)
        used.push_back(fixes[i]);
    DriftProcess fitted = process;
    if (mostGrowth_m2ps > 0)
        fitted.q_m2ps = likeliestGrowth_m2ps(used, process, mean_mps, mostGrowth_m2ps);
    const Track track = filtered(used, fitted, mean_mps).track;
    return {.position_m = track.estimate_m(used.back().time_s),
            .velocity_mps = track.velocity_mps,
            .variances = track.variances(),
            .q_m2ps = fitted.q_m2ps};
}

} // namespace berg
