#pragma once

#include "core/earth/forecast.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** Columns of a forecast after its time; winds come from a direction, currents flow to one. */
inline constexpr std::array<std::string_view, 7> kForecastColumns{
    "wind_speed_mps", "wind_from_deg",     "gust_mps",      "air_temperature_degC",
    "fog_percent",    "current_speed_mps", "current_to_deg"};

/**
 * Returns the values of an entry in the order of `kForecastColumns`, rounded; a missing one is
 * empty. A direction is also empty where there is no speed.
 */
[[nodiscard]] std::array<std::string, kForecastColumns.size()>
forecastCells(const ForecastEntry& entry);

/** Returns the series as CSV: `time` and `kForecastColumns`. */
[[nodiscard]] std::string forecastCsv(const Forecast& forecast);

/** Returns source, issue, place, series, gaps and quantities never given as one JSON document. */
[[nodiscard]] std::string forecastJson(const Forecast& forecast,
                                       const std::vector<ForecastGap>& gaps);

} // namespace berg
