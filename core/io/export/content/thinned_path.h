#pragma once

#include "core/io/export/content/geo_shapes.h"

#include <cstdint>
#include <span>
#include <vector>

namespace berg {

/**
 * Thins a path by the method of Ramer, Douglas and Peucker. Returns the kept points including the
 * first and the last, so that no other point is farther than `tolerance_m` from the line through
 * them. If more than `most` would be kept, returns `most` + 1 of them. Cost: usually n log n, at
 * worst n for each kept point.
 */
[[nodiscard]] std::vector<TimedPoint> thinnedPath(std::span<const TimedPoint> path,
                                                  double tolerance_m, std::size_t most = SIZE_MAX);

} // namespace berg
