#pragma once

#include "core/plan/fleet/fleet_costs.h"
#include "core/plan/fleet/fleet_cover.h"
#include "core/plan/proof/proof_step.h"

#include <cstdint>
#include <functional>

namespace berg {

/** A plan from another search, and the work spent on it. */
struct FleetSuggestion
{
    FleetPlan plan;
    std::int64_t work = 0;
};

/**
 * Limits, callbacks and options of `improveFleetBound`; the members mean the same as in
 * `LayeredBoundOptions`.
 */
struct FleetBoundOptions
{
    double gap = 0;
    std::int64_t workLimit = 0;
    std::int64_t memoryLimit_bytes = 0;
    CoverFunction cover = bestCover; ///< combines orders into a plan
    std::function<bool()> isStopped;
    std::function<void(const FleetPlan& plan, double bound)> onImproved = {};
    std::function<FleetSuggestion(std::int64_t work, std::int64_t most)> suggest = {};
    /**
     * Deletes nothing from the graphs and combines no orders, so that the bound follows from
     * multipliers and memory alone.
     */
    bool relaxationOnly = false;
};

/** Result of `improveFleetBound`; the members mean the same as in `BoundResult`. */
struct FleetBoundResult
{
    double bound = 0;
    FleetPlan plan;
    bool reached = false;
    bool memoryOut = false;
    std::int64_t work = 0;
    ProofStep step{}; ///< with `relaxationOnly`: the best multipliers and the memory of the graphs
};

/**
 * Returns a lower bound on the cost of all plans, computed as by `improveBound`: Lagrangian
 * relaxation of "each iceberg once" on the layered graphs of the UAVs (`FleetGraph`). Ng memory
 * grows where relaxed paths visit an iceberg twice, and parts that cannot beat the plan are
 * deleted. The remaining orders are combined into plans (`cover`), which completes the proof if
 * they are not too many. If not `isBounded`, only suggestions improve the plan, and the bound is 0.
 * If the complete graphs exceed the memory limit, the bound is 0 too, and `memoryOut` is true.
 */
[[nodiscard]] FleetBoundResult improveFleetBound(const FleetCosts& costs, const FleetPlan& plan,
                                                 const FleetBoundOptions& options);

/**
 * Returns whether `improveFleetBound` gives a bound: up to 127 icebergs, and not for latency,
 * because the total sigma of an order, by which its legs are weighted, is not known at the root of
 * a graph.
 */
[[nodiscard]] bool isBounded(const FleetCosts& costs);

} // namespace berg
