#include "core/plan/fleet/fleet_ranks.h"

#include "core/plan/fleet/fleet_costs.h"
#include "core/plan/fleet/fleet_search.h"
#include "core/plan/problem/assignment.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <optional>

namespace berg {

namespace {

/** Returns an empty plan if stopped. */
FleetPlan byAssignment(const FleetProblem& problem, const std::function<bool()>& isStopped)
{
    const Eigen::Index n = problem.icebergCount();
    const Eigen::Index uavs = problem.uavCount();
    const double sum_m2 = std::accumulate(problem.sigma_m2.begin(), problem.sigma_m2.end(), 0.0);
    // This exceeds the sum of all other costs.
    const double barred = static_cast<double>(2 * (n + 1)) * (sum_m2 + 1);
    Eigen::MatrixXd cost(uavs * n, n); // row: place * uavs + uav
    for (Eigen::Index i = 0; i < n; ++i) {
        if (isStopped && isStopped())
            return {};
        for (Eigen::Index place = 0; place < n; ++place)
            for (Eigen::Index uav = 0; uav < uavs; ++uav)
                cost(place * uavs + uav, i) =
                    problem.allows(static_cast<int>(uav), NodeIndex::of(i + 1))
                        ? problem.sigma_m2[static_cast<std::size_t>(i) + 1] *
                              static_cast<double>(place + 2)
                        : barred;
    }
    const std::vector<int> places = cheapestAssignment(cost, isStopped);
    if (places.empty())
        return {};
    VisitOrder icebergAt(static_cast<std::size_t>(uavs * n));
    for (std::size_t i = 0; i < places.size(); ++i)
        icebergAt[static_cast<std::size_t>(places[i])] = NodeIndex::of(i + 1);
    FleetPlan plan(static_cast<std::size_t>(uavs));
    for (std::size_t place = 0; place < icebergAt.size(); ++place)
        if (icebergAt[place] != 0)
            plan[place % plan.size()].push_back(icebergAt[place]);
    return plan;
}

} // namespace

FleetPlan roundRobinPlan(const FleetProblem& problem)
{
    VisitOrder icebergs = ascendingOrder(problem.icebergCount());
    const auto sigma_m2 = [&](NodeIndex i) { return problem.sigma_m2[toIndex(i)]; };
    std::ranges::stable_sort(icebergs, std::ranges::greater{}, sigma_m2);
    FleetPlan plan(static_cast<std::size_t>(problem.uavCount()));
    for (const NodeIndex i : icebergs) {
        std::optional<int> best;
        for (int uav = 0; uav < problem.uavCount(); ++uav)
            if (problem.allows(uav, i) &&
                (!best || plan[static_cast<std::size_t>(uav)].size() <
                              plan[static_cast<std::size_t>(*best)].size()))
                best = uav;
        plan[static_cast<std::size_t>(best.value())].push_back(i);
    }
    return plan;
}

FleetRanks bestRanks(const FleetProblem& problem, const std::function<bool()>& isStopped)
{
    FleetPlan plan = byAssignment(problem, isStopped);
    if (plan.empty())
        return {.plan = roundRobinPlan(problem)};
    const double distance_m = fleetDistance(problem, plan);
    const double value = fleetObjective(problem, plan);
    const double scale = value + objectiveShift(problem);
    if (distance_m <= 0)
        return {.plan = plan, .isBest = true};
    // The weight is so small that it only breaks ties.
    constexpr double kWeight = 1e-7;
    FleetProblem tied = problem;
    tied.mu = scale > 0 ? kWeight * scale / distance_m : 1;
    const FleetCosts costs(tied);
    SearchEffort effort{.isStopped = isStopped};
    FleetSearch search(costs, effort);
    search.accept(plan);
    search.descend();
    constexpr double kRounding = 1e-12;
    if (fleetObjective(problem, search.best()) <= value + kRounding * scale)
        plan = search.best();
    return {.plan = plan, .isBest = true};
}

} // namespace berg
