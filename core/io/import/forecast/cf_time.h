#pragma once

#include "core/earth/forecast.h"

#include <chrono>
#include <optional>
#include <string_view>

namespace berg {

/** Unit of time of a NetCDF variable, such as "hours since 1950-01-01". */
struct CfTimeUnit
{
    std::chrono::duration<double> unit{1};
    ForecastTime origin;
};

/**
 * Reads a unit of the CF conventions, 4.4: milliseconds, seconds, minutes, hours or days since a
 * date, with or without a time of day and an offset from UTC. `calendar` is the attribute of that
 * name, "" if there is none; the calendars with leap years of today are understood. In the calendar
 * "standard" (or "gregorian", or without one) a date before 15 October 1582 is one of the Julian
 * calendar. Returns nullopt for any other text.
 */
[[nodiscard]] std::optional<CfTimeUnit> cfTimeUnit(std::string_view unit,
                                                   std::string_view calendar);

/**
 * Returns the time of a value, rounded to milliseconds, or nullopt if it is not finite or is
 * outside the years 1000 to 3000.
 */
[[nodiscard]] std::optional<ForecastTime> cfTime(const CfTimeUnit& unit, double value);

} // namespace berg
