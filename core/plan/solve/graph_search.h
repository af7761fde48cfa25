#pragma once

#include "core/plan/solve/layered_graph.h"

namespace berg {

/** How far `searchGraph` goes. */
struct GraphSearchLimits
{
    int mostStates = 0; ///< kept for each number of visits
    /** Fewer states are kept when so many would take more than this. */
    std::int64_t memory_bytes = std::numeric_limits<std::int64_t>::max();
    CutQuestion cut; ///< a search that is cut has a bound of -infinity and no order
};

/** What a truncated search over the orders inside a layered graph found. */
struct GraphSearchResult
{
    double bound = 0;      ///< as computed; infinite when none inside is below the cutoff
    VisitOrder order;      ///< best order found below the cutoff, empty when there is none
    std::int64_t work = 0; ///< arcs looked at
};

/**
 * Dynamic programming over (set of icebergs visited, last one) along the paths of a swept graph,
 * keeping `mostStates` for each number of visits at most: those of least length + completion. The
 * least value dropped is a lower bound on every order lost by that; if nothing is dropped, the
 * answer is exact. Costs are those of the orders, also where the graph knows bounds on them only.
 */
template <class Costs>
[[nodiscard]] GraphSearchResult searchGraph(const LayeredGraph<Costs>& graph,
                                            const Multipliers& multipliers,
                                            const GraphSearchLimits& limits);

} // namespace berg
