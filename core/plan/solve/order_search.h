#pragma once

#include "core/base/random.h"
#include "core/plan/solve/order_moves.h"
#include "core/plan/solve/search_effort.h"

#include <cstdint>
#include <functional>

namespace berg {

/**
 * Iterated local search over visiting orders: descents by 2-opt, exchange and or-opt moves (pieces
 * of up to three, both directions), from greedy orders and from disturbed ones. Every move is
 * evaluated in O(1), also with asymmetric distances. Deterministic; the best order is available
 * whenever the effort is spent.
 */
template <class Costs>
class OrderSearch
{
public:
    /** Keeps references to `costs` and `effort`, which must outlive the search. */
    OrderSearch(const Costs& costs, SearchEffort& effort);

    /** Called with each new best order; may be empty. */
    std::function<void(const VisitOrder&)> onImproved;

    /** Best order so far; empty before the first one. */
    [[nodiscard]] const VisitOrder& best() const { return m_best; }

    /** Accepts an order from another search if it is better than the best one. */
    void accept(const VisitOrder& order);
    /** Makes a greedy order (nearest iceberg next) and accepts it. */
    void startGreedily();
    /**
     * Descends from the best order, which must exist, until a local optimum or until the effort is
     * spent.
     */
    void descend();
    /** Descends to local optima from greedy orders by several criteria, or until effort is spent.
     */
    void descendFromGreedyOrders();
    /**
     * Runs the iterated local search from the best order, which must exist, for `restarts` restarts
     * or until the effort is spent; it accepts slightly worse orders meanwhile. Does nothing with
     * fewer than three icebergs.
     */
    void disturb(std::int64_t restarts);

private:
    void descendFrom(const VisitOrder& order);

    const Costs& m_costs;
    SearchEffort& m_effort;
    Random m_random;
    VisitOrder m_best;
    double m_bestCost = 0;
};

} // namespace berg
