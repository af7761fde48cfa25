#pragma once

// Private to core/io: finds the header of a table and the rows below it.

#include "core/io/import/fields/import_source.h"
#include "core/io/text/csv_reader.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** A table from its header on. */
struct TableText
{
    std::string_view text;
    std::size_t skipped = 0; ///< number of lines above
    std::optional<char> separator = {};

    /** Returns a reader of the rows. */
    [[nodiscard]] CsvReader reader() const
    {
        return {text, separator.value_or(csvSeparator(text))};
    }
};

/**
 * Returns the table without the lines above its header: a separator line of spreadsheets, comments
 * and titles. The header is the first of the first fifty lines that names columns for latitude and
 * longitude, or the mapped ones; otherwise the first line that is not a comment.
 */
[[nodiscard]] TableText tableOf(std::string_view text, const ColumnMapping& mapping = {});
/** Returns the table from its header on, or from the line that the user has chosen. */
[[nodiscard]] TableText tableOf(const ImportText& source);

/** Returns the text from this line (counted from 1) on; empty if there is none. */
[[nodiscard]] std::string_view fromLine(std::string_view text, std::size_t line);

/**
 * Returns the first rows that are not blank, at most `most`, from the header on; their lines are
 * those of the file.
 */
[[nodiscard]] std::vector<CsvRow> topRows(const TableText& table, std::size_t most);

/** Returns true if all cells of the row are blank and it has no fault. */
[[nodiscard]] bool isBlank(const CsvRow& row);

/** Returns true if the row below a header holds the units of its columns, as ERDDAP writes. */
[[nodiscard]] bool isUnitsRow(const CsvRow& header, const CsvRow& row);

} // namespace berg
