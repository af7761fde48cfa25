#pragma once

#include "core/io/import/forecast/forecast_reading.h"

#include <stop_token>
#include <string>
#include <string_view>

namespace berg {

/** Returns true if the bytes begin as a forecast does: NetCDF, GRIB, or JSON with a time series. */
[[nodiscard]] bool looksLikeForecast(std::string_view bytes);

/**
 * Reads a forecast of wind, weather and sea; the content decides between a reply of MET Norway
 * (`forecastFromJson`), NetCDF after the CF conventions (classic or version 4) and GRIB edition 2.
 * Grids become regular in latitude and longitude, bilinear in the cells of the file; components
 * along the axes of a grid are turned to east and north.
 *
 * NetCDF and GRIB are read in a process of their own with bounded memory, so a file that breaks the
 * libraries ends that process alone. The thread waits, calls `progress` and ends the process when a
 * stop is requested.
 *
 * Throws `Error`: WrongFormat for other bytes; Unsupported if the build lacks the library;
 * InvalidInput with the variable for what is missing, in another unit, out of range or not in the
 * area and time; FileTooLarge (`ReadBudget`); FileUnreadable for a damaged file; `Stopped`.
 */
[[nodiscard]] ForecastReading forecastFromBytes(std::string_view bytes, const std::string& subject,
                                                const ForecastReadOptions& options = {},
                                                const ForecastProgress& progress = {},
                                                const std::stop_token& stop = {});

/** Reads a file as `forecastFromBytes`; also throws what `readFile` does. */
[[nodiscard]] ForecastReading loadForecastFile(const std::string& path,
                                               const ForecastReadOptions& options = {},
                                               const ForecastProgress& progress = {},
                                               const std::stop_token& stop = {});

} // namespace berg
