#pragma once

#include "core/plan/order_moves.h"

#include <cstdint>
#include <functional>

namespace berg {

/** Limits and reports of `improveBound`. All costs are those of `VisitCosts`. */
struct BoundOptions
{
    double gap = 0;             ///< stop at this gap relative to the order's cost
    std::int64_t workLimit = 0; ///< arcs looked at, roughly 2 ns each; checked now and then
    std::function<bool()> cut;  ///< asked at least every 10 ms; true ends the work; may be empty
    std::function<void(const VisitOrder& order, double bound)> onImproved; ///< may be empty
};

struct BoundResult
{
    double bound = 0;      ///< lower bound on the cost of every order, below the order's cost
    VisitOrder order;      ///< the best order known, at least as good as the one given
    bool reached = false;  ///< bound and cost are as close as asked for (1e-9 at least)
    std::int64_t work = 0; ///< arcs looked at
};

/**
 * Lower bound on the cost of all orders: Lagrangian relaxation of "each iceberg once" on the
 * position-layered graph, strengthened by ng-paths whose memory grows where the relaxed paths
 * visit an iceberg twice (dynamic ng-path relaxation: Roberti and Mingozzi 2014) and by a
 * truncated exact search; what cannot beat `order` is deleted on the way. Up to about 60 icebergs
 * this ends in the proof that `order` is optimal, or in a better one that is: then the bound is
 * 1e-9 of the cost below it, the margin kept for rounding. Above 127 icebergs only the
 * relaxation without memory is computed.
 */
[[nodiscard]] BoundResult improveBound(const VisitCosts& costs, const VisitOrder& order,
                                       const BoundOptions& options);

} // namespace berg
