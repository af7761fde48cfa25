#pragma once

#include "core/plan/fleet/fleet_orders.h"

#include <cstdint>
#include <optional>

namespace berg {

/** Result of `bestCover`. */
struct FleetCover
{
    bool complete = false; ///< whether no better plan exists than the one found, or none at all
    std::optional<FleetPlan> plan; ///< total excess below the slack; nullopt if none was found
    std::int64_t work = 0;         ///< number of orders examined
};

/**
 * Returns the best plan, one order for each UAV, whose total excess is less than `slack`: set
 * partitioning by branching on the iceberg or UAV with the fewest orders. Ends early after
 * `workLimit` orders, or when stopped: the result is then the best plan found so far, and not
 * complete.
 */
[[nodiscard]] FleetCover bestCover(const FleetOrders& orders, double slack, std::int64_t workLimit,
                                   const StopCheck& isStopped);

/** Type of `bestCover` and of functions that do the same. */
using CoverFunction = FleetCover (*)(const FleetOrders&, double slack, std::int64_t workLimit,
                                     const StopCheck&);

} // namespace berg
