#pragma once

#include "core/io/import/fields/import_source.h"
#include "core/tracking/position_error.h"

#include <span>
#include <stop_token>
#include <string>
#include <string_view>

namespace berg {

/** Row of the table of formats that the command line and the dialog share. */
struct ImportFormat
{
    std::string_view id;      ///< e.g. "iip"
    const char* name;         ///< English text with its origin, translated (`ImportWords`)
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
