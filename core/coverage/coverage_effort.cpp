#include "core/coverage/coverage_effort.h"

#include <algorithm>

namespace berg {

namespace {

/** Up to this is judged as a whole; of longer runs a part, and what it leaves. */
constexpr double kWhole_s = 1000;
constexpr CoverageHorizon kPart{.length_s = 800, .rest_s = 25};

} // namespace

CoverageHorizon horizonOf(const FlightPicture& picture)
{
    const double left_s = picture.until_s - picture.time_s;
    return left_s <= kWhole_s ? CoverageHorizon{.length_s = left_s} : kPart;
}

bool isWeighted(const FlightPicture& picture)
{
    return std::any_of(picture.weights.begin(), picture.weights.end(),
                       [](double weight) { return weight != 1; });
}

CoveragePlan straightPlan(const VisitOrder& order, int rounds)
{
    CoveragePlan plan;
    for (int round = 0; round < rounds; ++round)
        for (const int node : order)
            plan.push_back({.iceberg = node - 1, .offset_m = 0});
    return plan;
}

KeptPlan keptPlan(const CoveragePlan& plan, const CoverageModel& model, std::span<const int> ids)
{
    KeptPlan kept;
    for (const CoverageLeg& leg : plan) {
        kept.push_back({.leg = leg});
        if (leg.isHold())
            continue;
        kept.back().id = ids[static_cast<std::size_t>(model.icebergAt(leg.iceberg))];
        kept.back().offset_m = model.offset_m(leg.iceberg);
    }
    return kept;
}

CoveragePlan restOf(const KeptPlan& plan, const CoverageModel& model, std::span<const int> ids)
{
    CoveragePlan rest;
    for (const auto& [id, offset_m, leg] : plan) {
        const auto it = std::find(ids.begin(), ids.end(), id);
        if (!leg.isHold() && it == ids.end())
            continue;
        rest.push_back(leg);
        if (!leg.isHold())
            rest.back().iceberg = model.placeNear(static_cast<int>(it - ids.begin()), offset_m);
    }
    return rest;
}

void shorten(CoveragePlan& plan, const CoverageModel& model, const FlightPicture& picture,
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
    } else if (picture.tracks[static_cast<std::size_t>(model.icebergAt(first.iceberg))].inView &&
               first.stay_s > kLeastStay_s) {
        first = holdOf(first.stay_s);
    }
}

} // namespace berg
