#pragma once

#include "core/sim/mission.h"

#include <optional>
#include <stop_token>

namespace berg {

/** The scenario without what nobody knows before take-off: noise and recorded tracks. */
[[nodiscard]] Scenario foreseen(const Scenario& scenario, PolicyKind policy);

/** So many flights in drawn worlds make a prediction. */
inline constexpr int kDrawnFlights = 20;

/**
 * Zeta of a flight with the policy in world `number` of those that the scenario describes: noise,
 * velocities that nobody knows, looks in vain; without recorded tracks, and never in the world of
 * the scenario's own seed. A number is the same world for every policy. Plans are made without
 * limits, so the flight repeats. Returns nullopt if stopped. Throws as the constructor of
 * `Mission`.
 */
[[nodiscard]] std::optional<double> drawnZeta_m2s(const Scenario& scenario, PolicyKind policy,
                                                  int number, const std::stop_token& stop = {});

} // namespace berg
