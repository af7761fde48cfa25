#include "core/tracking/drift_fit.h"

#include "core/base/error.h"
#include "core/tracking/observer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace berg {

namespace {

constexpr std::size_t kMostFixes = 1000;
/** Exact fixes would make the likelihood infinite. */
constexpr double kLeastVariance_m2 = 1;
// The likelihood is computed for powers of ten, then narrowed down between the best one's
// neighbours.
constexpr double kLeastGrowth_m2ps = 1e-3;
constexpr double kGridStep = 0.5; ///< step of the exponent
constexpr int kNarrowings = 30;
/** 99.9 % point of chi-square with 2 degrees of freedom: -2 ln 0.001. */
constexpr double kContradiction = 13.815510557964274;

struct Filtered
{
    Track track;
    double misfit = 0; ///< negative log-likelihood, up to a constant
};

/** Combines the track with a velocity measured at its anchor. */
void measureVelocity(Track& track, const Point& velocity_mps, double variance_m2ps2)
{
    const double innovation_m2ps2 = track.velocity_m2ps2 + variance_m2ps2;
    if (!(innovation_m2ps2 > 0))
        return;
    const Point off_mps = velocity_mps - track.velocity_mps;
    const double positionGain_s = track.mixed_m2ps / innovation_m2ps2;
    track.anchor_m += positionGain_s * off_mps;
    track.velocity_mps += track.velocity_m2ps2 / innovation_m2ps2 * off_mps;
    track.sigma_m2 = std::max(0.0, track.sigma_m2 - positionGain_s * track.mixed_m2ps);
    track.velocity_m2ps2 *= variance_m2ps2 / innovation_m2ps2;
    track.mixed_m2ps *= variance_m2ps2 / innovation_m2ps2;
}

Filtered filtered(std::span<const Fix> fixes, const DriftProcess& process, const Point& mean_mps,
                  const Fix* stating = nullptr)
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
    const auto combineStated = [&](const Fix& fix) {
        if (&fix == stating)
            measureVelocity(at.track, *fix.drift_mps, fix.driftVariance_m2ps2);
    };
    combineStated(fixes.front());
    double before_s = fixes.front().time_s;
    for (const Fix& fix : fixes.subspan(1)) {
        at.track.grow(fix.time_s - before_s);
        before_s = fix.time_s;
        const double spread_m2 = at.track.sigma_m2 + variance_m2(fix);
        const Point off_m = fix.position_m - at.track.estimate_m(fix.time_s);
        // sum over both axes
        at.misfit += std::log(spread_m2) + off_m.squaredNorm() / (2 * spread_m2);
        at.track.measured(fix.position_m, variance_m2(fix), fix.time_s);
        combineStated(fix);
    }
    return at;
}

/** Returns the latest fix that states a drift, or null if none does. */
const Fix* latestStated(std::span<const Fix> fixes)
{
    const Fix* latest = nullptr;
    for (const Fix& fix : fixes)
        if (fix.drift_mps)
            latest = &fix;
    return latest;
}

/** Returns the power of ten between two others with the least misfit (golden section). */
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

/** Applies the test of contradiction described at `fitDrift`. */
bool contradicts(const Track& without, const Track& with, double spread_mps)
{
    const bool isDetermined = without.velocity_m2ps2 < spread_mps * spread_mps / 2;
    const double change_m2ps2 = (with.velocity_mps - without.velocity_mps).squaredNorm();
    return isDetermined &&
           change_m2ps2 > kContradiction * (without.velocity_m2ps2 - with.velocity_m2ps2);
}

} // namespace

DriftFit fitDrift(std::span<const Fix> fixes, const DriftProcess& process, const Point& mean_mps,
                  double mostGrowth_m2ps)
{
    require(!fixes.empty(), "fitDrift: no fix");
    std::vector<Fix> used;
    const std::size_t stride = (fixes.size() - 1) / kMostFixes + 1;
    const Fix* const stated = latestStated(fixes);
    for (std::size_t i = 0; i < fixes.size(); ++i)
        if ((fixes.size() - 1 - i) % stride == 0 || &fixes[i] == stated)
            used.push_back(fixes[i]);
    DriftProcess fitted = process;
    if (mostGrowth_m2ps > 0)
        fitted.q_m2ps = likeliestGrowth_m2ps(used, process, mean_mps, mostGrowth_m2ps);
    Track track = filtered(used, fitted, mean_mps).track;
    DriftUse use = DriftUse::NotStated;
    if (const Fix* const stating = latestStated(used)) {
        const Track combined = filtered(used, fitted, mean_mps, stating).track;
        use = contradicts(track, combined, process.velocitySpread_mps) ? DriftUse::Contradicted
                                                                       : DriftUse::Combined;
        if (use == DriftUse::Combined)
            track = combined;
    }
    return {.position_m = track.estimate_m(used.back().time_s),
            .velocity_mps = track.velocity_mps,
            .variances = track.variances(),
            .q_m2ps = fitted.q_m2ps,
            .stated = use};
}

} // namespace berg
