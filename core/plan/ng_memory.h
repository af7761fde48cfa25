#pragma once

#include "core/plan/layered_graph.h"

#include <span>
#include <vector>

namespace berg {

/** Every iceberg remembers its `count` nearest ones, in all positions. */
[[nodiscard]] NgSets nearestSets(const VisitCosts& costs, int count);

/**
 * Makes the icebergs between the two ends of each cycle of the paths (icebergs by position)
 * remember its iceberg, the shortest cycles first and as far as no memory grows above `cap`: many
 * memories grown at once would make the graph explode.
 */
void forbidCycles(NgSets& sets, std::span<const std::vector<int>> paths, int cap);

} // namespace berg
