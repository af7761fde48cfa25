#pragma once

#include "core/plan/solve/layered_graph.h"

#include <span>
#include <vector>

namespace berg {

/** Every iceberg remembers its `count` nearest ones, in all bands. */
[[nodiscard]] NgSets nearestSets(const LegTable& costs, int count);

/**
 * Makes the icebergs between the two ends of each cycle of the paths (icebergs in turn)
 * remember its iceberg, the shortest cycles first and as far as no memory grows above `cap`: many
 * memories grown at once would make the graph explode.
 */
template <class Costs>
void forbidCycles(NgSets& sets, const Costs& costs, std::span<const std::vector<int>> paths,
                  int cap);

} // namespace berg
