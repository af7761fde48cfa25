#pragma once

#include "core/scenario/scenario.h"

#include <optional>
#include <vector>

namespace berg {

/**
 * Two UAVs of one pad and altitude layer are planned to arrive at least so long apart: one landing
 * keeps the next one waiting no longer (`tests/bench/RESULTS.md`).
 */
inline constexpr double kRecoverySlot_s = 30;

/** Rows of the UAVs that land on the pad of UAV `uav` out of its altitude layer: their endurances
 * are limited, and separation is on. Never contains `uav`. */
[[nodiscard]] std::vector<int> padMates(const Scenario& scenario, std::size_t uav);

/**
 * What is withheld of a sortie with so much usable endurance, so that the UAV arrives a slot before
 * it ends, for a wait at the pad, and not within a slot of any of those `taken_s`: the times left
 * until mates have to be home. At most half of the endurance.
 */
[[nodiscard]] double withheldFor_s(double usable_s, std::vector<double> taken_s);

/** The same by UAV for the first sorties, which begin at once; 0 for those that have a pad or a
 * layer for themselves. */
[[nodiscard]] std::vector<double> withheldAtStart_s(const Scenario& scenario);

/** Returns when a sortie with so much withheld ends, after take-off; nullopt if it needs no slot.
 */
[[nodiscard]] std::optional<double> slotOfSortie_s(const Scenario& scenario, std::size_t uav,
                                                   double withheld_s);

} // namespace berg
