#pragma once

#include "core/scenario/scenario.h"

namespace berg {

class Findings;

/**
 * Returns the probability that an iceberg is in view if its position is normally distributed around
 * the middle of the field of view with standard deviation `sd_m` along each axis: erf(h / (sqrt 2
 * s)) along each side of half width h, 1 - exp(-h^2 / (2 s^2)) for a disk. A cluster needs
 * `spread_m`, the distance of its members from the middle, which makes the view smaller on each
 * side. Returns 1 if `sd_m` is 0.
 */
[[nodiscard]] double chanceInView(const SensorSpec& sensor, double sd_m, double spread_m = 0);

/**
 * Reports drift before the icebergs are seen: icebergs last seen so long ago that they may be out
 * of view at their estimate, and the number that will be out of view at the next visit, one round
 * later. The round is one UAV's equal share of a tour that goes from each iceberg to the nearest
 * one not yet visited, and back to the first. The number is reported only with the Kalman observer
 * and if the round fits the run. The scenario must have no errors.
 */
void adviseDrift(const Scenario& scenario, Findings& findings);

} // namespace berg
