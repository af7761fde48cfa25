#pragma once

#include "core/bound/true_motion.h"

#include <vector>

namespace berg {

/**
 * What every flight of a UAV with an endurance pays beside the bounds `sigma_m2` of each block, by
 * the end of each of them. m^2 s
 *
 * It lands within its endurance and stands for the turn-around with its camera off. Meanwhile sigma
 * grows from what it was at least as it landed, by q a second. Flights differ in when they land and
 * for how long they stand: least of all by dynamic programming over the blocks of landings and
 * take-offs. Zeros where others fly meanwhile, and where the return may be late: inside a fence,
 * too far from home at the start, or with a slow autopilot.
 */
[[nodiscard]] std::vector<double> groundCosts_m2s(const Scenario& scenario,
                                                  const TrueMotion& motion,
                                                  const std::vector<double>& sigma_m2);

} // namespace berg
