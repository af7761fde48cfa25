#pragma once

#include "core/plan/policy/policy.h"

namespace berg {

/**
 * Returns the policy `tour`: one shortest cycle over all icebergs, made by `solver` (borrowed, must
 * outlive the policy) and kept. One UAV enters it at the iceberg and in the direction that minimise
 * sum sigma_i t_i (t_i by distance at constant speed), and repeats it. Several UAVs enter it evenly
 * spaced along its length, assigned to the entries with the least total distance, and fly in the
 * same direction; entries and direction are those with the least sum sigma_i t_i, each UAV flying
 * to the entry of the next. A single UAV begins with the first iceberg that is available to it.
 * Each of several UAVs leaves out icebergs that are not available to it, and begins after those
 * that are first in another's order.
 *
 * The cycle is made again when the ids of the request change. The outcome is that of the cycle
 * problem, in which the first iceberg takes the place of the UAV. While one UAV flies the rest of
 * a round, the outcome is `Feasible` with source `KeptRoute` instead.
 */
[[nodiscard]] std::unique_ptr<Policy> makeTour(const TvpSolver& solver);

} // namespace berg
