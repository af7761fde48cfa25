#include "core/coverage/coverage_settings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace berg {

namespace {

constexpr CoverageHorizon kHorizonPart{.length_s = 800, .rest_s = 25};
/**
 * A run that is less than this many times as long as the horizon is judged as a whole, because the
 * rest would be short.
 */
constexpr double kWhole = 1.25;
/**
 * Horizons hold this many visits to every iceberg, or this many legs, if keeping icebergs in view
 * pays.
 */
constexpr double kRoundsAhead = 2;
constexpr double kMostLegsAhead = 40;
/** Length of a round tour over points that are spread evenly, per length of their tree. */
constexpr double kTourOfTree = 1.25;

/**
 * Returns the length of the shortest tree between the present estimates (Prim's algorithm), in time
 * proportional to the square of the number of icebergs.
 */
double spanningTree_m(const PredictionInput& input)
{
    struct Outside
    {
        Point place_m;
        double away_m = std::numeric_limits<double>::infinity(); ///< Distance from the tree.
    };
    std::vector<Outside> outside;
    for (const Track& track : input.tracks)
        outside.push_back({track.estimate_m(input.time_s)});
    double sum_m = 0;
    while (!outside.empty()) {
        const auto next = std::ranges::min_element(outside, {}, &Outside::away_m);
        const Point place_m = next->place_m;
        sum_m += std::isfinite(next->away_m) ? next->away_m : 0;
        *next = outside.back();
        outside.pop_back();
        for (Outside& other : outside)
            other.away_m = std::min(other.away_m, (other.place_m - place_m).norm());
    }
    return sum_m;
}

/**
 * Returns the length of the part of a run that plans are judged by. It grows with the paths between
 * icebergs.
 */
double part_s(const PredictionInput& input, std::size_t uavs)
{
    if (input.observer.model == ObserverModel::Simple)
        return kHorizonPart.length_s;
    const auto icebergs = static_cast<double>(input.tracks.size());
    const double leg_s = kTourOfTree * spanningTree_m(input) / input.motion.airspeed_mps / icebergs;
    const double legs = kRoundsAhead * icebergs / static_cast<double>(uavs);
    return std::max(kHorizonPart.length_s, leg_s * std::min(legs, kMostLegsAhead));
}

} // namespace

CoverageHorizon horizonOf(std::span<const PredictionInput> inputs)
{
    const double until_s = std::ranges::max(inputs, {}, &PredictionInput::until_s).until_s;
    const double left_s = until_s - inputs.front().time_s;
    const double length_s = part_s(inputs.front(), inputs.size());
    return left_s <= kWhole * length_s
               ? CoverageHorizon{.length_s = left_s}
               : CoverageHorizon{.length_s = length_s, .rest_s = kHorizonPart.rest_s};
}

double round_s(std::span<const PredictionInput> inputs)
{
    double speed_mps = 0;
    for (const PredictionInput& input : inputs)
        speed_mps += input.motion.airspeed_mps;
    return kTourOfTree * spanningTree_m(inputs.front()) / speed_mps;
}

bool isWeighted(const PredictionInput& input)
{
    return std::any_of(input.weights.begin(), input.weights.end(),
                       [](double weight) { return weight != 1; });
}

CoveragePlan straightPlan(const VisitOrder& order, int rounds)
{
    CoveragePlan plan;
    for (int round = 0; round < rounds; ++round)
        for (const NodeIndex node : order)
            plan.push_back({.iceberg = placeOf(node), .offset_m = 0});
    return plan;
}

KeptPlan keptPlan(const CoveragePlan& plan, const CoverageModel& model,
                  std::span<const IcebergIndex> ids)
{
    KeptPlan kept;
    for (const CoverageLeg& leg : plan) {
        kept.push_back({.leg = leg});
        if (leg.isHold())
            continue;
        kept.back().id = ids[toIndex(model.icebergAt(leg.iceberg))];
        kept.back().offset_m = model.offset_m(leg.iceberg);
    }
    return kept;
}

CoveragePlan restOf(const KeptPlan& plan, const CoverageModel& model,
                    std::span<const IcebergIndex> ids)
{
    CoveragePlan rest;
    for (const auto& [id, offset_m, leg] : plan) {
        const auto it = id ? std::find(ids.begin(), ids.end(), *id) : ids.end();
        if (id && it == ids.end())
            continue;
        rest.push_back(leg);
        if (id)
            rest.back().iceberg = model.placeNear(ModelPlace::of(it - ids.begin()), offset_m);
    }
    return rest;
}

void shorten(CoveragePlan& plan, const CoverageModel& model, const PredictionInput& input,
             double flown_s)
{
    constexpr double kLeastOfHold_s = 0.05;
    constexpr double kLeastStay_s = 0.3;
    if (plan.empty())
        return;
    CoverageLeg& first = plan.front();
    if (first.isHold()) {
        first.stay_s -= flown_s;
        if (first.stay_s < kLeastOfHold_s)
            plan.erase(plan.begin());
    } else if (input.tracks[toIndex(model.icebergAt(first.iceberg))].inView &&
               first.stay_s > kLeastStay_s) {
        first = holdOf(first.stay_s);
    }
}

} // namespace berg
