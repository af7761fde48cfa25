#include "core/base/error.h"
#include "core/io/import/tables/csv_layout.h"
#include "core/io/import/tables/table_readers.h"
#include "core/scenario/text_checks.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

bool isNumber(const std::string& cell)
{
    return decimalOf(trimmed(cell)).has_value();
}

/** Returns the header of a text that may be a table; it has no cells if there is none. */
CsvRow headerOf(const TableText& table)
{
    std::vector<CsvRow> rows = topRows(table, 1);
    return rows.empty() ? CsvRow{} : std::move(rows.front());
}

std::vector<std::string> plainHeader(std::string_view text)
{
    std::vector<std::string> names;
    for (const std::string& cell : headerOf(tableOf(text)).cells)
        names.push_back(plainName(cell));
    return names;
}

bool has(const std::vector<std::string>& names, std::string_view name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

/**
 * Returns the order of day and month from the first date that can be read in only one way, or
 * nullopt if there is none.
 */
std::optional<DateOrder> dateOrder(const ImportText& source, const CsvLayout& layout,
                                   bool timeApart)
{
    std::optional<DateOrder> order;
    FieldTexts texts;
    forRows(source, layout.above, [&](const CsvRow& row) {
        if (shapeFault(row, layout.width))
            return true;
        fill(texts, row, layout);
        order = dateOrderOf(timeText(texts, timeApart));
        return !order;
    });
    return order;
}

SightingTable readRows(const ImportText& source, const CsvLayout& layout)
{
    SightingTable table;
    const CsvRow header = headerOf(tableOf(source));
    if (layout.above > 0) {
        table.headerLine = header.line;
        for (const std::string& cell : header.cells)
            table.columns.push_back(cleanText(cell, kLongestName));
    }
    std::vector<bool> used(table.columns.size(), false);
    for (const ReadColumn& column : layout.columns)
        if (column.index < table.columns.size()) {
            table.mapping.push_back(
                {.field = column.use.field, .column = table.columns[column.index]});
            used[column.index] = true;
        }
    for (const auto& [index, part] : layout.parts)
        used[index] = true;
    for (const std::size_t index : timeColumnsUsed(layout)) {
        table.mapping.push_back({.field = SightingField::Time, .column = table.columns[index]});
        used[index] = true;
    }
    for (std::size_t i = 0; i < used.size(); ++i)
        if (!used[i] && !table.columns[i].empty())
            table.unused.push_back(table.columns[i]);

    RowRules rules{.timeNeeded = layout.timeNeeded,
                   .timeExpected = layout.timeExpected,
                   .noted = &table.noted};
    rules.timeApart =
        layout.isDayInParts != layout.isClockInParts ||
        (reads(layout.columns, SightingField::Date) && reads(layout.columns, SightingField::Time));
    const std::optional<DateOrder> order =
        source.dates ? source.dates : dateOrder(source, layout, rules.timeApart);
    const bool guesses = !order && !layout.isMonthFirst;
    rules.order = order.value_or(DateOrder::MonthFirst);
    FieldTexts texts;
    forRows(source, layout.above, [&](const CsvRow& row) {
        std::variant<Sighting, RejectedRow> result;
        if (const std::optional<IssueId> fault = shapeFault(row, layout.width)) {
            result = RejectedRow{.line = row.line, .fault = *fault, .detail = {}};
        } else {
            fill(texts, row, layout);
            const std::size_t notes = table.noted.count;
            result = sightingOf(texts, rules, row.line);
            if (guesses && table.guessedDate.empty())
                if (const std::string time = timeText(texts, rules.timeApart);
                    hasTwoReadings(time)) {
                    table.guessedDate = cleanText(time, 60);
                    table.guessedLine = row.line;
                }
            auto* const sighting = std::get_if<Sighting>(&result);
            const std::optional<IssueId> late = sighting != nullptr && layout.finish != nullptr
                                                    ? layout.finish(*sighting, row)
                                                    : std::nullopt;
            if (late) {
                table.noted.forget(notes);
                result = RejectedRow{
                    .line = row.line, .fault = *late, .detail = timeText(texts, rules.timeApart)};
            }
        }
        addRow(table, std::move(result), source.budget);
        return true;
    });
    return table;
}

void requireField(const CsvLayout& layout, SightingField field, const std::string& subject)
{
    if (!reads(layout.columns, field))
        throw Error(
            ErrorCode::InvalidInput, subject,
            {{Severity::Error, nameOf(kSightingFieldNames, field), {IssueId::NoColumnForIt}}});
}

void requirePlace(const CsvLayout& layout, const std::string& subject)
{
    requireField(layout, SightingField::Latitude, subject);
    requireField(layout, SightingField::Longitude, subject);
}

constexpr std::size_t kIipColumns = 10;

/** Whether the row is a data row of the IIP, judged by its numbers. */
bool isIipRow(const CsvRow& row)
{
    return row.cells.size() == kIipColumns && isNumber(row.cells[0]) && isNumber(row.cells[4]) &&
           isNumber(row.cells[5]) && trimmed(row.cells[0]).size() == 4;
}

/** Sets the id from season and number and checks that the date is in the season. */
std::optional<IssueId> finishIip(Sighting& sighting, const CsvRow& row)
{
    using namespace std::chrono;
    const std::optional<double> season = decimalOf(trimmed(row.cells[0]));
    if (!season || *season < 1900 || *season > 2100 || *season != std::floor(*season))
        return IssueId::OutOfSeason;
    const int last = static_cast<int>(*season);
    constexpr days kMargin(31);
    if (!sighting.id.empty())
        sighting.id = std::to_string(last) + '-' + sighting.id;
    sighting.ids.clear(); // the id is decided
    if (!sighting.time)
        return std::nullopt;
    const sys_days start = sys_days(year(last - 1) / October / 1) - kMargin;
    const sys_days end = sys_days(year(last) / October / 1) + kMargin;
    if (*sighting.time < start || *sighting.time >= end)
        return IssueId::OutOfSeason;
    return std::nullopt;
}

} // namespace

CsvReader tableReader(std::string_view text, const ReadOptions& options)
{
    if (options.headerLine)
        return TableText{.text = fromLine(text, *options.headerLine)}.reader();
    return tableOf(text, options.mapping).reader();
}

bool isAnyCsv(std::string_view text)
{
    bool latitude = false;
    bool longitude = false;
    for (const std::string& cell : headerOf(tableOf(text)).cells) {
        const std::optional<FieldUse> use = fieldOfColumn(cell);
        latitude = latitude || (use && use->field == SightingField::Latitude);
        longitude = longitude || (use && use->field == SightingField::Longitude);
    }
    return latitude && longitude;
}

SightingTable readAnyCsv(const ImportText& source)
{
    CsvLayout layout = layoutByName(source);
    requirePlace(layout, source.budget.subject());
    layout.timeExpected = reads(layout.columns, SightingField::Time) ||
                          reads(layout.columns, SightingField::Date) || layout.isDayInParts;
    layout.isMonthFirst = false;
    return readRows(source, layout);
}

bool isIip(std::string_view text)
{
    const CsvRow first = headerOf(tableOf(text));
    if (isIipRow(first))
        return true;
    const std::vector<std::string> names = plainHeader(text);
    return names.size() == kIipColumns && (has(names, "icebergnumber") || has(names, "bergnumber"));
}

SightingTable readIip(const ImportText& source)
{
    using enum SightingField;
    const CsvRow first = headerOf(tableOf(source));
    if (first.cells.size() != kIipColumns)
        throw Error(ErrorCode::WrongFormat, source.budget.subject(),
                    {IssueId::ColumnCount, {countOf(kIipColumns), countOf(first.cells.size())}});
    CsvLayout layout{.width = kIipColumns,
                     .above = isIipRow(first) || isNumber(first.cells[0]) ? 0U : 1U,
                     .finish = finishIip};
    constexpr std::array kByPosition = {Id, Date, Time, Latitude, Longitude};
    for (std::size_t i = 0; i < kByPosition.size(); ++i)
        layout.columns.push_back({.index = i + 1, .use = {.field = kByPosition[i]}});
    layout.columns.push_back({.index = 7, .use = {.field = SizeClass}});
    return readRows(source, layout);
}

bool isCisBeacon(std::string_view text)
{
    const std::vector<std::string> names = plainHeader(text);
    return has(names, "beaconid") && has(names, "datetimedata");
}

SightingTable readCisBeacon(const ImportText& source)
{
    using enum SightingField;
    // Its speed and direction are differences of positions, which the estimate computes better.
    CsvLayout layout = layoutByName(source, {Id, Time, Latitude, Longitude});
    layout.timeNeeded = true;
    requirePlace(layout, source.budget.subject());
    requireField(layout, Time, source.budget.subject());
    return readRows(source, layout);
}

bool isUsnic(std::string_view text)
{
    const std::vector<std::string> names = plainHeader(text);
    return has(names, "iceberg") && has(names, "lastupdate") && has(names, "latitude");
}

SightingTable readUsnic(const ImportText& source)
{
    using enum SightingField;
    const CsvLayout layout = layoutByName(source, {Id, Time, Latitude, Longitude, Length, Remarks});
    requirePlace(layout, source.budget.subject());
    requireField(layout, Time, source.budget.subject());
    return readRows(source, layout);
}

} // namespace berg
