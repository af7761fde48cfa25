#pragma once

#include "core/plan/proof/layered_graph.h"

namespace berg {

/** Limits of `searchGraph`. */
struct GraphSearchLimits
{
    int mostStates = 0; ///< largest number of states kept for each number of visits
    /** Memory limit; fewer states are kept if they would take more. */
    std::int64_t memory_bytes = std::numeric_limits<std::int64_t>::max();
    StopCheck isStopped; ///< if stopped, the search has a bound of -infinity and no order
};

/** Result of a truncated search over the orders inside a layered graph. */
struct GraphSearchResult
{
    double bound = 0;      ///< bound as computed; infinite if no order inside is below the cutoff
    VisitOrder order;      ///< best order found below the cutoff, empty if there is none
    std::int64_t work = 0; ///< number of arcs examined
};

/**
 * Searches the orders inside a swept graph by dynamic programming over (set of icebergs visited,
 * last one) along its paths, keeping at most `mostStates` for each number of visits: those of least
 * length + completion. The least value dropped is a lower bound on every order lost by that; if
 * nothing is dropped, the answer is exact. Costs are those of the orders, even where the graph only
 * has bounds on them.
 */
template <class Costs>
[[nodiscard]] GraphSearchResult searchGraph(const LayeredGraph<Costs>& graph,
                                            const Multipliers& multipliers,
                                            const GraphSearchLimits& limits);

} // namespace berg
