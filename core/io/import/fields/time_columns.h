#pragma once

// Private to core/io: tables with a time in several columns, or with its zone in one.

#include "core/io/text/csv_reader.h"

#include <array>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** Part of a time that a column holds. */
enum class TimePart
{
    Year,
    Month, ///< as a number or by its name
    Day,
    DayOfYear, ///< from 1, possibly with a fraction
    Hour,
    Minute,
    Second,
    Zone ///< offset from UTC
};

/** Columns of a table that hold parts of a time. */
struct TimeColumns
{
    std::array<std::optional<std::size_t>, 8> column; ///< by `TimePart`

    /** Returns the column of a part, or nullopt if there is none. */
    [[nodiscard]] std::optional<std::size_t> of(TimePart part) const
    {
        return column.at(static_cast<std::size_t>(part));
    }
    /**
     * Returns true if the columns form a date: year and day of the year, or year, month and day.
     */
    [[nodiscard]] bool formDate() const;
    /**
     * Returns the first column that is a part of a date or the hour, or nullopt if there is none.
     */
    [[nodiscard]] std::optional<std::size_t> firstPart() const;
};

/** Returns the part of a time that a column of this name holds, or nullopt for any other name. */
[[nodiscard]] std::optional<TimePart> timePartOf(std::string_view name);

/** Finds the columns by their names; `isFree` says whether a column has no other use. */
[[nodiscard]] TimeColumns timeColumnsOf(const std::vector<std::string>& header,
                                        const std::function<bool(const std::string&)>& isFree);

/**
 * Returns the date of a row in a form that `parseSightingTime` reads, without a fraction of the
 * day. If the cells form no date, returns the cells that are not empty, joined by hyphens and each
 * cut to 40 bytes; an empty text if all are empty.
 */
[[nodiscard]] std::string dayOfParts(const TimeColumns& columns, const CsvRow& row);
/**
 * Returns the time of day of a row in a form that `parseTimeOfDay` reads, or the cells unchanged if
 * they form no time; it is empty if all of them are empty.
 */
[[nodiscard]] std::string clockOfParts(const TimeColumns& columns, const CsvRow& row);
/**
 * Returns date and time of day in a form that `parseSightingTime` reads, if the cells form them; a
 * fraction of the day is part of the time.
 */
[[nodiscard]] std::string timeOfParts(const TimeColumns& columns, const CsvRow& row);

/**
 * Returns the offset from UTC of a cell, as `parseZone` or in hours (quarters of an hour, at most
 * 14), or nullopt for any other text, such as the name of a zone.
 */
[[nodiscard]] std::optional<std::chrono::minutes> zoneOfCell(std::string_view cell);

} // namespace berg
