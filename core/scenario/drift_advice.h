#pragma once

#include "core/scenario/scenario.h"

namespace berg {

class Findings;

/**
 * Chance that an iceberg, whose place is normally distributed about the middle of the field of view
 * with this standard deviation along each axis, is in view: erf(h / (sqrt 2 s)) along each side of
 * half width h, 1 - exp(-h^2 / (2 s^2)) of a disk. `spread_m`: that far from the middle in whatever
 * direction, as the members of a cluster are; a view as much smaller on each side is reckoned with.
 */
[[nodiscard]] double chanceInView(const SensorSpec& sensor, double sd_m, double spread_m = 0);

/**
 * What drift does before the icebergs are seen: those last seen so long ago that they may be out of
 * view where they are believed to be, and how many will be at the next visit, one round later. The
 * round is that of one UAV among several with an equal share: from each iceberg to the nearest not
 * yet visited, and back.
 */
void adviseDrift(const Scenario& scenario, Findings& findings);

} // namespace berg
