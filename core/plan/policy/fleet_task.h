#pragma once

#include "core/plan/fleet/fleet_problem.h"
#include "core/plan/policy/policy.h"

#include <vector>

namespace berg {

/** What of a request there is to plan: the UAVs that have an iceberg to visit, and the icebergs
 * that one of them may visit. */
struct FleetTask
{
    FleetProblem problem;            ///< `mu` is 0
    std::vector<int> uavs;           ///< index in `PlanRequest::uavs` of UAV k of `problem`
    std::vector<int> ids;            ///< id of iceberg node k + 1
    Eigen::MatrixXd betweenStarts_m; ///< of these UAVs, for Eq. (14); empty when nothing says it
};

[[nodiscard]] FleetTask fleetTask(const PlanRequest& request);

/**
 * What the policy `visitation` solves but for mu; with nothing to visit the first UAV alone. A leg
 * costs the mean of both directions: in a uniform wind what differs between them adds up to what
 * depends on the ends of an order alone, and would only reward orders that end down wind
 * (tests/bench/RESULTS.md).
 */
[[nodiscard]] FleetTask visitationTask(const PlanRequest& request, Route route);

/** Orders in ids for each UAV of the request, from a plan of the task's problem or an empty one. */
[[nodiscard]] std::vector<std::vector<int>>
ordersInIds(const PlanRequest& request, const FleetTask& task, const FleetPlan& plan);

/** `UavRequest::lastRest` in nodes of the task's problem, less what it does not hold. */
[[nodiscard]] FleetPlan lastRests(const PlanRequest& request, const FleetTask& task);

/** An answer of these orders, one for each UAV of the request, with its distance as flown: those
 * of the request, return legs of closed routes included. */
[[nodiscard]] PlanAnswer answerOf(const PlanRequest& request,
                                  const std::vector<std::vector<int>>& orders,
                                  Route route = Route::Open);

/** Whether the UAV may visit the iceberg of that id now. */
[[nodiscard]] bool isAvailable(const PlanRequest& request, const UavRequest& uav, int id);

/** Node number (1 ..) of an id of the request. */
[[nodiscard]] int nodeOfId(const PlanRequest& request, int id);

} // namespace berg
