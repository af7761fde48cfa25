#pragma once

#include "core/earth/forecast_field.h"
#include "core/io/import/scenario/import_scenario.h"

#include <functional>
#include <optional>
#include <string>

namespace berg {

/** Most places of a forecast that is read, and places times instants; a grid with more is thinned.
 */
inline constexpr std::size_t kMostReadPlaces = 10'000;
inline constexpr std::size_t kMostReadEntries = 100'000;

/** Which part of a forecast is read. */
struct ForecastReadOptions
{
    std::optional<GeoBox> area;                 ///< and the next nodes around it; nullopt for all
    std::optional<ForecastTime> since;          ///< and the last instant before it
    std::optional<ForecastTime> until;          ///< and the first instant after it
    std::size_t mostEntries = kMostReadEntries; ///< places times instants
    bool operator==(const ForecastReadOptions&) const = default;
};

/** A forecast from a file. */
struct ForecastReading
{
    std::string format; ///< "MET Norway JSON", "NetCDF" or "GRIB"
    ForecastField field;
    /** 1 if the grid is as fine as that of the file, 2 if half as fine in each direction, ... */
    std::size_t thinning = 1;
    bool operator==(const ForecastReading&) const = default;
};

/** Called with the share of the work done, from 0 to 1. */
using ForecastProgress = std::function<void(double)>;

} // namespace berg
