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

} // namespace berg
