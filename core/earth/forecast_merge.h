#pragma once

#include "core/earth/forecast_field.h"

#include <span>

namespace berg {

/** Returns the forecast of one place, as `forecastAt`, with a cost that does not grow with the
 * grid. */
[[nodiscard]] Forecast nearForecastAt(const ForecastField& field, const LatLon& place);

/**
 * Combines forecasts of several sources, of the atmosphere and the ocean, on the grid that has most
 * places; of equal ones, the first. Each place gets what `combined` makes of the forecasts there,
 * except that source and time of issue are the same everywhere: all sources used, and the earliest
 * time. A forecast that ends at its edge applies beyond it. Requires at least one, each `isGrid`.
 */
[[nodiscard]] ForecastField combined(std::span<const ForecastField> fields);

} // namespace berg
