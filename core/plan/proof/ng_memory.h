#pragma once

#include "core/plan/proof/layered_graph.h"

#include <span>
#include <vector>

namespace berg {

/** Returns sets in which every iceberg remembers its `count` nearest ones, in all bands. */
[[nodiscard]] NgSets nearestSets(const LegTable& costs, int count);

/**
 * Extends the sets so that the icebergs between the two ends of each cycle of the paths (icebergs
 * in order) remember the iceberg of the cycle, in the band of the cycle and those near it. The
 * shortest cycles come first, at most 800. A cycle is skipped if a memory on it is full, with `cap`
 * icebergs; memories in the bands near it hold at most `cap` + 2. Many memories that grow at once
 * would make the graph explode.
 */
template <class Costs>
void forbidCycles(NgSets& sets, const Costs& costs, std::span<const VisitOrder> paths, int cap);

} // namespace berg
