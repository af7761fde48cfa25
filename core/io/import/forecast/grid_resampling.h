#pragma once

#include "core/io/import/forecast/forecast_reading.h"
#include "core/io/import/forecast/grid_layers.h"
#include "core/io/text/read_budget.h"

#include <stop_token>

namespace berg {

/**
 * Returns the forecast of a file on one regular grid, that of most of its layers; see
 * `forecastFromBytes`. Charges the budget with all that it stores. Throws `Error{InvalidInput}` if
 * there are no times, too many of them, no place in the area, no time in the window, or a value out
 * of range; `Stopped`.
 */
[[nodiscard]] ForecastReading resampled(GridSource& source, const ForecastReadOptions& options,
                                        ReadBudget& budget, const ForecastProgress& progress,
                                        const std::stop_token& stop);

} // namespace berg
