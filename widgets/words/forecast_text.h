#pragma once

#include "core/earth/forecast_field.h"

#include <QLocale>
#include <QString>

#include <optional>

namespace berg {

/**
 * Returns the source and age of a forecast: "Forecast of MET Norway, issued 2026-11-30 06:00 UTC,
 * 6 h before the start". Without a start the age is left out.
 */
[[nodiscard]] QString forecastText(const ForecastField& forecast,
                                   const std::optional<ForecastTime>& start, const QLocale& locale);

/** Returns the name of the source on one line. */
[[nodiscard]] QString forecastSource(const ForecastField& forecast);
/** Returns the end of `forecastText`: "issued 2026-11-30 06:00 UTC, 6 h before the start". */
[[nodiscard]] QString forecastIssue(const ForecastField& forecast,
                                    const std::optional<ForecastTime>& start,
                                    const QLocale& locale);

/** Returns the hours from the issue of a forecast to a time, if they exceed `kOldForecast_h`. */
[[nodiscard]] std::optional<double> oldForecast_h(const ForecastField& forecast, ForecastTime time);

/** Returns the names of the quantities that the forecast gives: "wind, gusts, current". */
[[nodiscard]] QString forecastQuantitiesText(const ForecastField& forecast);

} // namespace berg
