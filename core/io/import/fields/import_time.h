#pragma once

#include "core/scenario/utc_time.h"

#include <chrono>
#include <optional>
#include <string_view>

namespace berg {

/** Order of day and month in dates with slashes or points, such as 3/4/2021. */
enum class DateOrder
{
    MonthFirst,
    DayFirst
};

/**
 * Reads a date with or without a time of day, in the forms of files of sightings; returns nullopt
 * if it cannot be read. The result is UTC unless the text has an offset; without a time of day it
 * is midnight.
 * Dates: 2021-06-02, 2021/06/02, 20210602, 2021153 (day of the year), 6/2/2021, 06/02/21, 2-Jun-21,
 * 2 Jun 2021, 02.06.2021 (always day first). Years of two digits are 1970 to 2069, of four 1900 to
 * 2100.
 * Times after `T` or blank: 16:41, 16:41:07, 16:41:07.5, each with Z, +hh, +hh:mm or +hhmm, AM, PM;
 * or digits alone: hours and minutes without leading zeros (5 is 00:05), or six with seconds. 24:00
 * is the start of the next day, and 12:00:60, a leap second, is 12:01.
 */
[[nodiscard]] std::optional<UtcTime> parseSightingTime(std::string_view text, DateOrder order);

/**
 * Reads a time typed by the user, as `parseSightingTime`; also returns nullopt if day and month
 * could be exchanged.
 */
[[nodiscard]] std::optional<UtcTime> parseTypedTime(std::string_view text);

/**
 * Reads a time of day without its date in the same forms ("12:00", "1200Z"); returns nullopt for
 * any other text.
 */
[[nodiscard]] std::optional<std::chrono::milliseconds> parseTimeOfDay(std::string_view text);

/**
 * Returns the offset from UTC of "UTC", "GMT+1", "UTC-03:30", "+0200" or "Z", or nullopt for any
 * other text: names of zones do not show whether summer time applies.
 */
[[nodiscard]] std::optional<std::chrono::minutes> parseZone(std::string_view text);

/** Returns true if the text is a date that is another date with day and month exchanged. */
[[nodiscard]] bool hasTwoReadings(std::string_view text);

/**
 * Returns the order of a column of dates as one of them shows it, or nullopt if no part is above
 * 12.
 */
[[nodiscard]] std::optional<DateOrder> dateOrderOf(std::string_view text);

} // namespace berg
