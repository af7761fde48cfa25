#pragma once

#include "core/plan/policy/policy.h"

namespace berg {

/**
 * `tour`: one shortest cycle over all icebergs, made by `solver` (borrowed) and kept. One UAV
 * enters it where and in the direction that minimise sum sigma_i t_i (t_i by distance at constant
 * speed), round after round. Several enter it evenly spaced along its length, whichever of them
 * where is the least way in all, and fly the same direction; entries and direction are those with
 * the least sum sigma_i t_i, each UAV flying to the entry of the next. Each passes over what is not
 * available to it or first in another's order.
 *
 * The outcome is that of the cycle, with the first iceberg in the place of the only UAV.
 */
[[nodiscard]] std::unique_ptr<Policy> makeTour(const TvpSolver& solver);

} // namespace berg
