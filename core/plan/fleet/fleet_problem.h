#pragma once

#include "core/plan/solve/tuning.h"
#include "core/plan/solve/tvp.h"

#include <Eigen/Core>

#include <vector>

namespace berg {

/**
 * The problem of Eq. (1) for several UAVs: each has a start and flies an order of its own, every
 * iceberg is visited by one of them, and positions count within the order of its UAV. N is the
 * number of icebergs and 1, the same for all. Nodes 1 .. N-1 are icebergs as in `TvpProblem`; node
 * 0 is the start of the UAV in question.
 */
struct FleetProblem
{
    /** One N x N for each UAV, as `TvpProblem::distance_m`. They differ in row and column 0, and
     * elsewhere when airspeeds or winds do: then in one unit for all, such as flight time times a
     * speed common to the fleet. */
    std::vector<Eigen::MatrixXd> distance_m;
    std::vector<double> sigma_m2; ///< N; [0] is 0
    double mu = 0;                ///< weight of distance, >= 0: `fleetTuningWeight`
    Route route = Route::Open;
    /** Which UAV may visit which iceberg: empty when each may visit all, or N entries for each of
     * them, [0] ignored. Every iceberg may be visited by one at least. */
    std::vector<std::vector<bool>> allowed = {};
    Criterion criterion = Criterion::Visitation;

    [[nodiscard]] int uavCount() const { return static_cast<int>(distance_m.size()); }
    [[nodiscard]] int nodeCount() const { return static_cast<int>(sigma_m2.size()); }
    [[nodiscard]] int icebergCount() const { return nodeCount() - 1; }
    /** Whether the UAV may visit the iceberg node. */
    [[nodiscard]] bool allows(int uav, int node) const
    {
        return allowed.empty() ||
               allowed[static_cast<std::size_t>(uav)][static_cast<std::size_t>(node)];
    }
};

/** True when every iceberg is in one of the orders, once, and each may visit what it visits. */
[[nodiscard]] bool isFleetPlan(const FleetProblem& problem, const FleetPlan& plan);

/** The plan without what is in no plan: unknown nodes, second visits, visits that are not allowed.
 * `plan` holds one order for each UAV. */
[[nodiscard]] FleetPlan validPart(const FleetProblem& problem, FleetPlan plan);

/** The same problem of one UAV. */
[[nodiscard]] FleetProblem problemOf(const TvpProblem& alone);

/** The problem as the UAV would have it alone, with all icebergs. */
[[nodiscard]] TvpProblem problemOfUav(const FleetProblem& problem, int uav);

/** Sum of the distances flown, m; return legs of the UAVs that fly included on closed routes. */
[[nodiscard]] double fleetDistance(const FleetProblem& problem, const FleetPlan& plan);

/**
 * The only judge of fleet plans: F = -sum sigma_i (N - t_i) + mu D with t = 2, 3, ... along each
 * order, or the sum of the orders' latencies. With one UAV that is `objective`. `plan` must satisfy
 * `isFleetPlan`.
 */
[[nodiscard]] double fleetObjective(const FleetProblem& problem, const FleetPlan& plan);

/** As `uncertaintyReward`, over all orders. */
[[nodiscard]] double fleetReward(const FleetProblem& problem, const FleetPlan& plan);

/**
 * mu(tau) of Eq. (10)-(14) for the fleet: the average distance is that over all ordered pairs of
 * starts and icebergs (between icebergs the mean over the UAVs), N is the common one. Then divided
 * by sqrt(m) for m UAVs, so that tau means the same for any number of them: each has 1/m of the
 * icebergs, by which the reward of a visit grows, in 1/m of the area, where legs are shorter by
 * sqrt(m). Measured: tests/bench/RESULTS.md. With one UAV that is `tuningWeight`.
 * `betweenStarts_m`: one row and column for each UAV, diagonal ignored.
 */
[[nodiscard]] TuningWeight fleetTuningWeight(const FleetProblem& problem,
                                             const Eigen::MatrixXd& betweenStarts_m, double tau);

/** All faults of a problem: no UAV, sizes, signs, numbers that are not finite, icebergs
 * that no UAV may visit. */
[[nodiscard]] std::vector<Issue> validate(const FleetProblem& problem);

} // namespace berg
