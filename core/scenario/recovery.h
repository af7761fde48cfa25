#pragma once

#include "core/scenario/scenario.h"

#include <optional>
#include <vector>

namespace berg {

/**
 * Least planned time between two arrivals at one pad in one altitude layer, s. One landing delays
 * the next by no more (`tests/bench/RESULTS.md`).
 */
inline constexpr double kRecoverySlot_s = 30;

/**
 * Returns the indices of other UAVs with limited endurance that land on the pad of UAV `uav` from
 * its altitude layer; empty if it is unlimited itself or there is no separation.
 */
[[nodiscard]] std::vector<int> padMates(const Scenario& scenario, std::size_t uav);

/**
 * Returns the endurance to withhold from a sortie with usable endurance `usable_s`, so that the UAV
 * arrives one slot before it ends, as a reserve for waiting at the pad, and not within a slot of
 * any time in `taken_s`, the times left until other UAVs must be home. At most half of the
 * endurance.
 */
[[nodiscard]] double withheldFor_s(double usable_s, std::vector<double> taken_s);

/**
 * Returns the endurance withheld from the first sortie of each UAV, s; the sorties begin together.
 * It is 0 for a UAV that shares no pad and layer.
 */
[[nodiscard]] std::vector<double> withheldAtStart_s(const Scenario& scenario);

/**
 * Returns the time after take-off at which a sortie of UAV `uav` with `withheld_s` withheld ends,
 * or nullopt if the UAV needs no slot (`padMates`).
 */
[[nodiscard]] std::optional<double> slotOfSortie_s(const Scenario& scenario, std::size_t uav,
                                                   double withheld_s);

} // namespace berg
