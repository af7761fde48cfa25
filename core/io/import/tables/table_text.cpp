#include "core/io/import/tables/table_text.h"

#include "core/io/import/fields/import_fields.h"
#include "core/io/text/byte_order_mark.h"

#include <algorithm>

namespace berg {

namespace {

constexpr std::size_t kMostAbove = 50;
constexpr std::size_t kLongestHeader = 100'000; ///< bytes of a line that are read as a header

std::string_view firstLine(std::string_view text)
{
    return text.substr(0, std::min(text.find_first_of("\r\n"), kLongestHeader));
}

/** Returns the table without its first line. */
TableText below(const TableText& table)
{
    TableText rest = table;
    const std::size_t end = std::min(rest.text.find_first_of("\r\n"), rest.text.size());
    rest.text.remove_prefix(end);
    rest.text.remove_prefix(rest.text.starts_with("\r\n") ? 2 : rest.text.empty() ? 0 : 1);
    ++rest.skipped;
    return rest;
}

/** Whether there is a column for the latitude and one for the longitude. */
bool namesPlace(const CsvRow& row, const ColumnMapping& mapping)
{
    const auto names = [&](SightingField field) {
        return std::ranges::any_of(row.cells, [&](const std::string& cell) {
            const std::optional<FieldUse> use = fieldOfColumn(cell);
            return (use && use->field == field) ||
                   std::ranges::any_of(mapping, [&](const FieldColumn& mapped) {
                       return mapped.field == field &&
                              mapped.column == cleanText(cell, kLongestName);
                   });
        });
    };
    return names(SightingField::Latitude) && names(SightingField::Longitude);
}

/** Returns the table from its header on, or nullopt if there is none near the top. */
std::optional<TableText> fromHeader(TableText table, const ColumnMapping& mapping)
{
    for (std::size_t i = 0; i < kMostAbove && !table.text.empty(); ++i, table = below(table)) {
        const std::string_view line = firstLine(table.text);
        if (line.starts_with('#'))
            continue;
        TableText found = table;
        found.separator = table.separator.value_or(csvSeparator(line));
        CsvReader reader(line, *found.separator);
        CsvRow row;
        if (reader.next(row) && row.fault == CsvRow::Fault::None && namesPlace(row, mapping))
            return found;
    }
    return std::nullopt;
}

/** Returns the table without comments; the last of them is the header if data follow. */
TableText withoutComments(TableText table)
{
    TableText header = table;
    while (table.text.starts_with('#')) {
        header = table;
        table = below(table);
        while (table.text.starts_with('\n') || table.text.starts_with('\r'))
            table = below(table);
    }
    CsvRow row;
    CsvReader reader = table.reader();
    const bool isData =
        !reader.next(row) || std::ranges::any_of(row.cells, [](const std::string& cell) {
            return decimalOf(trimmed(cell)).has_value();
        });
    return isData ? header : table;
}

} // namespace

TableText tableOf(std::string_view text, const ColumnMapping& mapping)
{
    constexpr std::string_view kSeparator = "sep=";
    TableText table{.text = withoutByteOrderMark(text)};
    const std::string_view first =
        trimmed(table.text.substr(0, std::min(table.text.find_first_of("\r\n"), std::size_t{16})));
    if (first.size() == kSeparator.size() + 1 && first.starts_with(kSeparator)) {
        table = below(table);
        table.separator = first.back();
    }
    const std::optional<TableText> found = fromHeader(table, mapping);
    return found ? *found : withoutComments(table);
}

TableText tableOf(const ImportText& source)
{
    return source.linesAbove ? TableText{.text = source.text, .skipped = *source.linesAbove}
                             : tableOf(source.text, source.mapping);
}

std::string_view fromLine(std::string_view text, std::size_t line)
{
    TableText table{.text = withoutByteOrderMark(text)};
    while (table.skipped + 1 < line && !table.text.empty())
        table = below(table);
    return table.text;
}

std::vector<CsvRow> topRows(const TableText& table, std::size_t most)
{
    std::vector<CsvRow> rows;
    CsvReader reader = table.reader();
    CsvRow row;
    while (rows.size() < most && reader.next(row)) {
        row.line += table.skipped;
        if (!isBlank(row))
            rows.push_back(row);
    }
    return rows;
}

bool isBlank(const CsvRow& row)
{
    return row.fault == CsvRow::Fault::None &&
           std::all_of(row.cells.begin(), row.cells.end(),
                       [](const std::string& cell) { return trimmed(cell).empty(); });
}

bool isUnitsRow(const CsvRow& header, const CsvRow& row)
{
    bool isUnit = false;
    for (std::size_t i = 0; i < std::min(header.cells.size(), row.cells.size()); ++i) {
        const std::optional<FieldUse> use = fieldOfColumn(header.cells[i]);
        const std::string_view cell = trimmed(row.cells[i]);
        if (!use ||
            (use->field != SightingField::Latitude && use->field != SightingField::Longitude))
            continue;
        // A column name may end with a unit of latitude such as "degrees_north".
        const std::optional<FieldUse> with = fieldOfColumn("latitude (" + std::string(cell) + ')');
        const bool isName = with && with->field == SightingField::Latitude;
        if (!cell.empty() && (!isName || decimalOf(cell)))
            return false;
        isUnit = isUnit || !cell.empty();
    }
    return isUnit;
}

} // namespace berg
