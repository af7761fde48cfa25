#include "core/plan/fleet_ranks.h"

#include "core/plan/assignment.h"
#include "core/plan/fleet_costs.h"
#include "core/plan/fleet_search.h"

#include <numeric>

namespace berg {

namespace {

FleetPlan byAssignment(const FleetProblem& problem)
{
    const Eigen::Index n = problem.icebergCount();
    const Eigen::Index uavs = problem.uavCount();
    const double sum_m2 = std::accumulate(problem.sigma_m2.begin(), problem.sigma_m2.end(), 0.0);
    // More than all the rest together.
    const double barred = static_cast<double>(2 * (n + 1)) * (sum_m2 + 1);
    Eigen::MatrixXd cost(n, uavs * n); // column: place * uavs + uav
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index place = 0; place < n; ++place)
            for (Eigen::Index uav = 0; uav < uavs; ++uav)
                cost(i, place * uavs + uav) =
                    problem.allows(static_cast<int>(uav), static_cast<int>(i) + 1)
                        ? problem.sigma_m2[static_cast<std::size_t>(i) + 1] *
                              static_cast<double>(place + 2)
                        : barred;
    const std::vector<int> columns = cheapestAssignment(cost);
    std::vector<int> icebergAt(static_cast<std::size_t>(uavs * n), 0);
    for (std::size_t i = 0; i < columns.size(); ++i)
        icebergAt[static_cast<std::size_t>(columns[i])] = static_cast<int>(i) + 1;
    FleetPlan plan(static_cast<std::size_t>(uavs));
    for (std::size_t column = 0; column < icebergAt.size(); ++column)
        if (icebergAt[column] != 0)
            plan[column % plan.size()].push_back(icebergAt[column]);
    return plan;
}

} // namespace

FleetPlan bestRanks(const FleetProblem& problem, const std::function<bool()>& cut)
{
    FleetPlan plan = byAssignment(problem);
    const double distance_m = fleetDistance(problem, plan);
    const double value = fleetObjective(problem, plan);
    const double scale = value + fleetObjectiveShift(problem);
    if (distance_m <= 0)
        return plan;
    // So little that it settles nothing but ties.
    constexpr double kWeight = 1e-7;
    FleetProblem tied = problem;
    tied.mu = scale > 0 ? kWeight * scale / distance_m : 1;
    const FleetCosts costs(tied);
    SearchEffort effort{.cut = cut};
    FleetSearch search(costs, effort);
    search.take(plan);
    search.descend();
    constexpr double kRounding = 1e-12;
    if (fleetObjective(problem, search.best()) <= value + kRounding * scale)
        plan = search.best();
    return plan;
}

} // namespace berg
