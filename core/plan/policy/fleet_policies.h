#pragma once

#include "core/plan/policy/policy.h"

namespace berg {

/**
 * The policies of `makePolicy` for several UAVs, as they answer a `PlanRequest::fleet`; UAVs to
 * which no iceberg is available have no part in it, and icebergs that none may visit are left out.
 *
 * - visitation, latency: `solveFleet` by the back end of the settings.
 * - path: least distance in all, kept until every UAV has flown its part.
 * - nearest: again and again the least distance from the end of any order. uncertainty: largest
 *   sigma first, to the UAV that has the least way to it from the end of its order.
 * - tour: `makeFleetTour`.
 *
 * With one UAV left they solve with `solver`, as if it were alone.
 */
[[nodiscard]] std::unique_ptr<Policy> makeFleetPolicy(const PlannerSettings& settings,
                                                      const TvpSolver& solver);

} // namespace berg
