#pragma once

#include "core/plan/solve/formulation.h"
#include "core/plan/solve/order_costs.h"
#include "core/plan/solve/proof_step.h"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace berg {

/** An order from elsewhere, and what it cost to find; empty when there is none. */
struct OrderSuggestion
{
    VisitOrder order;
    std::int64_t work = 0;
};

/** Limits, help and reports of `improveBound`. */
struct LayeredBoundOptions
{
    double gap = 0;             ///< stop at this gap relative to the order's cost
    std::int64_t workLimit = 0; ///< arcs looked at, roughly 2 ns each; checked now and then
    std::function<bool()> cut;  ///< asked at least every 10 ms; true ends the work; may be empty
    std::function<void(const VisitOrder& order, double bound)> onImproved; ///< may be empty
    /** With all of the proof, in turn; may be empty. No other gaps are certified on the way then.
     */
    std::function<void(const ProofStep&)> onStep;
    /**
     * Multipliers to start from, one per node ([0] is ignored): those that an earlier call
     * returned for a similar problem save most of the first relaxation. Any values give a valid
     * bound; for mu between two solved ones, interpolated multipliers give a good one.
     */
    std::optional<Eigen::VectorXd> lambda;
    std::int64_t warmSteps = 20; ///< of the first relaxation, with `lambda`
    /** Graphs that would need more are not built; about, and beside n^3 / 250 kB at least. */
    std::int64_t memoryLimit_bytes = 1'500'000'000;
    /** Larger graphs make it certify gaps of 0.5 % and 0.2 % before the one asked for. */
    std::int64_t manyArcs = 2'000'000;
    /**
     * Asked for a better order right after the first bound (the gap is not looked at before) and
     * then after every round; `work` is what has been done, `most` what is left. May be empty.
     */
    std::function<OrderSuggestion(std::int64_t work, std::int64_t most)> suggest;
};

struct BoundResult
{
    double bound = 0;       ///< lower bound on the cost of every order, below the order's cost
    VisitOrder order;       ///< the best order known, at least as good as the one given
    bool reached = false;   ///< bound and cost are as close as asked for (`kProofTolerance`)
    bool memoryOut = false; ///< ended by the memory limit
    std::int64_t work = 0;  ///< arcs looked at, that of the suggestions included
    Eigen::VectorXd lambda; ///< the best multipliers, one per node, [0] is 0
};

/**
 * Lower bound on the cost of all orders: Lagrangian relaxation of "each iceberg once" on the
 * layered graph, strengthened by ng-paths whose memory grows where the relaxed paths
 * visit an iceberg twice (dynamic ng-path relaxation: Roberti and Mingozzi 2014) and by a
 * truncated exact search; what cannot beat `order` is deleted on the way. Ends in the proof that
 * `order` is optimal, or in a better one that is, unless a limit comes first. Whatever the
 * multipliers, the bound is true to the last digit (`roundingMargin`). When the graph gets large, a
 * bound within 0.5 % and then one within 0.2 % is certified first, on what little can beat the
 * order by so much. Above 127 icebergs only the relaxation without memory is computed.
 */
template <class Costs>
[[nodiscard]] BoundResult improveBound(const Costs& costs, const VisitOrder& order,
                                       const LayeredBoundOptions& options);

/**
 * The arcs of the position-indexed MILP that are left when all arcs have been deleted which no
 * order of at most `order`'s cost can use (`cutoffAbove`): every order that costs no more
 * than `order`, itself included, runs on the arcs returned. Sorted by position, from, to; the way
 * back of a closed route is no arc. Deletion goes on until it no longer pays or the work limit is
 * reached; a cut leaves more arcs, all n (n - 1)^2 + n of them when it comes at once. `gap` and
 * `onImproved` are not used. With the optimum as `order` about 2 n arcs are left at 20 icebergs.
 */
[[nodiscard]] std::vector<MilpArc> survivingArcs(const VisitCosts& costs, const VisitOrder& order,
                                                 const LayeredBoundOptions& options);

} // namespace berg
