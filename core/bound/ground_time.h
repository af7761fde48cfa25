#pragma once

#include "core/bound/true_motion.h"

#include <vector>

namespace berg {

/**
 * Returns a lower bound, in m2 s, on the zeta that time on the ground adds to the bounds `sigma_m2`
 * of the blocks, cumulated to the end of each block. `sigma_m2` must have one entry for each block
 * of `motion`.
 *
 * The UAV lands within its endurance and stands for the turn-around with its camera off. Meanwhile
 * sigma grows by q a second from its bound at the landing. Dynamic programming over the blocks of
 * landings and take-offs finds the least cost of all schedules of time on the ground. Returns zeros
 * for several UAVs, without an endurance, and if the return may be late: inside a fence, too far
 * from home at the start, or with a slow autopilot.
 */
[[nodiscard]] std::vector<double> groundCosts_m2s(const Scenario& scenario,
                                                  const TrueMotion& motion,
                                                  const std::vector<double>& sigma_m2);

} // namespace berg
