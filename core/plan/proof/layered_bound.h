#pragma once

#include "core/plan/problem/formulation.h"
#include "core/plan/problem/order_costs.h"
#include "core/plan/proof/bound_loop.h"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace berg {

/** Inputs and callbacks of `improveBound` beside `BoundOptions`. */
struct LayeredBoundOptions
{
    /**
     * Called with each step of the proof in order; may be empty. If set, no intermediate gaps are
     * certified.
     */
    std::function<void(const ProofStep&)> onStep;
    /**
     * Multipliers to start from, one per node ([0] is ignored): those that an earlier call returned
     * for a similar problem save most of the first relaxation. Any values give a valid bound; for
     * mu between two solved ones, interpolated multipliers give a good one.
     */
    std::optional<Eigen::VectorXd> lambda;
    int warmSteps = 20; ///< steps of the first relaxation, with `lambda`
    /** With more arcs than this, gaps of 0.5 % and 0.2 % are certified before the requested one. */
    std::int64_t manyArcs = 2'000'000;
};

/**
 * Returns a lower bound on the cost of all orders: Lagrangian relaxation of "each iceberg once" on
 * the layered graph, strengthened by ng-paths whose memory grows where the relaxed paths visit an
 * iceberg twice (dynamic ng-path relaxation: Roberti and Mingozzi 2014) and by a truncated exact
 * search; parts that cannot beat `order` are deleted meanwhile. Ends with the proof that `order` or
 * a better order is optimal, unless a limit is reached first. For any multipliers, the bound is
 * valid to the last digit (`roundingMargin`). When the graph gets large, a bound within 0.5 % and
 * then one within 0.2 % is certified first, on the few orders that can beat the order by that much.
 * Above 127 icebergs only the relaxation without memory is computed. Throws `std::logic_error` if
 * `LayeredBoundOptions::lambda` has a wrong size.
 */
template <class Costs>
[[nodiscard]] BoundResult improveBound(const Costs& costs, const VisitOrder& order,
                                       const BoundOptions& options,
                                       const LayeredBoundOptions& layered = {});

/**
 * Returns the arcs of the position-indexed MILP that remain after deleting all arcs that no order
 * of at most `order`'s cost can use (`cutoffAbove`): every order that costs no more than `order`,
 * itself included, uses only the arcs returned. Sorted by position, from, to; the return leg of a
 * closed route is not an arc. Deletion continues until it no longer pays or the work limit is
 * reached; a stop leaves more arcs, all n (n - 1)^2 + n of them if it comes at once. `gap`,
 * `onImproved` and `suggest` should be left at their defaults. With the optimum as
 * `order` about 2 n arcs remain at 20 icebergs.
 */
[[nodiscard]] std::vector<MilpArc> survivingArcs(const VisitCosts& costs, const VisitOrder& order,
                                                 const BoundOptions& options);

} // namespace berg
