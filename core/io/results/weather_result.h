#pragma once

#include "core/checks/weather_gate.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace berg {

/**
 * Returns the verdict on the weather in one line: "no-go  uav-1: wind 12.3 m/s at 2026-05-01 14:20
 * UTC, limit 10 m/s". Without `startUtc` the time is "at 1200 s".
 */
[[nodiscard]] std::string weatherLine(const ScenarioWorld& scenario, const WeatherVerdict& weather);

/** Returns the reason in words, without the state, such as "wind 12.3 m/s, limit 10 m/s". */
[[nodiscard]] std::string reasonText(const WeatherReason& reason);

/**
 * Returns the verdict as JSON: `state`, and `uavs` with `id`, `state` and, unless it is "go",
 * `limit`, `value`, `limit_value` and `time_s`.
 */
[[nodiscard]] nlohmann::ordered_json weatherTree(const std::vector<std::string>& uavIds,
                                                 const WeatherVerdict& weather);

} // namespace berg
