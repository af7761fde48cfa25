#pragma once

#include "core/mission/mission.h"

#include <optional>
#include <stop_token>

namespace berg {

/**
 * Returns the scenario with this policy and without drift noise and recorded tracks, because they
 * are unknown before take-off.
 */
[[nodiscard]] Scenario withoutUnknowns(const Scenario& scenario, PolicyKind policy);

/** Number of flights in randomly drawn worlds that make a prediction. */
inline constexpr int kDrawnFlights = 20;

/**
 * Flies the policy in random world `number` of the scenario and returns its zeta, Eq. (24). The
 * world has drift noise and the errors of the scenario's observer but no recorded tracks, and never
 * the scenario's own seed. A number gives the same world for every policy. Plans have no limits, so
 * the flight repeats. Returns nullopt if stopped. Throws as the constructor of `Mission`.
 */
[[nodiscard]] std::optional<double> drawnZeta_m2s(const Scenario& scenario, PolicyKind policy,
                                                  int number, const std::stop_token& stop = {});

} // namespace berg
