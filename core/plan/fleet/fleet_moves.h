#pragma once

#include "core/plan/fleet/fleet_routes.h"
#include "core/plan/solve/search_effort.h"

#include <array>

namespace berg {

/** New orders for one or two UAVs, made of pieces of the old ones. */
struct FleetMove
{
    /** New order of one UAV; unused pieces are empty. */
    struct Part
    {
        int uav = 0;
        std::array<RoutePiece, 5> pieces{};
    };

    double gain = 0; ///< saving of cost; 0 if there is no move
    std::array<Part, 2> parts{};
    int partCount = 0;
};

// The two functions below return the best move, or the best one found until the effort was spent.
// If no move gains, `partCount` is 0.

/**
 * Returns the best move within the order of a UAV: 2-opt, or-opt of up to three icebergs in both
 * directions, exchange.
 */
[[nodiscard]] FleetMove bestMoveWithin(const FleetRoutes& routes, int uav, SearchEffort& effort);

/**
 * Returns the best move between two orders: 2-opt* (exchange of the tails), and up to three
 * icebergs of `from`, in both directions, moved to `to` or exchanged for one of its icebergs.
 */
[[nodiscard]] FleetMove bestMoveBetween(const FleetRoutes& routes, int from, int to,
                                        SearchEffort& effort);

/** Applies a move. Returns false, and changes nothing, if its gain is only rounding. */
[[nodiscard]] bool apply(FleetRoutes& routes, const FleetMove& move);

} // namespace berg
