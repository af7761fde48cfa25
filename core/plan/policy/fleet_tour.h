#pragma once

#include "core/plan/policy/policy.h"

namespace berg {

/**
 * `tour` for several UAVs: one shortest cycle over all icebergs, made by `solver` (borrowed) and
 * kept. The UAVs enter it evenly spaced along its length, whichever of them where is the least way
 * in all, and fly the same direction; entries and direction are those with the least sum
 * sigma_i t_i, each UAV flying to the entry of the next. Each passes over what is not available to
 * it or first in another's order.
 */
[[nodiscard]] std::unique_ptr<Policy> makeFleetTour(const TvpSolver& solver);

} // namespace berg
