#pragma once

#include "core/plan/fleet/fleet_problem.h"
#include "core/plan/policy/policy.h"

#include <vector>

namespace berg {

/**
 * The plannable part of a request: the UAVs that have an iceberg to visit, and the icebergs that at
 * least one of them may visit. This is the door to the solvers: before it icebergs are
 * `IcebergIndex`, behind it they are `NodeIndex`, and only `nodeOf` and `icebergOf` lead from one
 * to the other.
 */
struct FleetTask
{
    FleetProblem problem;  ///< `mu` is 0
    std::vector<int> uavs; ///< by UAV of `problem`: its index in `PlanRequest::uavs`
    IcebergList ids;       ///< iceberg of node k + 1
    /** Distances between these UAVs for Eq. (14), m; empty if the request has none. */
    Eigen::MatrixXd betweenStarts_m;
};

/**
 * Returns the plannable part of a request, with mu = 0. Throws `std::logic_error` unless each UAV's
 * `available` has one entry for each iceberg.
 */
[[nodiscard]] FleetTask fleetTask(const PlanRequest& request);

/**
 * Returns the task that the policy `visitation` solves, without mu. If there is nothing to visit it
 * holds the first UAV alone. A leg costs the mean of both directions: in a uniform wind the
 * differences add up to a sum that depends on the ends of an order alone, and would only reward
 * orders that end downwind (tests/bench/RESULTS.md). Throws as `fleetTask` does.
 */
[[nodiscard]] FleetTask visitationTask(const PlanRequest& request, Route route);

/**
 * Returns for each UAV of the request the order of icebergs, from a plan of the task's problem;
 * empty orders for an empty plan.
 */
[[nodiscard]] std::vector<IcebergList> ordersInIds(const PlanRequest& request,
                                                   const FleetTask& task, const FleetPlan& plan);

/**
 * Returns `UavRequest::lastRest` of each UAV in nodes of the task's problem, without icebergs that
 * the problem does not hold and without invalid visits (`validPart`).
 */
[[nodiscard]] FleetPlan lastRests(const PlanRequest& request, const FleetTask& task);

/**
 * Returns an answer with these orders, one for each UAV of the request, and their distance by the
 * legs of the request, with the return legs of closed routes. Throws `std::logic_error` if the
 * request does not hold one of the icebergs.
 */
[[nodiscard]] Plan answerOf(const PlanRequest& request, std::span<const IcebergList> orders,
                            Route route = Route::Open);

/**
 * Returns whether the UAV may visit the iceberg now; throws `std::logic_error` if the request does
 * not hold it.
 */
[[nodiscard]] bool isAvailable(const PlanRequest& request, const UavRequest& uav,
                               IcebergIndex iceberg);

/**
 * Returns the node (1 ..) of an iceberg of a problem, `ids` being the icebergs of its nodes; throws
 * `std::logic_error` if it is none of them.
 */
[[nodiscard]] NodeIndex nodeOf(const IcebergList& ids, IcebergIndex iceberg);

/** Returns the iceberg of a node (1 ..) of a problem, `ids` being the icebergs of its nodes. */
[[nodiscard]] IcebergIndex icebergOf(const IcebergList& ids, NodeIndex node);

} // namespace berg
