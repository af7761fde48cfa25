#pragma once

#include "core/scenario/scenario.h"

#include <functional>

namespace berg::test {

/** Start of scenarios with a forecast, and the same as a time. */
inline constexpr const char* kWeatherStart = "2026-11-30T12:00:00Z";
inline constexpr ForecastTime kWeatherStartTime{
    std::chrono::sys_days{std::chrono::year(2026) / std::chrono::November / 30} +
    std::chrono::hours(12)};

/** Makes the entry of a place for a number of hours after the start. */
using EntryAfter = std::function<ForecastEntry(const LatLon& place, double hours)>;

/**
 * Gives the scenario a forecast for `places` rows and columns, half a degree apart about its
 * origin, with an entry each hour from one hour before the start on.
 */
inline void letWeatherChange(Scenario& scenario, int places, int hours,
                             const EntryAfter& entryAfter)
{
    scenario.startUtc = kWeatherStart;
    ForecastField field{.columns = static_cast<std::size_t>(places), .places = {}};
    for (int row = 0; row < places; ++row)
        for (int column = 0; column < places; ++column) {
            Forecast forecast{
                .source = "test",
                .issued = kWeatherStartTime,
                .place = {scenario.origin.latitude_deg + 0.5 * (row - (places - 1) / 2.0),
                          scenario.origin.longitude_deg + 0.5 * (column - (places - 1) / 2.0)},
                .series = {},
                .depth_m = {}};
            for (int hour = -1; hour <= hours; ++hour) {
                forecast.series.push_back(entryAfter(forecast.place, hour));
                forecast.series.back().time = kWeatherStartTime + std::chrono::hours(hour);
            }
            field.places.push_back(std::move(forecast));
        }
    scenario.forecast = std::move(field);
}

/** A wind that grows from 0 at the start by `perHour_mps` each hour. */
inline EntryAfter growingWind(const Point& perHour_mps)
{
    return [perHour_mps](const LatLon&, double hours) {
        return ForecastEntry{.time = {}, .wind_mps = Point(perHour_mps * std::max(0.0, hours))};
    };
}

} // namespace berg::test
