#pragma once

#include "core/scenario/flight_weather.h"
#include "core/sim/intervention.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace berg {

/** Weather at one time of a run, towards east and north; a quantity that is unknown is nullopt. */
struct CoursePoint
{
    double time_s = 0;
    std::optional<Point> wind_mps;
    std::optional<double> gust_mps;
    std::optional<Point> current_mps;
    bool operator==(const CoursePoint&) const = default;
};

/** Wind, gusts and current over a run, at the place of the flight. */
struct WeatherCourse
{
    std::vector<CoursePoint> points; ///< times rise, from 0 to the end of the run
    std::string source;              ///< of the forecast; empty without one
    /** Run time at which the forecast was issued, negative before the start; nullopt if unknown. */
    std::optional<double> issued_s;
    std::optional<double> reported_s; ///< time from which the wind is one that the crew reported

    /** Returns whether a forecast is used. */
    [[nodiscard]] bool isForecast() const { return !source.empty(); }
    /** Returns the weather at a time of the run, which is linear between two points. */
    [[nodiscard]] CoursePoint at(double time_s) const;
};

/** Returns the start of a run with a usable forecast. */
[[nodiscard]] ForecastTime forecastStartOf(const Scenario& scenario);
/** Returns the source of a forecast, or "?" if it is not named. */
[[nodiscard]] std::string sourceOf(const ForecastField& forecast);

/**
 * Returns the weather of the flight (`FlightWeather`). A quantity that the forecast gives somewhere
 * is that of the forecast, and nullopt where it has a gap; any other quantity is the scenario's.
 * From a report of the crew among `changes` on, the wind is the reported one. Without a forecast,
 * calm water is nullopt. Cost: linear in the forecast.
 */
[[nodiscard]] WeatherCourse courseOf(const Scenario& scenario,
                                     std::span<const Intervention> changes = {});

/**
 * Returns the wind and current that apply at the flight's place at the start: those of the
 * forecast, and where it gives none those of the scenario.
 */
[[nodiscard]] CoursePoint weatherAtStart(const Scenario& scenario);

} // namespace berg
