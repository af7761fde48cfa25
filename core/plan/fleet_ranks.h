#pragma once

#include "core/plan/fleet_problem.h"

#include <functional>

namespace berg {

/**
 * The best plan when distance does not count (mu = 0, visitation): the most uncertain icebergs at
 * the first places of all UAVs, and so on, by assignment of icebergs to places. Of equally good
 * plans one that no move of the local search makes shorter. `cut` ends the looking for shorter
 * ones.
 */
[[nodiscard]] FleetPlan bestRanks(const FleetProblem& problem, const std::function<bool()>& cut);

} // namespace berg
