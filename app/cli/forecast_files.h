#pragma once

#include "core/earth/forecast.h"
#include "core/io/import/import_forecast_file.h"
#include "core/io/results/forecast_result.h"
#include "core/scenario/utc_time.h"

#include <optional>
#include <string>
#include <vector>

namespace berg::cli {

/** Forecasts of several files, and what is known about their use. */
struct ForecastFiles
{
    std::vector<std::string> files;
    std::vector<Forecast> forecasts;        ///< one of each file
    std::vector<ForecastGridFacts> grids{}; ///< of the files that hold more than one place
};

/** Which part of the forecasts of files is used. */
struct ForecastPart
{
    std::optional<LatLon> place; ///< nullopt for the place of the first file, or its middle
    std::optional<GeoBox> area;  ///< nullopt for all of a grid, or the nodes around `place`
    std::optional<UtcTime> since;
    std::optional<UtcTime> until;
};

/** Reads the files, in any format that `forecastFromBytes` knows; Ctrl-C may end it at once. */
[[nodiscard]] ForecastFiles readForecasts(const std::vector<std::string>& files,
                                          const ForecastPart& part = {});

/** Reads one file as `readForecasts` does. */
[[nodiscard]] ForecastReading readForecastFile(const std::string& file,
                                               const ForecastReadOptions& options);

/** Returns the area of "SOUTH,WEST,NORTH,EAST" in degrees, nullopt for an empty text. */
[[nodiscard]] std::optional<GeoBox> areaOf(const std::string& text);

/** Returns the words for a quantity in the user's language. */
[[nodiscard]] std::string saidQuantity(ForecastQuantity quantity);

/** Warns of each file that was issued more than `kOldForecast_h` before the time of use. */
void warnOfOldForecasts(const ForecastFiles& files, UtcTime use);

/** Warns of each file that is for a place more than 25 km from the place of use. */
void warnOfFarForecasts(const ForecastFiles& files, LatLon use);

/** Warns of a forecast that was issued `age_h` before its use, if that is long. */
void warnOfAge(const std::string& file, const std::optional<double>& age_h, UtcTime use);

/** Notes that a grid was thinned. */
void noteThinning(const std::string& file, std::size_t thinning);

/** Warns of each gap. */
void warnOfGaps(const std::vector<ForecastGap>& gaps);

} // namespace berg::cli
