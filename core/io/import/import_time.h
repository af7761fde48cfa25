#pragma once

#include "core/io/text/utc_time.h"

#include <chrono>
#include <optional>
#include <string_view>

namespace berg {

/** How dates with slashes or points, such as 3/4/2021, are written in a file. */
enum class DateOrder
{
    MonthFirst,
    DayFirst
};

/**
 * Instant of a date, with or without a time of day, as files of sightings have it; none when it
 * cannot be read. UTC unless it names an offset; without a time of day it is midnight.
 * Dates: 2021-06-02, 2021/06/02, 20210602, 2021153 (day of the year), 6/2/2021, 06/02/21, 2-Jun-21,
 * 2 Jun 2021, 02.06.2021 (always day first). Years of two digits are 1970 to
 * 2069, of four 1900 to 2100.
 * Times after `T` or blank: 16:41, 16:41:07, 16:41:07.5, each with Z, +hh, +hh:mm or +hhmm, AM, PM;
 * or digits alone: hours and minutes with lost zeros (5 is 00:05).
 */
[[nodiscard]] std::optional<UtcTime> parseSightingTime(std::string_view text, DateOrder order);

/** As `parseSightingTime` of a text by itself; nullopt too where day and month can be exchanged. */
[[nodiscard]] std::optional<UtcTime> parseTypedTime(std::string_view text);

/** Time of a day without its date, in the same forms: "12:00", "1200Z"; nullopt for any other. */
[[nodiscard]] std::optional<std::chrono::milliseconds> parseTimeOfDay(std::string_view text);

/** Whether the text is a date, and another one when it is read the other way. */
[[nodiscard]] bool hasTwoReadings(std::string_view text);

/** Tells the order of a column of dates from one of them: none unless a part is above 12. */
[[nodiscard]] std::optional<DateOrder> dateOrderOf(std::string_view text);

} // namespace berg
