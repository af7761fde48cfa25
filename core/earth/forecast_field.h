#pragma once

#include "core/earth/forecast.h"

#include <vector>

namespace berg {

/** Forecasts of one source at the places of a grid; a forecast for one place is a grid of one. */
struct ForecastField
{
    std::size_t columns = 1; ///< places in a row
    /**
     * Rows from south to north, each from west to east. Places in a row share their latitude, and
     * those in a column their longitude; all have the same source and time of issue.
     */
    std::vector<Forecast> places;
    std::string extraJson = {}; ///< unknown members of a scenario file
    bool operator==(const ForecastField&) const = default;
};

/** Returns true if the places are a complete grid as `ForecastField` describes it. */
[[nodiscard]] bool isGrid(const ForecastField& field);

/**
 * Returns the values at a place and time: `entryAt` of the four places around it, bilinear in
 * latitude and longitude. Outside the grid the values of its edge apply. Where a place lacks a
 * quantity, the others share its weight, and the result lacks it only if all do. Requires `isGrid`.
 */
[[nodiscard]] ForecastEntry entryAt(const ForecastField& field, const LatLon& place,
                                    ForecastTime time);

/** Returns the depth of the sea at a place, interpolated as the values of `entryAt`, or nullopt. */
[[nodiscard]] std::optional<double> depthAt_m(const ForecastField& field, const LatLon& place);

/** Returns the forecast of one place, with the times of the grid's first place; see `entryAt`. */
[[nodiscard]] Forecast forecastAt(const ForecastField& field, const LatLon& place);

} // namespace berg
