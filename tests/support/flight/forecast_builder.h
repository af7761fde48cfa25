#pragma once

#include "core/scenario/scenario.h"

#include <chrono>
#include <cmath>
#include <numbers>

// Forecasts for tests.

namespace berg::test {

/** Start of the runs with a forecast. */
inline constexpr const char* kForecastStart = "2026-05-01T12:00:00Z";
inline constexpr ForecastTime kForecastStartTime =
    std::chrono::sys_days(std::chrono::year(2026) / 5 / 1) + std::chrono::hours(12);

/** Wind of `forecastAround` after so many hours: 10 m/s from the west at the start, freshening and
 * veering by 15 degrees in each hour. */
inline Point forecastWind_mps(int hour)
{
    const double psi_rad = -15.0 * hour * std::numbers::pi / 180;
    return (10 + hour) * Point(std::cos(psi_rad), std::sin(psi_rad));
}

/**
 * Returns a forecast of 3 x 3 places around an origin, each hour from the start on, for `hours`,
 * issued 6 h before: the wind of `forecastWind_mps` in the middle, 20 % stronger to the north,
 * gusts 4 m/s above it, and a current of 0.5 m/s to the north east.
 */
inline ForecastField forecastAround(const LatLon& origin, int hours = 12)
{
    using namespace std::chrono_literals;
    ForecastField field{.columns = 3};
    for (int row = -1; row <= 1; ++row)
        for (int column = -1; column <= 1; ++column) {
            Forecast place{
                .source = "MET Norway",
                .issued = kForecastStartTime - 6h,
                .place = {origin.latitude_deg + 0.25 * row, origin.longitude_deg + 0.25 * column}};
            for (int hour = 0; hour <= hours; ++hour) {
                const Point wind_mps = (1 + 0.2 * row) * forecastWind_mps(hour);
                place.series.push_back({.time = kForecastStartTime + std::chrono::hours(hour),
                                        .wind_mps = wind_mps,
                                        .gust_mps = wind_mps.norm() + 4,
                                        .current_mps = Point(0.3, 0.4)});
            }
            field.places.push_back(std::move(place));
        }
    return field;
}

/** Gives a scenario a start and the forecast of `forecastAround`. */
inline void addForecast(Scenario& scenario, int hours = 12)
{
    scenario.startUtc = kForecastStart;
    scenario.forecast = forecastAround(scenario.origin, hours);
}

/** Removes the values of all places after `from` and before `to` hours from the start. */
inline void cutForecast(ForecastField& field, int from, int to)
{
    for (Forecast& place : field.places)
        std::erase_if(place.series, [&](const ForecastEntry& entry) {
            return entry.time > kForecastStartTime + std::chrono::hours(from) &&
                   entry.time < kForecastStartTime + std::chrono::hours(to);
        });
}

} // namespace berg::test
