#pragma once

#include "core/io/export/geo_shapes.h"

#include <span>
#include <vector>

namespace berg {

/**
 * The fewest of the points that the method of Ramer, Douglas and Peucker keeps, the first and the
 * last among them: no other is farther than `tolerance_m` from the line through those kept. Cost: n
 * log n as a rule, n^2 at worst.
 */
[[nodiscard]] std::vector<TimedPoint> thinnedPath(std::span<const TimedPoint> path,
                                                  double tolerance_m);

} // namespace berg
