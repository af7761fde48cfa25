#pragma once

#include "core/geometry/geometry.h"

#include <span>
#include <vector>

namespace berg {

/**
 * Divides points into as few groups of at most `most` as possible, each spread over the whole field
 * because neighbours go to different groups. Returns the indices of the points, ascending in each
 * group; no points give no groups. `most` must be positive.
 */
[[nodiscard]] std::vector<std::vector<int>> spreadGroups(std::span<const Point> points_m, int most);

} // namespace berg
