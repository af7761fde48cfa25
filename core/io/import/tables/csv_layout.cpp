#include "core/io/import/tables/csv_layout.h"

#include "core/base/error.h"
#include "core/scenario/text_checks.h"

#include <algorithm>
#include <set>

namespace berg {

namespace {

/**
 * Returns the use of a column with the unit in the row below the header, or nullopt if the unit of
 * a measured value is unknown.
 */
std::optional<FieldUse> withUnit(FieldUse use, const std::string& column, std::string_view unit)
{
    if (unit.empty())
        return use;
    const std::optional<FieldUse> whole = fieldOfColumn(column + " (" + std::string(unit) + ')');
    if (whole && whole->field == use.field) {
        use.factor = whole->factor;
        use.offset = whole->offset;
        return use;
    }
    using enum SightingField;
    constexpr std::array kMeasured = {Speed, Direction, Sigma, Growth, Length, Radius, Area};
    const bool isMeasured = std::ranges::find(kMeasured, use.field) != kMeasured.end();
    return isMeasured ? std::nullopt : std::optional(use);
}

/**
 * Returns the columns of a header that are used: for each field the one that fits best. `units` are
 * those of the columns, or empty.
 */
std::vector<ReadColumn> columnsOf(const std::vector<std::string>& header, ColumnNames& names,
                                  const std::vector<std::string>& units)
{
    std::vector<ReadColumn> columns;
    for (std::size_t i = 0; i < header.size(); ++i) {
        std::optional<FieldUse> use = names.of(header[i]);
        if (use && i < units.size())
            use = withUnit(*use, header[i], trimmed(units[i]));
        if (!use)
            continue;
        const auto rival =
            std::find_if(columns.begin(), columns.end(),
                         [&](const ReadColumn& column) { return column.use.field == use->field; });
        if (rival == columns.end() || use->field == SightingField::Id) // values decide about ids
            columns.push_back({.index = i, .use = *use});
        else if (use->rank < rival->use.rank)
            *rival = {.index = i, .use = *use};
    }
    return columns;
}

/**
 * Returns the columns of minutes, seconds and hemispheres of latitudes and longitudes, in this
 * order.
 */
std::vector<std::pair<std::size_t, PlacePart>> partsOf(const std::vector<std::string>& header,
                                                       ColumnNames& names)
{
    std::vector<std::pair<std::size_t, PlacePart>> parts;
    const bool isBox = std::ranges::any_of(header, [](const std::string& name) {
        const std::string plain = plainName(name);
        return plain.starts_with("l") && plain.ends_with("max"); // "lat_min" is then a minimum
    });
    for (std::size_t i = 0; i < header.size(); ++i)
        if (const std::optional<PlacePart> part = placePartOf(header[i]);
            part && !names.of(header[i]))
            if (!isBox || part->kind == PlacePart::Kind::Hemisphere)
                parts.emplace_back(i, *part);
    std::ranges::stable_sort(parts, {}, [](const auto& part) { return part.second.kind; });
    return parts;
}

/** Throws for columns that give a place or time in a form that is not understood. */
void rejectUnclearColumns(const std::vector<ReadColumn>& columns,
                          const std::vector<std::string>& header, ColumnNames& names,
                          const std::string& subject)
{
    std::vector<Issue> issues;
    for (const std::string& name : header) {
        if (names.of(name))
            continue;
        const auto reject = [&](SightingField field) {
            issues.push_back({Severity::Error,
                              nameOf(kSightingFieldNames, field),
                              {IssueId::ColumnUnclear, {printable(name)}}});
        };
        const std::string plain = plainName(name);
        if (plain == "hem" || plain == "hemi" || plain == "hemisphere")
            reject(SightingField::Longitude);
        else if (const std::optional<SightingField> time = unclearTimeOf(name);
                 time && !reads(columns, SightingField::Time) && !reads(columns, *time))
            reject(*time);
    }
    const TimeColumns parts =
        timeColumnsOf(header, [&](const std::string& name) { return !names.of(name).has_value(); });
    const bool hasTime = reads(columns, SightingField::Time) ||
                         reads(columns, SightingField::Date) || parts.formDate();
    if (const std::optional<std::size_t> part = parts.firstPart(); part && !hasTime)
        issues.push_back({Severity::Error,
                          nameOf(kSightingFieldNames, SightingField::Time),
                          {IssueId::ColumnUnclear, {printable(header[*part])}}});
    if (!issues.empty())
        throw Error(ErrorCode::InvalidInput, subject, std::move(issues));
}

/** Throws if two columns of one name could be the same field, as nothing decides between them. */
void rejectTwinColumns(const std::vector<ReadColumn>& columns,
                       const std::vector<std::string>& header, const std::string& subject)
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

/** Determines which columns with parts of a time are needed in addition to whole times. */
void addTimeParts(CsvLayout& layout, const std::vector<std::string>& header, ColumnNames& names)
{
    const bool hasTime = reads(layout.columns, SightingField::Time);
    const bool hasDate = reads(layout.columns, SightingField::Date);
    layout.time =
        timeColumnsOf(header, [&](const std::string& name) { return !names.of(name).has_value(); });
    layout.isDayInParts = layout.time.formDate() && !hasDate;
    layout.isClockInParts =
        !hasTime && (layout.isDayInParts || (hasDate && layout.time.of(TimePart::Hour)));
}

/**
 * Throws for names of time zones where a time needs one, because they do not show whether summer
 * time applies.
 */
void rejectZoneNames(const ImportText& source, const CsvLayout& layout)
{
    const std::optional<std::size_t> zone = layout.time.of(TimePart::Zone);
    if (!zone)
        return;
    constexpr std::size_t kMostNamed = 5;
    std::set<std::string> unknown;
    FieldTexts texts;
    forRows(source, layout.above, [&](const CsvRow& row) {
        if (shapeFault(row, layout.width) || trimmed(row.cells[*zone]).empty() ||
            zoneOfCell(row.cells[*zone]))
            return true;
        fill(texts, row, layout);
        const std::string& time = texts.text(SightingField::Time);
        if (withZone(time, {}) != time)
            unknown.insert(cleanText(row.cells[*zone], 60));
        return unknown.size() < kMostNamed;
    });
    std::vector<Issue> issues;
    for (const std::string& name : unknown)
        issues.push_back({Severity::Error,
                          nameOf(kSightingFieldNames, SightingField::Time),
                          {IssueId::ZoneUnknown, {printable(name)}}});
    if (!issues.empty())
        throw Error(ErrorCode::InvalidInput, source.budget.subject(), std::move(issues));
}

} // namespace

bool reads(const std::vector<ReadColumn>& columns, SightingField field)
{
    return std::ranges::any_of(columns,
                               [&](const ReadColumn& column) { return column.use.field == field; });
}

std::optional<IssueId> shapeFault(const CsvRow& row, std::size_t width)
{
    if (row.fault == CsvRow::Fault::UnclosedQuote)
        return IssueId::UnclosedQuote;
    if (row.fault == CsvRow::Fault::TextAfterQuote)
        return IssueId::TextAfterQuote;
    // Spreadsheets leave empty cells beyond the last column.
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
    using enum SightingField;
    if (layout.isDayInParts && layout.isClockInParts)
        texts.set(Time, timeOfParts(layout.time, row));
    else if (layout.isDayInParts)
        texts.set(Date, dayOfParts(layout.time, row));
    else if (layout.isClockInParts)
        texts.set(Time, clockOfParts(layout.time, row));
    if (const std::optional<std::size_t> zone = layout.time.of(TimePart::Zone))
        if (const auto offset = zoneOfCell(row.cells[*zone]))
            texts.setZone(*offset);
}

std::vector<std::size_t> timeColumnsUsed(const CsvLayout& layout)
{
    std::vector<std::size_t> used;
    for (std::size_t i = 0; i < layout.time.column.size(); ++i) {
        const auto part = static_cast<TimePart>(i);
        const bool isClock =
            part == TimePart::Hour || part == TimePart::Minute || part == TimePart::Second;
        const bool isUsed =
            part == TimePart::Zone || (isClock ? layout.isClockInParts : layout.isDayInParts);
        if (layout.time.column[i] && isUsed)
            used.push_back(*layout.time.column[i]);
    }
    return used;
}

CsvLayout layoutByName(const ImportText& source, std::initializer_list<SightingField> fields)
{
    const std::vector<CsvRow> top = topRows(tableOf(source), 2);
    const CsvRow header = top.empty() ? CsvRow{} : top.front();
    if (header.cells.empty() || header.cells.size() > kMostColumns)
        throw Error(ErrorCode::WrongFormat, source.budget.subject(),
                    {IssueId::HeaderColumns, {countOf(kMostColumns)}});
    std::vector<std::string> cells;
    for (const std::string& cell : header.cells)
        cells.push_back(cleanText(cell, kLongestName));
    ColumnNames names(source.mapping);
    const bool hasUnits = top.size() > 1 && isUnitsRow(header, top[1]);
    CsvLayout layout{
        .columns = columnsOf(cells, names, hasUnits ? top[1].cells : std::vector<std::string>()),
        .parts = partsOf(cells, names),
        .width = cells.size(),
        .above = hasUnits ? 2U : 1U};
    names.requireMapped(source.budget.subject());
    rejectTwinColumns(layout.columns, cells, source.budget.subject());
    rejectUnclearColumns(layout.columns, cells, names, source.budget.subject());
    if (fields.size() == 0) {
        addTimeParts(layout, cells, names);
        rejectZoneNames(source, layout);
    } else {
        std::erase_if(layout.columns, [&](const ReadColumn& column) {
            return std::find(fields.begin(), fields.end(), column.use.field) == fields.end();
        });
    }
    return layout;
}

} // namespace berg
