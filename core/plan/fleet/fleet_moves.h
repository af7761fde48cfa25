#pragma once

#include "core/plan/fleet/fleet_routes.h"
#include "core/plan/solve/search_effort.h"

#include <array>

namespace berg {

/** New orders for one or two UAVs, as pieces of the old ones. */
struct FleetMove
{
    struct Part
    {
        int uav = 0;
        std::array<RoutePiece, 5> pieces{};
    };

    double gain = 0; ///< of cost; a move that gains nothing is none
    std::array<Part, 2> parts{};
    int partCount = 0;
};

// The best move, or what has been found when the effort is spent.

/** Within the order of a UAV: 2-opt, or-opt of up to three icebergs in both directions, exchange.
 */
[[nodiscard]] FleetMove bestMoveWithin(const FleetRoutes& routes, int uav, SearchEffort& effort);

/**
 * Between two orders: 2-opt* (exchange of the tails), and up to three icebergs of `from`, in both
 * directions, moved to `to` or exchanged for one of its icebergs.
 */
[[nodiscard]] FleetMove bestMoveBetween(const FleetRoutes& routes, int from, int to,
                                        SearchEffort& effort);

/** False, and nothing is done, when all that the move gains is rounding. */
[[nodiscard]] bool apply(FleetRoutes& routes, const FleetMove& move);

} // namespace berg
