#pragma once

#include "core/plan/policy/policy.h"

namespace berg {

/**
 * Returns the policy of the settings, `coverage` included. `coverage` minimises predicted zeta over
 * sequences of icebergs and aim points, and does not use `solver`; all other policies are those of
 * `makePolicy`. A request to `coverage` must have a prediction input for each UAV.
 */
[[nodiscard]] std::unique_ptr<Policy> makeFlownPolicy(const PlannerSettings& settings,
                                                      const TvpSolver& solver);

} // namespace berg
