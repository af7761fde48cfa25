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
 * valued in O(1), asymmetric distances included. Deterministic; the best order is kept throughout,
 * whenever the effort is spent.
 */
template <class Costs>
class OrderSearch
{
public:
    /** Keeps references to `costs` and `effort`. */
    OrderSearch(const Costs& costs, SearchEffort& effort);

    /** Called with each new best order; may be empty. */
    std::function<void(const VisitOrder&)> onImproved;

    /** Best order so far; empty before the first one. */
    [[nodiscard]] const VisitOrder& best() const { return m_best; }

    /** Takes an order from elsewhere, if it is a better one. */
    void take(const VisitOrder& order);
    /** A greedy order, at once the best one when it is the first. */
    void startGreedily();
    /** Goes down from the best order to a local optimum. */
    void descend();
    /** Local optima from greedy orders of several kinds. */
    void descendFromGreedyOrders();
    /** Iterated local search from the best order; accepts slightly worse orders on the way. */
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
