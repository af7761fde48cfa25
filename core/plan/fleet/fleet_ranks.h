#pragma once

#include "core/plan/fleet/fleet_problem.h"

#include <functional>

namespace berg {

/** A plan made at once: the most uncertain icebergs first, each to the UAV with the fewest so far.
 */
[[nodiscard]] FleetPlan inTurn(const FleetProblem& problem);

/** What `bestRanks` found. */
struct FleetRanks
{
    FleetPlan plan;
    bool isBest = false; ///< else cut before: a plan that is good
};

/**
 * The best plan when distance does not count (mu = 0, visitation): the most uncertain icebergs at
 * the first places of all UAVs, and so on, by assignment of icebergs to places. Of equally good
 * plans one that no move of the local search makes shorter. `cut`, asked at least every 10 ms, ends
 * the assignment or the looking for shorter ones.
 */
[[nodiscard]] FleetRanks bestRanks(const FleetProblem& problem, const std::function<bool()>& cut);

} // namespace berg
