#pragma once

#include "core/earth/forecast.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** Columns of a forecast after its time; winds come from a direction, currents flow to one. */
inline constexpr std::array<std::string_view, 10> kForecastColumns{
    "wind_speed_mps",    "wind_from_deg",  "gust_mps",       "air_temperature_degC", "fog_percent",
    "current_speed_mps", "current_to_deg", "dew_point_degC", "visibility_m",         "ceiling_m"};
/** The first columns are in every file; the others only where the forecast gives a value. */
inline constexpr std::size_t kUsualForecastColumns = 7;

/**
 * Returns the values of an entry in the order of `kForecastColumns`, rounded; a missing one is
 * empty. A direction is also empty where there is no speed.
 */
[[nodiscard]] std::array<std::string, kForecastColumns.size()>
forecastCells(const ForecastEntry& entry);

/** Returns the quantities that a forecast should give, but never does. */
[[nodiscard]] std::vector<ForecastQuantity> missingQuantities(const Forecast& forecast);

/** Returns the series as CSV: `time` and the columns. */
[[nodiscard]] std::string forecastCsv(const Forecast& forecast);

/** Grid of the file that a forecast of one place is taken from. */
struct ForecastGridFacts
{
    std::string file;
    std::string format;
    std::size_t rows = 0;
    std::size_t columns = 0;
    LatLon southWest;
    LatLon northEast;
    std::size_t thinning = 1; ///< 2 if it is half as fine as the file in each direction, ...
};

/**
 * Returns source, issue, place, series, gaps, quantities never given and, if there are any, grids
 * as one JSON document.
 */
[[nodiscard]] std::string forecastJson(const Forecast& forecast,
                                       const std::vector<ForecastGap>& gaps,
                                       const std::vector<ForecastGridFacts>& grids = {});

} // namespace berg
