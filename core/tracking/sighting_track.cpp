#include "core/tracking/sighting_track.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace berg {

namespace {

using Indices = std::vector<std::size_t>;

/** Number of rival chains followed at once; the shortest gives way to a newer one. */
constexpr std::size_t kMostChains = 8;

/**
 * Sorts the fixes by time and keeps the last given of each time; leaves out values that are not
 * finite.
 */
Indices byTime(std::span<const Fix> fixes, std::size_t& repeated)
{
    Indices order(fixes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::erase_if(order, [&](std::size_t i) {
        return !std::isfinite(fixes[i].time_s) || !fixes[i].position_m.allFinite();
    });
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return fixes[a].time_s < fixes[b].time_s;
    });
    Indices single;
    for (const std::size_t i : order) {
        if (!single.empty() && fixes[single.back()].time_s == fixes[i].time_s) {
            single.back() = i;
            ++repeated;
        } else {
            single.push_back(i);
        }
    }
    return single;
}

bool canFollow(const Fix& before, const Fix& after, const TrackRules& rules)
{
    const double reach_m = rules.fastest_mps * (after.time_s - before.time_s) + rules.jumpSlack_m;
    return (after.position_m - before.position_m).norm() <= reach_m;
}

/** Returns the longest chain of fixes each of which can follow the one before. */
Indices longestChain(std::span<const Fix> fixes, const Indices& order, const TrackRules& rules)
{
    const auto shorter = [](const Indices& a, const Indices& b) { return a.size() < b.size(); };
    std::vector<Indices> chains;
    for (const std::size_t i : order) {
        // The longest chain that fits wins, so that a stray fix cannot draw the track away.
        Indices* best = nullptr;
        for (Indices& chain : chains)
            if (canFollow(fixes[chain.back()], fixes[i], rules) &&
                (best == nullptr || chain.size() > best->size()))
                best = &chain;
        if (best != nullptr) {
            best->push_back(i);
            continue;
        }
        if (chains.size() == kMostChains)
            chains.erase(std::min_element(chains.begin(), chains.end(), shorter));
        chains.push_back({i});
    }
    // Among chains of equal length the one that ends last wins.
    const auto longest =
        std::max_element(chains.begin(), chains.end(), [&](const Indices& a, const Indices& b) {
            return a.size() != b.size() ? a.size() < b.size()
                                        : fixes[a.back()].time_s < fixes[b.back()].time_s;
        });
    return longest == chains.end() ? Indices() : std::move(*longest);
}

/** Returns the newest of `order` that lie in the window, or the last two if only one does. */
Indices inWindow(std::span<const Fix> fixes, const Indices& order, const TrackRules& rules)
{
    if (order.empty())
        return order;
    const double end_s = fixes[order.back()].time_s;
    const auto from = std::find_if(order.begin(), order.end(), [&](std::size_t i) {
        return fixes[i].time_s >= end_s - rules.window_s;
    });
    if (order.end() - from >= 2 || from == order.begin())
        return {from, order.end()};
    const auto before = from - 1;
    const bool near = end_s - fixes[*before].time_s <= rules.longestGap_s;
    return {near ? before : from, order.end()};
}

/**
 * Returns whether the fixes of the last `stationaryFor_s`, and the one before, are all in one
 * place.
 */
bool isStationary(std::span<const Fix> fixes, const Indices& order, const TrackRules& rules)
{
    if (rules.stationaryFor_s <= 0 || order.empty())
        return false;
    const double since_s = fixes[order.back()].time_s - rules.stationaryFor_s;
    const auto after = std::find_if(order.begin(), order.end(),
                                    [&](std::size_t i) { return fixes[i].time_s > since_s; });
    if (after == order.begin())
        return false; // the track is too short
    const Indices used = longestChain(fixes, {after - 1, order.end()}, rules);
    if (used.size() < 3 || fixes[used.front()].time_s > since_s)
        return false;
    Point mean_m = Point::Zero();
    for (const std::size_t i : used)
        mean_m += fixes[i].position_m / static_cast<double>(used.size());
    return std::all_of(used.begin(), used.end(), [&](std::size_t i) {
        return (fixes[i].position_m - mean_m).norm() <= rules.stationaryWithin_m;
    });
}

/** Returns q by the formula at `estimateTrack`; requires at least three fixes. */
double growth_m2ps(std::span<const Fix> fixes, const Indices& used, const Point& velocity_mps)
{
    const double span_s = fixes[used.back()].time_s - fixes[used.front()].time_s;
    const double ends_m2 = fixes[used.front()].variance_m2 + fixes[used.back()].variance_m2;
    double residual_m2 = 0;
    double squares_s2 = 0;
    double error_m2 = 0;
    for (std::size_t k = 1; k < used.size(); ++k) {
        const Fix& a = fixes[used[k - 1]];
        const Fix& b = fixes[used[k]];
        const double dt_s = b.time_s - a.time_s;
        residual_m2 += (b.position_m - a.position_m - velocity_mps * dt_s).squaredNorm() / 2;
        squares_s2 += dt_s * dt_s;
        error_m2 += a.variance_m2 + b.variance_m2;
        // The errors of the first and the last fix affect the velocity too.
        const double shared_m2 = (k == 1 ? fixes[used.front()].variance_m2 : 0) +
                                 (k + 1 == used.size() ? fixes[used.back()].variance_m2 : 0);
        error_m2 -= 2 * dt_s / span_s * shared_m2;
    }
    error_m2 += squares_s2 / (span_s * span_s) * ends_m2;
    return std::max(0.0, (residual_m2 - error_m2) / (span_s - squares_s2 / span_s));
}

} // namespace

ConsistentFixes consistentFixes(std::span<const Fix> fixes, const TrackRules& rules)
{
    ConsistentFixes consistent;
    const Indices order = byTime(fixes, consistent.repeated);
    consistent.indices = longestChain(fixes, order, rules);
    consistent.jumped = order.size() - consistent.indices.size();
    return consistent;
}

TrackEstimate estimateTrack(std::span<const Fix> fixes, const TrackRules& rules)
{
    require(!fixes.empty(), "estimateTrack: no fix");
    TrackEstimate estimate;
    // The window comes first: an old part of the track must not affect the present position.
    const Indices order = byTime(fixes, estimate.repeated);
    const Indices window = inWindow(fixes, order, rules);
    const Indices used = longestChain(fixes, window, rules);
    if (used.empty())
        return estimate;
    estimate.last = used.back();
    estimate.used = used.size();
    estimate.jumped = window.size() - used.size();
    for (const std::size_t i : used)
        if (fixes[i].drift_mps)
            estimate.stated = i;
    if (used.size() < 2)
        return estimate;
    if (isStationary(fixes, order, rules)) {
        estimate.stationary = true;
        estimate.velocity_mps = Point(Point::Zero());
        return estimate;
    }
    const bool estimatesGrowth = used.size() >= std::max<std::size_t>(3, rules.fewestForGrowth);
    if (rules.drift.velocitySpread_mps > 0) {
        std::vector<Fix> chosen;
        for (const std::size_t i : used)
            chosen.push_back(fixes[i]);
        estimate.fit = fitDrift(chosen, rules.drift, rules.mean_mps,
                                estimatesGrowth ? rules.largestGrowth_m2ps : 0);
    }
    const Fix& first = fixes[used.front()];
    const Fix& last = fixes[used.back()];
    const Point mean_mps = (last.position_m - first.position_m) / (last.time_s - first.time_s);
    const Point velocity_mps = estimate.fit ? estimate.fit->velocity_mps : mean_mps;
    const double most_mps = rules.largestVelocity_mps;
    const Point clamped_mps = velocity_mps.cwiseMax(-most_mps).cwiseMin(most_mps);
    estimate.velocityClamped = clamped_mps != velocity_mps;
    estimate.velocity_mps = clamped_mps;
    if (!estimatesGrowth)
        return estimate;
    const double q_m2ps =
        estimate.fit ? estimate.fit->q_m2ps : growth_m2ps(fixes, used, velocity_mps);
    estimate.growthClamped = q_m2ps > rules.largestGrowth_m2ps;
    estimate.q_m2ps = std::min(q_m2ps, rules.largestGrowth_m2ps);
    return estimate;
}

RecordedTrack thinned(const RecordedTrack& track, double tolerance_m)
{
    const std::size_t count = track.time_s.size();
    if (count <= 2 || tolerance_m <= 0)
        return track;
    RecordedTrack result;
    const auto add = [&](std::size_t i) {
        result.time_s.push_back(track.time_s[i]);
        result.position_m.push_back(track.position_m[i]);
    };
    const double infinity = std::numeric_limits<double>::infinity();
    const Point slack_m = Point::Constant(tolerance_m / std::numbers::sqrt2);
    // Range of velocities from the last entry kept that pass all later entries within the
    // tolerance.
    Point low_mps = Point::Constant(-infinity);
    Point high_mps = Point::Constant(infinity);
    add(0);
    for (std::size_t i = 1; i < count; ++i) {
        Point path_m = track.position_m[i] - result.position_m.back();
        double dt_s = track.time_s[i] - result.time_s.back();
        const Point velocity_mps = path_m / dt_s;
        if ((velocity_mps.array() < low_mps.array()).any() ||
            (velocity_mps.array() > high_mps.array()).any()) {
            add(i - 1);
            low_mps = Point::Constant(-infinity);
            high_mps = Point::Constant(infinity);
            path_m = track.position_m[i] - result.position_m.back();
            dt_s = track.time_s[i] - result.time_s.back();
        }
        low_mps = low_mps.cwiseMax((path_m - slack_m) / dt_s);
        high_mps = high_mps.cwiseMin((path_m + slack_m) / dt_s);
    }
    add(count - 1);
    return result;
}

} // namespace berg
