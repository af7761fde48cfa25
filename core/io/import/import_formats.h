#pragma once

#include "core/io/import/import_table.h"
#include "core/io/import/import_time.h"
#include "core/io/text/read_budget.h"

#include <span>
#include <stop_token>
#include <string>
#include <string_view>

namespace berg {

class CsvReader;

/** What holds for all rows of a file. */
struct RowRules
{
    DateOrder order = DateOrder::MonthFirst;
    bool timeNeeded = false; ///< a row without time is rejected
    bool timeApart = false;  ///< date and time of day have a column each
};

/** What a reader is given. */
struct ImportText
{
    std::string_view text;
    ReadBudget& budget;
    const ColumnMapping& mapping; ///< columns the user has named; the rest is guessed
    std::optional<DateOrder> dates = {};
};

/** One row of the table that the command line and the dialog share. */
struct ImportFormat
{
    std::string_view id;          ///< e.g. "iip"
    std::string_view source;      ///< where such files come from
    bool namedColumns = true;     ///< whether a mapping says anything
    double positionSd_m = kGps_m; ///< of a position along an axis, where the file does not tell
    bool (*matches)(std::string_view text);
    SightingTable (*read)(const ImportText&);
};

/** In the order in which they are tried: the special before the general. */
[[nodiscard]] std::span<const ImportFormat> importFormats();
/** Null when there is no such format. */
[[nodiscard]] const ImportFormat* findImportFormat(std::string_view id);

/** How a file is to be read. */
struct ReadOptions
{
    std::string format = "auto"; ///< id of a format; "auto": by content
    ColumnMapping mapping;       ///< explicit columns or properties; the rest is guessed
    /** Of dates such as 05/02/2021 in tables; none: as the format or the file's other dates tell.
     */
    std::optional<DateOrder> dates = {};
};

/** What is not UTF-8 taken as ISO 8859-1; empty: it is UTF-8. Throws `Error{WrongFormat}` for what
 * is no text. */
[[nodiscard]] std::string textOfBytes(std::string_view bytes, const std::string& subject);

/** The rows of a table from its header on: without a separator (`sep=;`) and comments above it. */
[[nodiscard]] CsvReader tableReader(std::string_view text);

/**
 * Sightings of a file's bytes; rows that cannot be used are rejected one by one. Text that is not
 * UTF-8 is taken as ISO 8859-1 in tables. Throws `Error`: FileTooLarge (`ReadBudget`); WrongFormat
 * for what is no text, of no known format or not of the one asked for; SyntaxError for broken JSON
 * or XML; InvalidInput when a needed column is missing, a mapped one does not exist, or there is no
 * usable row (with the reasons); `Stopped` when asked to stop. Cost: linear; 50 MB take a few
 * seconds.
 */
[[nodiscard]] SightingTable readSightings(std::string_view bytes, const std::string& subject,
                                          const ReadOptions& options = {},
                                          const std::stop_token& stop = {});

/** The same in two parts: a table without a usable row tells which were rejected. */
[[nodiscard]] SightingTable readSightingRows(std::string_view bytes, const std::string& subject,
                                             const ReadOptions& options = {},
                                             const std::stop_token& stop = {});
void requireSightings(const SightingTable& table, const std::string& subject);

} // namespace berg
