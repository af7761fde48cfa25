#include "core/base/error.h"
#include "core/io/import/import_fields.h"
#include "core/io/import/import_readers.h"
#include "core/io/text/byte_order_mark.h"
#include "core/io/text/csv_reader.h"
#include "core/scenario/checks.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

/** A column of the file that is read. */
struct ReadColumn
{
    std::size_t index = 0;
    FieldUse use;
};

/** How the rows of one file are read. */
struct CsvLayout
{
    std::vector<ReadColumn> columns;
    std::vector<std::pair<std::size_t, PlacePart>> parts = {}; ///< by their columns, as appended
    std::size_t width = 0;                                     ///< cells of a whole row
    bool header = true;
    bool timeNeeded = true;
    bool isMonthFirst = true; ///< by the customs of the format, where no date tells otherwise
    /** A last look at a sighting that is otherwise in order; may be null. */
    std::optional<IssueId> (*finish)(Sighting& sighting, const CsvRow& row) = nullptr;
};

bool isBlank(const CsvRow& row)
{
    return row.fault == CsvRow::Fault::None &&
           std::all_of(row.cells.begin(), row.cells.end(),
                       [](const std::string& cell) { return trimmed(cell).empty(); });
}

bool isNumber(const std::string& cell)
{
    return decimalOf(trimmed(cell)).has_value();
}

/** Without what may stand above the header: the separator as spreadsheets tell it, and comments. */
struct TableText
{
    std::string_view text;
    std::size_t skipped = 0; ///< lines
    std::optional<char> separator = {};

    [[nodiscard]] CsvReader reader() const
    {
        return {text, separator.value_or(csvSeparator(text))};
    }
};

/** Without the first line. */
TableText below(const TableText& table)
{
    TableText rest = table;
    const std::size_t end = std::min(rest.text.find_first_of("\r\n"), rest.text.size());
    rest.text.remove_prefix(end);
    rest.text.remove_prefix(rest.text.starts_with("\r\n") ? 2 : rest.text.empty() ? 0 : 1);
    ++rest.skipped;
    return rest;
}

TableText tableOf(std::string_view text)
{
    constexpr std::string_view kSeparator = "sep=";
    TableText table{.text = withoutByteOrderMark(text)};
    const std::string_view first =
        trimmed(table.text.substr(0, std::min(table.text.find_first_of("\r\n"), std::size_t{16})));
    if (first.size() == kSeparator.size() + 1 && first.starts_with(kSeparator)) {
        table = below(table);
        table.separator = first.back();
    }
    TableText header = table; // a comment may be that
    while (table.text.starts_with('#')) {
        header = table;
        table = below(table);
        while (table.text.starts_with('\n') || table.text.starts_with('\r'))
            table = below(table);
    }
    CsvRow row;
    CsvReader reader = table.reader();
    const bool isData = !reader.next(row) || std::ranges::any_of(row.cells, isNumber);
    return isData ? header : table;
}

/** The first row with anything in it; no cells when there is none. */
CsvRow firstRow(std::string_view text)
{
    CsvReader reader = tableReader(text);
    CsvRow row;
    while (reader.next(row))
        if (!isBlank(row))
            return row;
    return {};
}

std::vector<std::string> plainHeader(std::string_view text)
{
    std::vector<std::string> names;
    for (const std::string& cell : firstRow(text).cells)
        names.push_back(plainName(cell));
    return names;
}

bool has(const std::vector<std::string>& names, std::string_view name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

/** Whether the row can be used at all: its quotes, and as many cells as the header. */
std::optional<IssueId> shapeFault(const CsvRow& row, std::size_t width)
{
    if (row.fault == CsvRow::Fault::UnclosedQuote)
        return IssueId::UnclosedQuote;
    if (row.fault == CsvRow::Fault::TextAfterQuote)
        return IssueId::TextAfterQuote;
    // Empty cells beyond the last column are what spreadsheets leave behind.
    const bool tooWide =
        row.cells.size() > width &&
        std::any_of(row.cells.begin() + static_cast<std::ptrdiff_t>(width), row.cells.end(),
                    [](const std::string& cell) { return !trimmed(cell).empty(); });
    if (row.cells.size() < width || tooWide)
        return IssueId::RowWidth;
    return std::nullopt;
}

void fill(FieldTexts& texts, const CsvRow& row, const CsvLayout& layout)
{
    texts.clear();
    for (const ReadColumn& column : layout.columns)
        texts.set(column.use, row.cells[column.index]);
    for (const auto& [index, part] : layout.parts)
        texts.append(part, row.cells[index]);
}

/** Calls `use(row)` for each row below the header that is not blank, until it returns false. */
template <class Use>
void forRows(const ImportText& source, bool header, Use use)
{
    const TableText table = tableOf(source.text);
    CsvReader reader = table.reader();
    CsvRow row;
    bool first = header;
    while (reader.next(row)) {
        source.budget.goOn();
        if (isBlank(row))
            continue;
        row.line += table.skipped;
        if (first)
            first = false;
        else if (!use(row))
            return;
    }
}

/** Day or month first: by the first date that can only be read one way; none: there is none. */
std::optional<DateOrder> dateOrder(const ImportText& source, const CsvLayout& layout,
                                   bool timeApart)
{
    std::optional<DateOrder> told;
    FieldTexts texts;
    forRows(source, layout.header, [&](const CsvRow& row) {
        if (shapeFault(row, layout.width))
            return true;
        fill(texts, row, layout);
        told = dateOrderOf(timeText(texts, timeApart));
        return !told;
    });
    return told;
}

bool reads(const std::vector<ReadColumn>& columns, SightingField field)
{
    return std::ranges::any_of(columns,
                               [&](const ReadColumn& column) { return column.use.field == field; });
}

SightingTable readRows(const ImportText& source, const CsvLayout& layout)
{
    SightingTable table;
    const CsvRow header = firstRow(source.text);
    if (layout.header)
        for (const std::string& cell : header.cells)
            table.columns.push_back(cleanText(cell, kLongestName));
    std::vector<bool> used(table.columns.size(), false);
    for (const ReadColumn& column : layout.columns)
        if (column.index < table.columns.size()) {
            table.mapping.push_back(
                {.field = column.use.field, .column = table.columns[column.index]});
            used[column.index] = true;
        }
    for (const auto& [index, part] : layout.parts)
        used[index] = true;
    for (std::size_t i = 0; i < used.size(); ++i)
        if (!used[i] && !table.columns[i].empty())
            table.unused.push_back(table.columns[i]);

    RowRules rules{.timeNeeded = layout.timeNeeded};
    rules.timeApart =
        reads(layout.columns, SightingField::Date) && reads(layout.columns, SightingField::Time);
    const std::optional<DateOrder> told =
        source.dates ? source.dates : dateOrder(source, layout, rules.timeApart);
    const bool guesses = !told && !layout.isMonthFirst;
    rules.order = told.value_or(DateOrder::MonthFirst);
    FieldTexts texts;
    forRows(source, layout.header, [&](const CsvRow& row) {
        std::variant<Sighting, RejectedRow> result;
        if (const std::optional<IssueId> fault = shapeFault(row, layout.width)) {
            result = RejectedRow{.line = row.line, .fault = *fault, .detail = {}};
        } else {
            fill(texts, row, layout);
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
            if (late)
                result = RejectedRow{
                    .line = row.line, .fault = *late, .detail = timeText(texts, rules.timeApart)};
        }
        addRow(table, std::move(result), source.budget);
        return true;
    });
    return table;
}

/** Columns of a header: for each field the one that fits best. */
std::vector<ReadColumn> columnsOf(const std::vector<std::string>& header, ColumnNames& names)
{
    std::vector<ReadColumn> columns;
    for (std::size_t i = 0; i < header.size(); ++i) {
        const std::optional<FieldUse> use = names.of(header[i]);
        if (!use)
            continue;
        const auto rival =
            std::find_if(columns.begin(), columns.end(),
                         [&](const ReadColumn& column) { return column.use.field == use->field; });
        if (rival == columns.end())
            columns.push_back({.index = i, .use = *use});
        else if (use->rank < rival->use.rank)
            *rival = {.index = i, .use = *use};
    }
    return columns;
}

/** Minutes, seconds and letters of latitudes and longitudes, in this order. */
std::vector<std::pair<std::size_t, PlacePart>> partsOf(const std::vector<std::string>& header,
                                                       ColumnNames& names)
{
    std::vector<std::pair<std::size_t, PlacePart>> parts;
    const bool isBox = std::ranges::any_of(header, [](const std::string& name) {
        const std::string plain = plainName(name);
        return plain.starts_with("l") && plain.ends_with("max"); // beside them "lat_min" is another
    });
    for (std::size_t i = 0; i < header.size(); ++i)
        if (const std::optional<PlacePart> part = placePartOf(header[i]);
            part && !names.of(header[i]))
            if (!isBox || part->kind == PlacePart::Kind::Hemisphere)
                parts.emplace_back(i, *part);
    std::ranges::stable_sort(parts, {}, [](const auto& part) { return part.second.kind; });
    return parts;
}

/** Columns that say where or when, but not in a way that is understood. */
void refuseUnclear(const std::vector<ReadColumn>& columns, const std::vector<std::string>& header,
                   ColumnNames& names, const std::string& subject)
{
    std::vector<Issue> issues;
    for (const std::string& name : header) {
        if (names.of(name))
            continue;
        const auto refuse = [&](SightingField field) {
            issues.push_back({Severity::Error,
                              nameOf(kSightingFieldNames, field),
                              {IssueId::ColumnUnclear, {printable(name)}}});
        };
        const std::string plain = plainName(name);
        if (plain == "hem" || plain == "hemi" || plain == "hemisphere")
            refuse(SightingField::Longitude);
        else if (const std::optional<SightingField> time = unclearTimeOf(name);
                 time && !reads(columns, SightingField::Time) && !reads(columns, *time))
            refuse(*time);
    }
    if (!issues.empty())
        throw Error(ErrorCode::InvalidInput, subject, std::move(issues));
}

/** Two columns of one name: which of them holds the field, nobody can tell. */
void refuseTwins(const std::vector<ReadColumn>& columns, const std::vector<std::string>& header,
                 const std::string& subject)
{
    std::vector<Issue> issues;
    for (const ReadColumn& column : columns)
        for (std::size_t i = column.index + 1; i < header.size(); ++i)
            if (plainName(header[i]) == plainName(header[column.index]))
                issues.push_back(
                    {Severity::Error,
                     nameOf(kSightingFieldNames, column.use.field),
                     {IssueId::TwinColumns,
                      {countOf(column.index + 1), countOf(i + 1), printable(header[i])}}});
    if (!issues.empty())
        throw Error(ErrorCode::InvalidInput, subject, std::move(issues));
}

/** Layout of a table with a header, of which `fields` (all: empty) are read. */
CsvLayout layoutByName(const ImportText& source, std::initializer_list<SightingField> fields = {})
{
    const CsvRow header = firstRow(source.text);
    if (header.cells.empty() || header.cells.size() > kMostColumns)
        throw Error(ErrorCode::WrongFormat, source.budget.subject(),
                    {IssueId::HeaderColumns, {countOf(kMostColumns)}});
    std::vector<std::string> cells;
    for (const std::string& cell : header.cells)
        cells.push_back(cleanText(cell, kLongestName));
    ColumnNames names(source.mapping);
    CsvLayout layout{
        .columns = columnsOf(cells, names), .parts = partsOf(cells, names), .width = cells.size()};
    names.requireMapped(source.budget.subject());
    refuseTwins(layout.columns, cells, source.budget.subject());
    refuseUnclear(layout.columns, cells, names, source.budget.subject());
    if (fields.size() > 0)
        std::erase_if(layout.columns, [&](const ReadColumn& column) {
            return std::find(fields.begin(), fields.end(), column.use.field) == fields.end();
        });
    return layout;
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

/** A row of data of the IIP, told by its numbers. */
bool isIipRow(const CsvRow& row)
{
    return row.cells.size() == kIipColumns && isNumber(row.cells[0]) && isNumber(row.cells[4]) &&
           isNumber(row.cells[5]) && trimmed(row.cells[0]).size() == 4;
}

/** Id of season and number; the season holds the date. */
std::optional<IssueId> finishIip(Sighting& sighting, const CsvRow& row)
{
    using namespace std::chrono;
    const std::optional<double> season = decimalOf(trimmed(row.cells[0]));
    if (!season || *season < 1900 || *season > 2100 || *season != std::floor(*season))
        return IssueId::OutOfSeason;
    const int last = static_cast<int>(*season);
    constexpr days kMargin(31);
    const sys_days start = sys_days(year(last - 1) / October / 1) - kMargin;
    const sys_days end = sys_days(year(last) / October / 1) + kMargin;
    if (*sighting.time < start || *sighting.time >= end)
        return IssueId::OutOfSeason;
    if (!sighting.id.empty())
        sighting.id = std::to_string(last) + '-' + sighting.id;
    return std::nullopt;
}

} // namespace

CsvReader tableReader(std::string_view text)
{
    return tableOf(text).reader();
}

bool isAnyCsv(std::string_view text)
{
    bool latitude = false;
    bool longitude = false;
    for (const std::string& cell : firstRow(text).cells) {
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
    layout.timeNeeded =
        reads(layout.columns, SightingField::Time) || reads(layout.columns, SightingField::Date);
    layout.isMonthFirst = false;
    SightingTable table = readRows(source, layout);
    decideIdentity(table);
    return table;
}

bool isIip(std::string_view text)
{
    const CsvRow first = firstRow(text);
    if (isIipRow(first))
        return true;
    const std::vector<std::string> names = plainHeader(text);
    return names.size() == kIipColumns && (has(names, "icebergnumber") || has(names, "bergnumber"));
}

SightingTable readIip(const ImportText& source)
{
    using enum SightingField;
    const CsvRow first = firstRow(source.text);
    if (first.cells.size() != kIipColumns)
        throw Error(ErrorCode::WrongFormat, source.budget.subject(),
                    {IssueId::ColumnCount, {countOf(kIipColumns), countOf(first.cells.size())}});
    CsvLayout layout{.width = kIipColumns,
                     .header = !isIipRow(first) && !isNumber(first.cells[0]),
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
    // Its speed and direction are differences of positions, which the estimate does better.
    const CsvLayout layout = layoutByName(source, {Id, Time, Latitude, Longitude});
    requirePlace(layout, source.budget.subject());
    requireField(layout, Time, source.budget.subject());
    SightingTable table = readRows(source, layout);
    decideIdentity(table);
    return table;
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
