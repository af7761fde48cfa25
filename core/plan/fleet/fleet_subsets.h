#pragma once

#include "core/plan/fleet/fleet_costs.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace berg {

/**
 * The best plan by dynamic programming: for each UAV the cheapest order of every set of icebergs,
 * then the cheapest way to share out every set among the first UAVs. Up to `kMostFleetSubsets`
 * icebergs; time O(uavs (2^n n^2 + 3^n)). `cut` is asked at least every 10 ms; none when it says
 * yes.
 */
[[nodiscard]] std::optional<FleetPlan> bestFleetPlan(const FleetCosts& costs,
                                                     const std::function<bool()>& cut);

inline constexpr int kMostFleetSubsets = 14;

/** Work of it, in the unit of `SolveOptions::workLimit`, and memory. */
[[nodiscard]] std::int64_t fleetSubsetWork(int uavs, int icebergs);
[[nodiscard]] std::int64_t fleetSubsetBytes(int uavs, int icebergs);

} // namespace berg
