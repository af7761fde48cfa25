#pragma once

#include "core/io/export/geo_shapes.h"

#include <cstdint>
#include <span>
#include <vector>

namespace berg {

/**
 * The fewest of the points that the method of Ramer, Douglas and Peucker keeps, the first and the
 * last among them: no other is farther than `tolerance_m` from the line through those kept. When
 * those would be more than `most`, only some `most` + 1 of them. Cost: n log n as a rule, at worst
 * n for each that is kept.
 */
[[nodiscard]] std::vector<TimedPoint> thinnedPath(std::span<const TimedPoint> path,
                                                  double tolerance_m, std::size_t most = SIZE_MAX);

} // namespace berg
