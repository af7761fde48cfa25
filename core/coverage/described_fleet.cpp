#include "core/coverage/described_fleet.h"

#include "core/coverage/described_plan.h"

#include <cmath>
#include <limits>
#include <utility>

namespace berg {

namespace {

/** When a UAV's own plan first sees each iceberg that is available to any; infinity: never. */
std::vector<double> sightingsOf(const DescribedPlan& described, std::size_t icebergs)
{
    std::vector<double> times_s(icebergs, std::numeric_limits<double>::infinity());
    for (std::size_t j = 0; j < described.outlook.sightings_s.size(); ++j)
        times_s[static_cast<std::size_t>(described.nodes[j] - 1)] =
            described.outlook.sightings_s[j];
    return times_s;
}

/** In whose order each iceberg is; -1: in nobody's. */
std::vector<int> owners(const PlanRequest& request, std::span<const CoveragePlan> plans,
                        const std::vector<std::vector<double>>& sightings_s)
{
    std::vector<int> owner(request.ids.size(), -1);
    for (std::size_t k = 0; k < request.ids.size(); ++k)
        for (std::size_t u = 0; u < plans.size(); ++u) {
            if (!request.uavs[u].available[k])
                continue;
            const auto away_m = [&](std::size_t v) {
                return request.uavs[v].distance_m(0, static_cast<Eigen::Index>(k) + 1);
            };
            const auto was = static_cast<std::size_t>(owner[k]);
            if (owner[k] < 0 || sightings_s[u][k] < sightings_s[was][k] ||
                (sightings_s[u][k] == sightings_s[was][k] && away_m(u) < away_m(was)))
                owner[k] = static_cast<int>(u);
        }
    for (std::size_t u = 0; u < plans.size(); ++u)
        if (!plans[u].empty())
            owner[static_cast<std::size_t>(plans[u].front().iceberg)] = static_cast<int>(u);
    return owner;
}

template <typename IsOwn>
UavAnswer answerOf(DescribedPlan described, std::span<const double> sightings_s,
                   const PlanRequest& request, const IsOwn& isOwn)
{
    UavAnswer answer{.legs = std::move(described.legs),
                     .outlook = AimedOutlook{.until_s = described.outlook.until_s}};
    for (const int node : described.nodes) {
        const auto k = static_cast<std::size_t>(node - 1);
        if (!isOwn(k))
            continue;
        answer.order.push_back(request.ids[k]);
        if (std::isfinite(sightings_s[k]))
            answer.outlook->sightings_s.push_back(sightings_s[k]);
    }
    return answer;
}

} // namespace

std::vector<bool> availableToAny(const PlanRequest& request)
{
    std::vector<bool> any(request.ids.size(), false);
    for (const UavRequest& uav : request.uavs)
        for (std::size_t k = 0; k < any.size(); ++k)
            any[k] = any[k] || uav.available[k];
    return any;
}

std::vector<UavAnswer> describeFleet(std::span<const CoverageModel> models,
                                     const PlanRequest& request,
                                     std::span<const CoveragePlan> plans)
{
    UavRequest own;
    own.available = availableToAny(request);
    std::vector<DescribedPlan> described;
    std::vector<std::vector<double>> sightings_s;
    for (std::size_t u = 0; u < models.size(); ++u) {
        own.picture = request.uavs[u].picture;
        described.push_back(describe(models[u], own, request.ids, plans[u]));
        sightings_s.push_back(sightingsOf(described[u], request.ids.size()));
    }
    const std::vector<int> owner = owners(request, plans, sightings_s);
    std::vector<UavAnswer> answers;
    for (std::size_t u = 0; u < models.size(); ++u) {
        const auto isOwn = [&](std::size_t k) { return owner[k] == static_cast<int>(u); };
        answers.push_back(answerOf(std::move(described[u]), sightings_s[u], request, isOwn));
    }
    return answers;
}

} // namespace berg
