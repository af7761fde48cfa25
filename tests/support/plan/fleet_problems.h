#pragma once

#include "core/base/random.h"
#include "core/plan/fleet/fleet_problem.h"

#include <cstdint>
#include <limits>
#include <utility>

namespace berg::test {

/** Special properties of a fleet's problem. */
enum class FleetKind
{
    Plain,
    Unlike,   ///< airspeeds differ, and distances are asymmetric
    Assigned, ///< about a third of the icebergs are assigned to a UAV
    Closed,
    Latency, ///< latency criterion; airspeeds differ, and some icebergs are assigned
};

/** Assigns the iceberg to that UAV alone. */
inline void assign(FleetProblem& problem, int iceberg, int owner)
{
    if (problem.allowed.empty())
        problem.allowed.assign(problem.distance_m.size(),
                               std::vector<bool>(problem.sigma_m2.size(), true));
    for (int uav = 0; uav < problem.uavCount(); ++uav)
        problem.allowed[static_cast<std::size_t>(uav)][static_cast<std::size_t>(iceberg)] =
            uav == owner;
}

/** Icebergs and starts anywhere in 5000 m x 4000 m, sigma 1 to 10 m^2; deterministic. */
inline FleetProblem randomFleet(std::uint64_t seed, int uavs, int icebergs, double tau,
                                FleetKind kind = FleetKind::Plain)
{
    Random random(seed, 91);
    Eigen::MatrixX2d points_m(uavs + icebergs, 2);
    for (Eigen::Index k = 0; k < points_m.rows(); ++k)
        points_m.row(k) << random.uniform(0, 5000), random.uniform(0, 4000);
    FleetProblem problem;
    problem.sigma_m2.assign(static_cast<std::size_t>(icebergs) + 1, 0.0);
    for (std::size_t i = 1; i < problem.sigma_m2.size(); ++i)
        problem.sigma_m2[i] = random.uniform(1, 10);
    for (int uav = 0; uav < uavs; ++uav) {
        Eigen::MatrixX2d own_m(icebergs + 1, 2);
        own_m << points_m.row(uav), points_m.bottomRows(icebergs);
        Eigen::MatrixXd distance_m = euclideanDistances(own_m);
        if (kind == FleetKind::Unlike || kind == FleetKind::Latency)
            for (Eigen::Index i = 0; i <= icebergs; ++i)
                for (Eigen::Index j = 0; j <= icebergs; ++j)
                    distance_m(i, j) *= (1 + 0.3 * uav) * random.uniform(0.9, 1.3);
        problem.distance_m.push_back(std::move(distance_m));
    }
    problem.route = kind == FleetKind::Closed ? Route::Closed : Route::Open;
    if (kind == FleetKind::Assigned)
        for (int i = 0; i <= icebergs; ++i)
            if (random.below(3) == 0)
                assign(problem, i,
                       static_cast<int>(random.below(static_cast<std::uint64_t>(uavs))));
    if (kind == FleetKind::Latency) {
        problem.criterion = Criterion::Latency;
        if (uavs > 1 && icebergs > 2)
            assign(problem, 2, 1);
    }
    problem.mu = fleetTuningWeight(problem, euclideanDistances(points_m.topRows(uavs)), tau).mu;
    return problem;
}

/**
 * Returns F by the visiting numbers t_i, or the latency leg by leg; computed in another form than
 * `fleetObjective`.
 */
inline double fleetCostByNumbers(const FleetProblem& problem, const FleetPlan& plan)
{
    const std::size_t N = problem.sigma_m2.size();
    double cost = 0;
    for (std::size_t uav = 0; uav < plan.size(); ++uav) {
        const VisitOrder& order = plan[uav];
        if (problem.criterion == Criterion::Latency) {
            for (std::size_t k = 0; k < order.size(); ++k)
                for (std::size_t later = k; later < order.size(); ++later)
                    cost += problem.mu *
                            legBetween(problem.distance_m[uav], k == 0 ? NodeIndex() : order[k - 1],
                                       order[k]) *
                            problem.sigma_m2[toIndex(order[later])];
            continue;
        }
        for (std::size_t k = 0; k < order.size(); ++k) {
            cost -= problem.sigma_m2[toIndex(order[k])] * static_cast<double>(N - (k + 2));
            cost += problem.mu * legBetween(problem.distance_m[uav],
                                            k == 0 ? NodeIndex() : order[k - 1], order[k]);
        }
        if (problem.route == Route::Closed && !order.empty())
            cost += problem.mu * legBetween(problem.distance_m[uav], order.back(), 0);
    }
    return cost;
}

/** Returns the least objective of all plans, found by inserting each iceberg at every place. */
inline double bruteForceFleet(const FleetProblem& problem, FleetPlan plan = {}, int iceberg = 1)
{
    plan.resize(problem.distance_m.size());
    if (iceberg == problem.nodeCount())
        return fleetCostByNumbers(problem, plan);
    double least = std::numeric_limits<double>::infinity();
    for (int uav = 0; uav < problem.uavCount(); ++uav) {
        if (!problem.allowed.empty() &&
            !problem.allowed[static_cast<std::size_t>(uav)][static_cast<std::size_t>(iceberg)])
            continue;
        VisitOrder& order = plan[static_cast<std::size_t>(uav)];
        for (std::size_t place = 0; place <= order.size(); ++place) {
            const auto at = order.begin() + static_cast<std::ptrdiff_t>(place);
            order.insert(at, NodeIndex::of(iceberg));
            least = std::min(least, bruteForceFleet(problem, plan, iceberg + 1));
            order.erase(order.begin() + static_cast<std::ptrdiff_t>(place));
        }
    }
    return least;
}

} // namespace berg::test
