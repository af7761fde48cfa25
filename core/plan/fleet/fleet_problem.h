#pragma once

#include "core/plan/problem/tuning.h"
#include "core/plan/problem/tvp.h"

#include <Eigen/Core>

#include <vector>

namespace berg {

/**
 * The problem of Eq. (1) for several UAVs: each has a start and flies an order of its own, every
 * iceberg is visited by one of them, and positions count within the order of its UAV. N is the
 * number of icebergs plus 1, the same for all. Nodes 1 .. N-1 are icebergs as in `TvpProblem`; node
 * 0 is the start of the respective UAV.
 */
struct FleetProblem
{
    /**
     * One N x N matrix for each UAV, as `TvpProblem::distance_m`. They differ in row and column 0,
     * and elsewhere if airspeeds or winds differ: the unit is then the same for all, such as flight
     * time times a speed common to the fleet.
     */
    std::vector<Eigen::MatrixXd> distance_m;
    std::vector<double> sigma_m2; ///< N values; [0] is 0
    double mu = 0;                ///< weight of distance, >= 0; see `fleetTuningWeight`
    Route route = Route::Open;
    /**
     * Which UAV may visit which iceberg: N entries for each UAV, [0] ignored, or empty if each may
     * visit all. At least one UAV may visit each iceberg.
     */
    std::vector<std::vector<bool>> allowed = {};
    Criterion criterion = Criterion::Visitation;

    [[nodiscard]] int uavCount() const { return static_cast<int>(distance_m.size()); }
    [[nodiscard]] int nodeCount() const { return static_cast<int>(sigma_m2.size()); }
    [[nodiscard]] int icebergCount() const { return nodeCount() - 1; }
    /** Returns whether the UAV may visit the iceberg node. */
    [[nodiscard]] bool allows(int uav, NodeIndex node) const
    {
        return allowed.empty() || allowed[static_cast<std::size_t>(uav)][toIndex(node)];
    }
};

/**
 * Returns whether there is one order for each UAV, every iceberg is in one of them, once, and each
 * UAV may visit its icebergs.
 */
[[nodiscard]] bool isFleetPlan(const FleetProblem& problem, const FleetPlan& plan);

/**
 * Returns the plan without invalid visits: unknown nodes, second visits, visits that are not
 * allowed. `plan` must hold one order for each UAV.
 */
[[nodiscard]] FleetPlan validPart(const FleetProblem& problem, FleetPlan plan);

/** Returns a problem of one UAV as a fleet problem. */
[[nodiscard]] FleetProblem problemOf(const TvpProblem& alone);

/** Returns the problem of one UAV alone, with all icebergs. */
[[nodiscard]] TvpProblem problemOfUav(const FleetProblem& problem, int uav);

/** Returns the sum of the distances flown, m, with the return legs of closed routes. */
[[nodiscard]] double fleetDistance(const FleetProblem& problem, const FleetPlan& plan);

/**
 * Returns the objective, by which all fleet plans are compared: F = -sum sigma_i (N - t_i) + mu D
 * with t = 2, 3, ... along each order, or the sum of the orders' latencies. With one UAV it equals
 * `objective`. Throws `std::logic_error` unless `isFleetPlan`.
 */
[[nodiscard]] double fleetObjective(const FleetProblem& problem, const FleetPlan& plan);

/** Returns the sum of `uncertaintyReward` over all orders, m^2; N is that of the whole problem. */
[[nodiscard]] double fleetReward(const FleetProblem& problem, const FleetPlan& plan);

/**
 * Returns mu(tau) of Eq. (10)-(14) for the fleet: the average distance is that over all ordered
 * pairs of starts and icebergs (between icebergs the mean over the UAVs), N is the common one. The
 * result is divided by sqrt(m) for m UAVs, so that tau means the same for any number of them: each
 * has 1/m of the icebergs, by which the reward of a visit grows, in 1/m of the area, where legs are
 * shorter by sqrt(m). Measured: tests/bench/RESULTS.md. With one UAV it equals `tuningWeight`. If
 * all sigma are 0, mu is 1 for any number of UAVs; without icebergs it is 0. `betweenStarts_m` has
 * one row and column for each UAV (else `std::logic_error`); its diagonal is ignored. It is not
 * read for one UAV.
 */
[[nodiscard]] TuningWeight fleetTuningWeight(const FleetProblem& problem,
                                             const Eigen::MatrixXd& betweenStarts_m, double tau);

/**
 * Returns all faults of a problem: no UAV, the faults of `problemOfUav` of each UAV, wrong size of
 * `allowed`, icebergs that no UAV may visit.
 */
[[nodiscard]] std::vector<Issue> validate(const FleetProblem& problem);

} // namespace berg
