#pragma once

#include "core/plan/fleet/fleet_costs.h"
#include "core/plan/fleet/fleet_cover.h"
#include "core/plan/proof/bound_loop.h"

namespace berg {

/** Options of `improveFleetBound` beside `BoundOptions`. */
struct FleetBoundOptions
{
    CoverFunction cover = bestCover; ///< combines orders into a plan
    /**
     * Deletes nothing from the graphs and combines no orders, so that the bound follows from
     * multipliers and memory alone.
     */
    bool relaxationOnly = false;
};

/**
 * Returns a lower bound on the cost of all plans, computed as by `improveBound`: Lagrangian
 * relaxation of "each iceberg once" on the layered graphs of the UAVs (`FleetGraph`). Ng memory
 * grows where relaxed paths visit an iceberg twice, and parts that cannot beat the plan are
 * deleted. The remaining orders are combined into plans (`cover`), which completes the proof if
 * they are not too many. If not `isBounded`, only suggestions improve the plan, and the bound is 0.
 * If the complete graphs exceed the memory limit, the bound is 0 too, and `memoryOut` is true.
 */
[[nodiscard]] BoundResult improveFleetBound(const FleetCosts& costs, const FleetPlan& plan,
                                            const BoundOptions& options,
                                            const FleetBoundOptions& fleet = {});

/**
 * Returns whether `improveFleetBound` gives a bound: up to 127 icebergs, and not for latency,
 * because the total sigma of an order, by which its legs are weighted, is not known at the root of
 * a graph.
 */
[[nodiscard]] bool isBounded(const FleetCosts& costs);

} // namespace berg
