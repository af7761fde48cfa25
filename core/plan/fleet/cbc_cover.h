#pragma once

#include "core/plan/fleet/fleet_cover.h"

namespace berg {

/**
 * As `bestCover`, by CBC's branch and cut on the set partitioning: a binary column for each order,
 * a row for each iceberg and for each UAV, in the program `bergwatch-cbc`. Not complete above
 * `kMostCoverColumns` orders or when cut; `workLimit` counts orders here too. Throws
 * `Error{SolverFailed}` when CBC or that program fails.
 */
[[nodiscard]] FleetCover bestCoverByCbc(const FleetOrders& orders, double slack,
                                        std::int64_t workLimit, const CutQuestion& cut);

inline constexpr std::size_t kMostCoverColumns = 30'000;

} // namespace berg
