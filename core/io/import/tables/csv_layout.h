#pragma once

// Private to core/io: which columns of a table are read, and as which fields.

#include "core/io/import/fields/import_fields.h"
#include "core/io/import/fields/time_columns.h"
#include "core/io/import/tables/table_text.h"

#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

namespace berg {

/** A column of the file that is read, with its use. */
struct ReadColumn
{
    std::size_t index = 0;
    FieldUse use;
};

/** Layout of the rows of one file. */
struct CsvLayout
{
    std::vector<ReadColumn> columns;
    std::vector<std::pair<std::size_t, PlacePart>> parts = {}; ///< columns with parts of a place,
                                                               ///< in the order in which they are
                                                               ///< appended
    TimeColumns time = {};
    bool isDayInParts = false;   ///< the date is built from the columns of `time`
    bool isClockInParts = false; ///< the time of day is built from the columns of `time`
    std::size_t width = 0;       ///< number of cells of a whole row
    std::size_t above = 1;       ///< number of rows above the data: the header, and one of units
    bool timeNeeded = false;     ///< a row without time is rejected
    bool timeExpected = true;    ///< a row without time is noted
    bool isMonthFirst = true;    ///< order of ambiguous dates
    /** Final check and change of a sighting; returns a fault to reject it. May be null. */
    std::optional<IssueId> (*finish)(Sighting& sighting, const CsvRow& row) = nullptr;
};

/** Returns true if one of the columns is read as this field. */
[[nodiscard]] bool reads(const std::vector<ReadColumn>& columns, SightingField field);

/**
 * Returns why the row cannot be read: its quotes, or another number of cells than `width`, that of
 * the header. Empty cells beyond the header are allowed. Returns nullopt if the row can be read.
 */
[[nodiscard]] std::optional<IssueId> shapeFault(const CsvRow& row, std::size_t width);

/** Replaces the texts by those of the row, for which `shapeFault` must return nullopt. */
void fill(FieldTexts& texts, const CsvRow& row, const CsvLayout& layout);

/**
 * Calls `use(row)` for each row that is not blank below the first `above` ones, until it returns
 * false.
 */
template <class Use>
void forRows(const ImportText& source, std::size_t above, Use use)
{
    const TableText table = tableOf(source);
    CsvReader reader = table.reader();
    CsvRow row;
    while (reader.next(row)) {
        source.budget.throwIfStopped();
        if (isBlank(row))
            continue;
        row.line += table.skipped;
        if (above > 0)
            --above;
        else if (!use(row))
            return;
    }
}

/**
 * Returns the columns that dates and times of day are built from, apart from columns of whole
 * times.
 */
[[nodiscard]] std::vector<std::size_t> timeColumnsUsed(const CsvLayout& layout);

/**
 * Returns the layout of a table with a header, of which `fields` are read, or all if it is empty.
 * Throws `Error`: WrongFormat without a header, InvalidInput for ambiguous columns, for a mapped
 * column that does not exist and for names of time zones.
 */
[[nodiscard]] CsvLayout layoutByName(const ImportText& source,
                                     std::initializer_list<SightingField> fields = {});

} // namespace berg
