#pragma once

#include "core/plan/fleet/fleet_costs.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace berg {

/**
 * Returns the best plan by dynamic programming: the cheapest order of every set of icebergs for
 * each UAV, then the cheapest partition of every set among the first UAVs. Up to
 * `kMostFleetSubsets` icebergs (else `std::logic_error`); time O(uavs (2^n n^2 + 3^n)). `isStopped`
 * is called at least every 10 ms; returns nullopt once it returns true.
 */
[[nodiscard]] std::optional<FleetPlan> bestFleetPlan(const FleetCosts& costs,
                                                     const std::function<bool()>& isStopped);

/** Largest number of icebergs for `bestFleetPlan`. */
inline constexpr int kMostFleetSubsets = 14;

/** Returns the work of `bestFleetPlan` in the unit of `SolveOptions::workLimit`. */
[[nodiscard]] std::int64_t fleetSubsetWork(int uavs, int icebergs);
/** Returns the memory of `bestFleetPlan`, bytes. */
[[nodiscard]] std::int64_t fleetSubsetBytes(int uavs, int icebergs);

} // namespace berg
