#pragma once

#include "core/io/import/fields/import_table.h"
#include "core/io/import/fields/import_time.h"
#include "core/io/text/read_budget.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace berg {

/** Rules for all rows of a file. */
struct RowRules
{
    DateOrder order = DateOrder::MonthFirst;
    bool timeNeeded = false;     ///< a row without time is rejected
    bool timeApart = false;      ///< date and time of day have separate columns
    bool timeExpected = false;   ///< a row without time is noted
    Rejections* noted = nullptr; ///< receives what is left out of a row or changed; may be null
};

/** Input of a reader. */
struct ImportText
{
    std::string_view text;
    ReadBudget& budget;
    const ColumnMapping& mapping; ///< columns mapped by the user; the others are guessed
    std::optional<DateOrder> dates = {};
    /**
     * Number of lines above the text, which then begins with the header chosen by the user; nullopt
     * if the header is to be found.
     */
    std::optional<std::size_t> linesAbove = {};
};

/** Which rows are one iceberg, if no column says so. */
enum class RowIdentity : std::uint8_t
{
    OneIceberg, ///< all rows are one track
    EachRow     ///< each row is an iceberg of its own
};

/** Options for reading a file. */
struct ReadOptions
{
    std::string format = "auto"; ///< id of a format, or "auto" to detect it by content
    ColumnMapping mapping;       ///< columns mapped by the user
    /**
     * Order of dates such as 05/02/2021 in tables; nullopt to use the format's or that of the
     * file's other dates.
     */
    std::optional<DateOrder> dates = {};
    std::optional<std::size_t> headerLine = {}; ///< from 1; nullopt to find it
    std::optional<RowIdentity> rows = {};       ///< nullopt to decide by ids, names and places
    bool operator==(const ReadOptions&) const = default;
};

/**
 * Returns bytes that are not UTF-8 as UTF-8, or an empty text if they are UTF-8 already. Bytes with
 * the mark of UTF-16 are read as such, others as Windows-1252, as browsers do. Throws
 * `Error{WrongFormat}` if the bytes are empty or not text.
 */
[[nodiscard]] std::string textOfBytes(std::string_view bytes, const std::string& subject);

} // namespace berg
