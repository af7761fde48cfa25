#pragma once

#include "core/plan/fleet/fleet_cover.h"

namespace berg {

/**
 * Finds the plan of `bestCover` by CBC's branch and cut on the set partitioning: a binary column
 * for each order, a row for each iceberg and for each UAV, in the program `bergwatch-cbc`. The
 * result is not complete, and has no plan, with more than `kMostCoverColumns` or `workLimit`
 * orders, without a positive slack, or when stopped. Throws `Error{SolverFailed}` if CBC or that
 * program fails, and `Error{Unsupported}` if the program is missing.
 */
[[nodiscard]] FleetCover bestCoverByCbc(const FleetOrders& orders, double slack,
                                        std::int64_t workLimit, const StopCheck& isStopped);

/** Largest number of orders that CBC gets. */
inline constexpr std::size_t kMostCoverColumns = 30'000;

} // namespace berg
