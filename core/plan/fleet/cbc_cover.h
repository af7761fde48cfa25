#pragma once

#include "core/plan/fleet/fleet_cover.h"

namespace berg {

/**
 * As `bestCover`, by CBC's branch and cut on the set partitioning: a binary column for each order,
 * a row for each iceberg and for each UAV. Not complete above `kMostCoverColumns` orders, when cut,
 * or when CBC fails; `workLimit` counts orders here too.
 */
[[nodiscard]] FleetCover bestCoverByCbc(const FleetOrders& orders, double slack,
                                        std::int64_t workLimit, const CutQuestion& cut);

inline constexpr std::size_t kMostCoverColumns = 30'000;

} // namespace berg
