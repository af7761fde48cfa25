#pragma once

#include "core/plan/fleet/fleet_costs.h"
#include "core/plan/fleet/fleet_cover.h"
#include "core/plan/solve/proof_step.h"

#include <cstdint>
#include <functional>

namespace berg {

/** A plan from elsewhere, and what it cost to find. */
struct FleetSuggestion
{
    FleetPlan plan;
    std::int64_t work = 0;
};

/** As `LayeredBoundOptions`. */
struct FleetBoundOptions
{
    double gap = 0;
    std::int64_t workLimit = 0;
    std::int64_t memoryLimit_bytes = 0;
    CoverFunction cover = bestCover; ///< puts orders together
    std::function<bool()> cut;
    std::function<void(const FleetPlan& plan, double bound)> onImproved = {};
    std::function<FleetSuggestion(std::int64_t work, std::int64_t most)> suggest = {};
    /** Deletes nothing of the graphs and puts nothing together, so that multipliers and memory
     * alone say what the bound is. */
    bool relaxationOnly = false;
};

/** As `BoundResult`. */
struct FleetBoundResult
{
    double bound = 0;
    FleetPlan plan;
    bool reached = false;
    bool memoryOut = false;
    std::int64_t work = 0;
    ProofStep step{}; ///< of `relaxationOnly`: the best multipliers, and the memory of the graphs
};

/**
 * Lower bound on the cost of all plans, as `improveBound`: Lagrangian relaxation of "each iceberg
 * once" on the layered graphs of the UAVs (`FleetGraph`), in which ng memory grows where relaxed
 * paths visit an iceberg twice and from which is deleted what cannot beat the plan. The orders left
 * are put together to plans (`cover`), which ends the proof when they are not too many. When
 * not `isBounded`, suggestions are all there is, and there is no bound but 0.
 */
[[nodiscard]] FleetBoundResult improveFleetBound(const FleetCosts& costs, const FleetPlan& plan,
                                                 const FleetBoundOptions& options);

/** Up to 127 icebergs, and not for latency: how much sigma an order has in all, by which its legs
 * are weighted, is not known at the root of a graph. */
[[nodiscard]] bool isBounded(const FleetCosts& costs);

} // namespace berg
