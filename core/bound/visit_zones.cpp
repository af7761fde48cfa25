#include "core/bound/visit_zones.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace berg {

namespace {

constexpr int kRateSteps = 120;
constexpr int kMostMerges = 6;
/** Groups are merged if that raises their share of the sum by more than this share. */
constexpr double kLeastMergeGain = 0.02;
/**
 * Each group has this number of legs in the programme of rates; all other legs limit the radii at
 * its end.
 */
constexpr std::size_t kLegsPerGroup = 10;
/** Radii are reduced by this share, which exceeds their rounding. */
constexpr double kZoneRounding = 1e-12;

struct Rate
{
    std::size_t a = 0;
    std::size_t b = 0;
    double leg_s = 0;
    double rate = 1;
};

/** Returns the legs from each group to its nearest ones, each leg once. */
std::vector<Rate> nearRates(const std::vector<double>& legs_s, std::size_t n)
{
    std::vector<Rate> rates;
    std::vector<std::size_t> others;
    for (std::size_t a = 0; a < n; ++a) {
        others.clear();
        for (std::size_t b = 0; b < n; ++b)
            if (b != a)
                others.push_back(b);
        const std::size_t near = std::min(kLegsPerGroup, others.size());
        std::partial_sort(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(near),
                          others.end(), [&](std::size_t x, std::size_t y) {
                              const double dx_s = legs_s[a * n + x];
                              const double dy_s = legs_s[a * n + y];
                              return dx_s != dy_s ? dx_s < dy_s : x < y;
                          });
        for (std::size_t k = 0; k < near; ++k)
            rates.push_back({.a = std::min(a, others[k]),
                             .b = std::max(a, others[k]),
                             .leg_s = legs_s[a * n + others[k]]});
    }
    std::ranges::sort(rates, {}, [n](const Rate& rate) { return rate.a * n + rate.b; });
    const auto isSame = [](const Rate& x, const Rate& y) { return x.a == y.a && x.b == y.b; };
    rates.erase(std::unique(rates.begin(), rates.end(), isSame), rates.end());
    return rates;
}

/** Cuts the radii until all legs allow them, then widens each as far as the others leave room. */
void fit(std::vector<double>& radius_s, const std::vector<double>& legs_s)
{
    const std::size_t n = radius_s.size();
    std::vector<double> fitted_s(n);
    for (std::size_t a = 0; a < n; ++a) {
        double share = 1;
        for (std::size_t b = 0; b < n; ++b)
            if (b != a && radius_s[a] + radius_s[b] > legs_s[a * n + b])
                share = std::min(share, legs_s[a * n + b] / (radius_s[a] + radius_s[b]));
        fitted_s[a] = share * radius_s[a];
    }
    for (std::size_t a = 0; a < n; ++a) {
        double room_s = std::numeric_limits<double>::infinity();
        for (std::size_t b = 0; b < n; ++b)
            if (b != a)
                room_s = std::min(room_s, legs_s[a * n + b] - fitted_s[b]);
        fitted_s[a] = std::max(0.0, room_s);
    }
    for (std::size_t a = 0; a < n; ++a)
        radius_s[a] = fitted_s[a] * (1 - kZoneRounding);
}

/** Returns the radii from the programme of rates in `visitZones`. */
std::vector<double> radii_s(const std::vector<double>& growth, const std::vector<double>& legs_s)
{
    const std::size_t n = growth.size();
    std::vector<double> radius_s(n, 0.0);
    if (n < 2)
        return radius_s;
    std::vector<Rate> rates = nearRates(legs_s, n);
    std::erase_if(rates, [](const Rate& rate) { return !(rate.leg_s > 0); });
    double typical_s = 0;
    for (const Rate& rate : rates)
        typical_s += rate.leg_s / static_cast<double>(rates.size());
    for (Rate& rate : rates)
        rate.rate = std::sqrt((growth[rate.a] + growth[rate.b]) / typical_s) / kLegsPerGroup;
    std::vector<double> sum(n);
    for (int step = 0; step <= kRateSteps; ++step) {
        std::ranges::fill(sum, 0.0);
        for (const Rate& rate : rates) {
            sum[rate.a] += rate.rate;
            sum[rate.b] += rate.rate;
        }
        for (std::size_t a = 0; a < n; ++a)
            radius_s[a] = sum[a] > 0 ? growth[a] / (4 * sum[a] * sum[a]) : 0;
        for (Rate& rate : rates)
            rate.rate *= std::sqrt((radius_s[rate.a] + radius_s[rate.b]) / rate.leg_s);
    }
    fit(radius_s, legs_s);
    return radius_s;
}

VisitZones zonesOf(const std::vector<int>& groupOf, const std::vector<double>& growth,
                   const std::vector<double>& legs_s)
{
    VisitZones zones{.groupOf = groupOf, .growth_m2ps = growth};
    zones.radius_s = radii_s(growth, legs_s);
    for (std::size_t g = 0; g < growth.size(); ++g)
        zones.rootSum += std::sqrt(growth[g] * zones.radius_s[g]);
    return zones;
}

/** Two groups whose merger raises the sum of roots. */
struct Merge
{
    double gain = 0;
    std::size_t a = 0;
    std::size_t b = 0;
};

std::vector<Merge> merges(const VisitZones& zones, const std::vector<double>& legs_s)
{
    const std::size_t n = zones.radius_s.size();
    std::vector<Merge> found;
    for (const Rate& pair : nearRates(legs_s, n)) {
        double room_s = std::numeric_limits<double>::infinity();
        for (std::size_t c = 0; c < n; ++c)
            if (c != pair.a && c != pair.b)
                room_s = std::min(room_s, std::min(legs_s[pair.a * n + c], legs_s[pair.b * n + c]) -
                                              zones.radius_s[c]);
        if (!(room_s > 0) || !std::isfinite(room_s))
            continue;
        const double growth_a = zones.growth_m2ps[pair.a];
        const double growth_b = zones.growth_m2ps[pair.b];
        const double apart = std::sqrt(growth_a * zones.radius_s[pair.a]) +
                             std::sqrt(growth_b * zones.radius_s[pair.b]);
        const double gain = std::sqrt((growth_a + growth_b) * room_s) - apart;
        if (gain > kLeastMergeGain * apart)
            found.push_back({.gain = gain, .a = pair.a, .b = pair.b});
    }
    std::ranges::stable_sort(found, std::greater<>(), &Merge::gain);
    return found;
}

/** Merges disjoint pairs, the best first. Returns the new number of each group. */
std::vector<int> merged(const std::vector<Merge>& found, std::size_t groups)
{
    std::vector<std::size_t> into(groups);
    std::iota(into.begin(), into.end(), std::size_t{0});
    std::vector<bool> isTaken(groups, false);
    for (const Merge& merge : found) {
        if (isTaken[merge.a] || isTaken[merge.b])
            continue;
        isTaken[merge.a] = isTaken[merge.b] = true;
        into[merge.b] = merge.a;
    }
    std::vector<int> number(groups, 0);
    int next = 0;
    for (std::size_t g = 0; g < groups; ++g)
        if (into[g] == g)
            number[g] = next++;
    for (std::size_t g = 0; g < groups; ++g)
        number[g] = number[into[g]];
    return number;
}

} // namespace

std::vector<double> groupLegs_s(const LegTimes& legs, const VisitZones& a, const VisitZones& b)
{
    const auto columns = static_cast<std::size_t>(b.groups());
    std::vector<double> least_s(static_cast<std::size_t>(a.groups()) * columns,
                                std::numeric_limits<double>::infinity());
    for (int i = 0; i < legs.size(); ++i)
        for (int j = 0; j < legs.size(); ++j) {
            const auto row = static_cast<std::size_t>(a.groupOf[static_cast<std::size_t>(i)]);
            const auto column = static_cast<std::size_t>(b.groupOf[static_cast<std::size_t>(j)]);
            double& leg_s = least_s[row * columns + column];
            leg_s = std::min(leg_s, i == j ? 0 : legs.between_s(i, j));
        }
    return least_s;
}

VisitZones visitZones(const LegTimes& legs, std::span<const double> growth_m2ps,
                      const std::stop_token& stop)
{
    std::vector<int> groupOf(growth_m2ps.size());
    std::iota(groupOf.begin(), groupOf.end(), 0);
    std::vector<double> growth(growth_m2ps.begin(), growth_m2ps.end());
    VisitZones best;
    for (int round = 0; round <= kMostMerges && !stop.stop_requested(); ++round) {
        VisitZones grouping{.groupOf = groupOf, .growth_m2ps = growth, .radius_s = growth};
        const std::vector<double> legs_s = groupLegs_s(legs, grouping, grouping);
        VisitZones zones = zonesOf(groupOf, growth, legs_s);
        const std::vector<Merge> found = merges(zones, legs_s);
        if (round == 0 || zones.rootSum > best.rootSum)
            best = zones;
        if (found.empty())
            break;
        const std::vector<int> number = merged(found, growth.size());
        std::vector<double> sum(static_cast<std::size_t>(*std::ranges::max_element(number)) + 1,
                                0.0);
        for (std::size_t g = 0; g < growth.size(); ++g)
            sum[static_cast<std::size_t>(number[g])] += growth[g];
        growth = std::move(sum);
        for (int& group : groupOf)
            group = number[static_cast<std::size_t>(group)];
    }
    return best;
}

} // namespace berg
