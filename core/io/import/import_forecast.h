#pragma once

#include "core/earth/forecast.h"

#include <stop_token>
#include <string>
#include <string_view>

namespace berg {

/**
 * Reads a point forecast of MET Norway in JSON: locationforecast 2.0 (wind, gust, air temperature,
 * dew point, fog) or oceanforecast 2.0 (current); see developer.yr.no/doc/ForecastJSON. Winds come
 * *from* a direction and currents flow *towards* one. A value that is missing or null, or a speed
 * or direction without the other, is a gap. Throws `Error`: FileTooLarge (`ReadBudget`);
 * SyntaxError for broken JSON; WrongFormat if the text has no `properties.timeseries`; InvalidInput
 * with all faults for a missing place, times that do not rise, another unit, a value of the wrong
 * type or out of range, or a series without wind and current; `Stopped` if a stop is requested.
 */
[[nodiscard]] Forecast forecastFromJson(std::string_view text, const std::string& subject,
                                        const std::stop_token& stop = {});

/** Reads a file as `forecastFromJson`; also throws what `readFile` does. */
[[nodiscard]] Forecast loadForecast(const std::string& path);

} // namespace berg
