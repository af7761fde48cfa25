#pragma once

#include "core/sim/mission.h"

#include <functional>
#include <optional>
#include <stop_token>

namespace berg {

/** The scenario without what nobody knows before take-off: noise and recorded tracks. */
[[nodiscard]] Scenario foreseen(const Scenario& scenario, PolicyKind policy);

/**
 * What a flight with this policy is predicted to come to: the scenario flown in advance, from the
 * start to the end and planned again as in flight, without noise (w = 0) and with icebergs that
 * keep the velocities entered, recorded tracks left out; icebergs appear when the scenario says.
 * Plans are made without limits, so the forecast repeats. `onProgress` is told the share that is
 * flown. None when stopped. Throws as the constructor of `Mission`.
 */
[[nodiscard]] std::optional<Metrics> forecastOf(const Scenario& scenario, PolicyKind policy,
                                                const std::stop_token& stop = {},
                                                const std::function<void(double)>& onProgress = {});

/** So many tell what may come of a mission. */
inline constexpr int kDrawnFlights = 20;

/**
 * Zeta of flight `number` in a world drawn as the scenario says: noise, velocities that nobody
 * knows, looks in vain; without recorded tracks, and never in the world of the scenario's own seed.
 * A number is the same world for every policy. None when stopped. Throws likewise.
 */
[[nodiscard]] std::optional<double> drawnZeta_m2s(const Scenario& scenario, PolicyKind policy,
                                                  int number, const std::stop_token& stop = {});

} // namespace berg
