#pragma once

#include "core/earth/forecast.h"
#include "core/io/text/utc_time.h"

#include <optional>
#include <string>
#include <vector>

namespace berg::cli {

/** Forecasts of several files, and what is known about their use. */
struct ForecastFiles
{
    std::vector<std::string> files;
    std::vector<Forecast> forecasts; ///< one of each file
};

/** Reads the files; Ctrl-C may end it at once. */
[[nodiscard]] ForecastFiles readForecasts(const std::vector<std::string>& files);

/** Warns of each file that was issued more than `kOldForecast_h` before the time of use. */
void warnOfOldForecasts(const ForecastFiles& files, UtcTime use);

/** Warns of each file that is for a place more than 25 km from the place of use. */
void warnOfFarForecasts(const ForecastFiles& files, LatLon use);

/** Warns of each gap. */
void warnOfGaps(const std::vector<ForecastGap>& gaps);

} // namespace berg::cli
