#pragma once

#include "core/plan/policy/policy.h"

namespace berg {

/**
 * The policy of the settings, `coverage` included: predicted zeta minimised over sequences of
 * icebergs and aim points. Otherwise as `makePolicy`. A `coverage` request needs its `picture`.
 */
[[nodiscard]] std::unique_ptr<Policy> makeFlownPolicy(const PlannerSettings& settings,
                                                      const TvpSolver& solver);

} // namespace berg
