#pragma once

#include "core/io/import/forecast/forecast_reading.h"
#include "core/io/text/read_budget.h"

#include <stop_token>
#include <string_view>

namespace berg {

/** Returns true if this program was built to read NetCDF. */
[[nodiscard]] bool readsNetcdf();

/**
 * Reads a NetCDF file in this process; see `forecastFromBytes`. A quantity is found by the standard
 * name of a variable, else by its name, in the layer next to the sea; of an ensemble the first
 * member is taken. Without libnetcdf it throws `Error{Unsupported}`.
 */
[[nodiscard]] ForecastReading netcdfForecast(std::string_view bytes,
                                             const ForecastReadOptions& options, ReadBudget& budget,
                                             const ForecastProgress& progress,
                                             const std::stop_token& stop);

} // namespace berg
