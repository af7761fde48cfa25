#pragma once

#include "core/base/geometry.h"

#include <span>
#include <vector>

namespace berg {

/**
 * Points in groups of at most `most`, as few groups as can be, each spread over the whole field
 * (neighbours go to different groups). Indices, ascending in each group.
 */
[[nodiscard]] std::vector<std::vector<int>> spreadGroups(std::span<const Point> points_m, int most);

} // namespace berg
