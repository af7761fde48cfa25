#pragma once

#include "core/plan/fleet/fleet_orders.h"

#include <cstdint>
#include <optional>

namespace berg {

/** What `bestCover` found. */
struct FleetCover
{
    bool complete = false;         ///< there is no better plan than the one found, or none
    std::optional<FleetPlan> plan; ///< of less than the slack in all
    std::int64_t work = 0;         ///< orders looked at
};

/**
 * The best plan put together from the orders, one for each UAV, whose excess is less than `slack`
 * in all: set partitioning by branching on the iceberg or UAV with the fewest orders.
 */
[[nodiscard]] FleetCover bestCover(const FleetOrders& orders, double slack, std::int64_t workLimit,
                                   const CutQuestion& cut);

/** `bestCover`, or another way to find it. */
using CoverFunction = FleetCover (*)(const FleetOrders&, double slack, std::int64_t workLimit,
                                     const CutQuestion&);

} // namespace berg
