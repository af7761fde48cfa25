#pragma once

#include "core/io/import/forecast/forecast_reading.h"
#include "core/io/text/read_budget.h"

#include <stop_token>
#include <string_view>

namespace berg {

/** Returns true if this program was built to read GRIB. */
[[nodiscard]] bool readsGrib();

/**
 * Reads messages of GRIB edition 2 in this process; see `forecastFromBytes`. Quantities are found
 * by discipline, category and number: wind at 10 m, gust, temperature and dew point at 2 m,
 * visibility, ceiling or cloud base, and the current nearest to the surface. Other messages are
 * skipped, and so are further members of an ensemble. Without ecCodes it throws
 * `Error{Unsupported}`.
 */
[[nodiscard]] ForecastReading gribForecast(std::string_view bytes,
                                           const ForecastReadOptions& options, ReadBudget& budget,
                                           const ForecastProgress& progress,
                                           const std::stop_token& stop);

} // namespace berg
