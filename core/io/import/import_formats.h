#pragma once

#include "core/io/import/import_table.h"
#include "core/io/import/import_time.h"
#include "core/io/text/read_budget.h"
#include "core/tracking/position_error.h"

#include <cstdint>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>

namespace berg {

class CsvReader;

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

/** Row of the table of formats that the command line and the dialog share. */
struct ImportFormat
{
    std::string_view id;      ///< e.g. "iip"
    std::string_view origin;  ///< origin of such files
    bool namedColumns = true; ///< whether the format uses a column mapping
    /** Usual source of positions, for rows that name none; nullopt if there is none. */
    std::optional<SightingSource> source;
    bool (*matches)(std::string_view text);
    SightingTable (*read)(const ImportText&);
};

/** Returns all formats in the order in which they are tried, special ones first. */
[[nodiscard]] std::span<const ImportFormat> importFormats();
/** Returns the format with this id, or null if there is none. */
[[nodiscard]] const ImportFormat* findImportFormat(std::string_view id);

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

/**
 * Returns a reader of the rows of a table from its header on, without a separator line (`sep=;`),
 * comments and titles above it. Uses `headerLine` and `mapping` of the options; `text` must outlive
 * the reader.
 */
[[nodiscard]] CsvReader tableReader(std::string_view text, const ReadOptions& options = {});

/**
 * Reads the sightings of a file's bytes; unusable rows are rejected one by one. Text that is not
 * UTF-8 is read as UTF-16 with a mark, or as Windows-1252. Throws `Error`: FileTooLarge
 * (`ReadBudget`); Unsupported if the options name no known format; WrongFormat for bytes that are
 * not text, of no known format or not of the requested one; UnsupportedVersion for mission files of
 * another version; SyntaxError for broken JSON or XML; InvalidInput if a required column is
 * missing, a mapped one does not exist, or there is no usable row (with the reasons); `Stopped` if
 * a stop is requested. Cost: linear; 50 MB take a few seconds.
 */
[[nodiscard]] SightingTable readSightings(std::string_view bytes, const std::string& subject,
                                          const ReadOptions& options = {},
                                          const std::stop_token& stop = {});

/**
 * Reads the rows as `readSightings`, but also returns a table without a usable row, which lists the
 * rejected ones.
 */
[[nodiscard]] SightingTable readSightingRows(std::string_view bytes, const std::string& subject,
                                             const ReadOptions& options = {},
                                             const std::stop_token& stop = {});
/** Throws `Error{InvalidInput}` if the table has no usable row, with the reasons. */
void requireSightings(const SightingTable& table, const std::string& subject);

} // namespace berg
