#pragma once

#include "core/plan/fleet/fleet_problem.h"

#include <functional>

namespace berg {

/**
 * Returns a quick plan: the most uncertain icebergs first, each to the UAV with the fewest so far
 * among those that may visit it, which must exist.
 */
[[nodiscard]] FleetPlan roundRobinPlan(const FleetProblem& problem);

/** Result of `bestRanks`. */
struct FleetRanks
{
    FleetPlan plan;
    /** Whether the plan is proven; otherwise it was stopped, and the plan is only good. */
    bool isBest = false;
};

/**
 * Returns the best plan if distance has no weight (mu = 0, visitation): the most uncertain icebergs
 * at the first positions of all UAVs, and so on, by assignment of icebergs to positions. Among
 * equally good plans it is one that no move of the local search makes shorter. `isStopped`, called
 * at least every 10 ms, ends the assignment, which leaves `roundRobinPlan`, or the search for
 * shorter plans. There must be at least one iceberg.
 */
[[nodiscard]] FleetRanks bestRanks(const FleetProblem& problem,
                                   const std::function<bool()>& isStopped);

} // namespace berg
