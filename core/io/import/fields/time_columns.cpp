#include "core/io/import/fields/time_columns.h"

#include "core/io/import/fields/import_fields.h"
#include "core/io/import/fields/import_time.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

namespace berg {

namespace {

constexpr double kDay_s = 86400;

std::string_view cellOf(const TimeColumns& columns, TimePart part, const CsvRow& row)
{
    const std::optional<std::size_t> column = columns.of(part);
    return column && *column < row.cells.size() ? trimmed(row.cells[*column]) : std::string_view();
}

std::optional<double> numberIn(const TimeColumns& columns, TimePart part, const CsvRow& row)
{
    const std::string_view cell = cellOf(columns, part, row);
    const std::optional<double> number = cell.empty() ? std::nullopt : decimalOf(cell);
    return number && *number >= 0 && *number < 1e5 ? number : std::nullopt;
}

/** Returns the unchanged cells of these parts, joined. */
std::string joinedCells(const TimeColumns& columns, std::initializer_list<TimePart> parts,
                        const CsvRow& row, char between)
{
    std::string text;
    for (const TimePart part : parts)
        if (const std::string_view cell = cellOf(columns, part, row); !cell.empty())
            text.append(text.empty() ? 0 : 1, between).append(cell.substr(0, 40));
    return text;
}

std::string clockText(double time_s)
{
    const auto whole_ms = static_cast<long long>(std::round(time_s * 1000));
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%02lld:%02lld:%02lld.%03lld", whole_ms / 3'600'000,
                  whole_ms / 60'000 % 60, whole_ms / 1000 % 60, whole_ms % 1000);
    return text.data();
}

/** A date and the fraction of its day. */
struct DayText
{
    std::string text;
    double fraction = 0;
};

std::optional<DayText> dayText(const TimeColumns& columns, const CsvRow& row)
{
    const std::optional<double> year = numberIn(columns, TimePart::Year, row);
    const bool byYear = columns.of(TimePart::DayOfYear).has_value();
    const std::optional<double> day =
        numberIn(columns, byYear ? TimePart::DayOfYear : TimePart::Day, row);
    if (!year || !day || *year != std::floor(*year))
        return std::nullopt;
    const int whole = static_cast<int>(*year);
    const int fullYear = whole >= 100 ? whole : whole + (whole < 70 ? 2000 : 1900);
    const int wholeDay = static_cast<int>(std::floor(*day));
    DayText read{.fraction = *day - wholeDay};
    std::array<char, 32> text{};
    if (byYear) {
        std::snprintf(text.data(), text.size(), "%04d%03d", fullYear, wholeDay);
    } else if (const std::optional<double> month = numberIn(columns, TimePart::Month, row)) {
        std::snprintf(text.data(), text.size(), "%04d-%02d-%02d", fullYear,
                      static_cast<int>(*month), wholeDay);
    } else {
        const std::string name(cellOf(columns, TimePart::Month, row).substr(0, 9));
        std::snprintf(text.data(), text.size(), "%d %s %04d", wholeDay, name.c_str(), fullYear);
    }
    read.text = text.data();
    return read;
}

std::optional<double> clock_s(const TimeColumns& columns, const CsvRow& row)
{
    double time_s = 0;
    for (const auto& [part, each_s, most] :
         {std::tuple(TimePart::Hour, 3600.0, 24.0), std::tuple(TimePart::Minute, 60.0, 59.999),
          std::tuple(TimePart::Second, 1.0, 60.999)}) {
        const std::optional<double> number = numberIn(columns, part, row);
        if (!number && (part == TimePart::Hour || !cellOf(columns, part, row).empty()))
            return std::nullopt;
        if (number.value_or(0) > most)
            return std::nullopt;
        time_s += number.value_or(0) * each_s;
    }
    return time_s <= kDay_s + 1 ? std::optional(time_s) : std::nullopt;
}

} // namespace

bool TimeColumns::formDate() const
{
    return of(TimePart::Year) &&
           (of(TimePart::DayOfYear) || (of(TimePart::Month) && of(TimePart::Day)));
}

std::optional<std::size_t> TimeColumns::firstPart() const
{
    for (const TimePart part :
         {TimePart::Year, TimePart::DayOfYear, TimePart::Month, TimePart::Day, TimePart::Hour})
        if (const std::optional<std::size_t> found = of(part))
            return found;
    return std::nullopt;
}

std::optional<TimePart> timePartOf(std::string_view name)
{
    using enum TimePart;
    static const std::map<std::string_view, TimePart> kNames{{"year", Year},
                                                             {"yr", Year},
                                                             {"yyyy", Year},
                                                             {"month", Month},
                                                             {"mon", Month},
                                                             {"mo", Month},
                                                             {"day", Day},
                                                             {"dd", Day},
                                                             {"dayofmonth", Day},
                                                             {"mday", Day},
                                                             {"doy", DayOfYear},
                                                             {"dayofyear", DayOfYear},
                                                             {"dayoftheyear", DayOfYear},
                                                             {"yearday", DayOfYear},
                                                             {"yday", DayOfYear},
                                                             {"julianday", DayOfYear},
                                                             {"jday", DayOfYear},
                                                             {"jd", DayOfYear},
                                                             {"hour", Hour},
                                                             {"hours", Hour},
                                                             {"hr", Hour},
                                                             {"hh", Hour},
                                                             {"minute", Minute},
                                                             {"minutes", Minute},
                                                             {"min", Minute},
                                                             {"mins", Minute},
                                                             {"mi", Minute},
                                                             {"second", Second},
                                                             {"seconds", Second},
                                                             {"sec", Second},
                                                             {"secs", Second},
                                                             {"ss", Second},
                                                             {"timezone", Zone},
                                                             {"tz", Zone},
                                                             {"timezoneoffset", Zone},
                                                             {"tzoffset", Zone},
                                                             {"utcoffset", Zone},
                                                             {"gmtoffset", Zone},
                                                             {"offsetfromutc", Zone},
                                                             {"timeoffset", Zone}};
    std::string plain = plainName(name);
    for (const std::string_view zone : {"utc", "gmt"})
        if (plain.size() > zone.size() && plain.ends_with(zone))
            plain.resize(plain.size() - zone.size());
    const auto it = kNames.find(plain);
    return it == kNames.end() ? std::nullopt : std::optional(it->second);
}

TimeColumns timeColumnsOf(const std::vector<std::string>& header,
                          const std::function<bool(const std::string&)>& isFree)
{
    TimeColumns columns;
    for (std::size_t i = 0; i < header.size(); ++i)
        if (const std::optional<TimePart> part = timePartOf(header[i]); part && isFree(header[i]))
            if (auto& column = columns.column.at(static_cast<std::size_t>(*part)); !column)
                column = i;
    return columns;
}

std::string dayOfParts(const TimeColumns& columns, const CsvRow& row)
{
    const std::optional<DayText> day = dayText(columns, row);
    return day ? day->text
               : joinedCells(columns,
                             {TimePart::Year, TimePart::Month, TimePart::Day, TimePart::DayOfYear},
                             row, '-');
}

std::string clockOfParts(const TimeColumns& columns, const CsvRow& row)
{
    const std::optional<double> time_s = clock_s(columns, row);
    return time_s ? clockText(*time_s)
                  : joinedCells(columns, {TimePart::Hour, TimePart::Minute, TimePart::Second}, row,
                                ':');
}

std::string timeOfParts(const TimeColumns& columns, const CsvRow& row)
{
    constexpr double kAgree_s = 3600;
    std::string text = dayOfParts(columns, row);
    if (text.empty())
        return clockOfParts(columns, row);
    const std::optional<DayText> day = dayText(columns, row);
    const double fraction_s = day ? day->fraction * kDay_s : 0;
    const std::optional<double> time_s = clock_s(columns, row);
    // A day of the year with a fraction includes the time; hour and minute are more exact.
    if (fraction_s > 0 && (!time_s || std::abs(*time_s - fraction_s) > kAgree_s))
        return text + ' ' + clockText(std::min(fraction_s, kDay_s - 0.001));
    const std::string clock = clockOfParts(columns, row);
    return clock.empty() ? text : text + ' ' + clock;
}

std::optional<std::chrono::minutes> zoneOfCell(std::string_view cell)
{
    if (const std::optional<std::chrono::minutes> zone = parseZone(cell))
        return zone;
    constexpr double kMost_h = 14;
    const std::optional<double> hours = decimalOf(trimmed(cell));
    if (!hours || std::abs(*hours) > kMost_h || std::fmod(*hours * 4, 1) != 0)
        return std::nullopt;
    return std::chrono::minutes(std::lround(*hours * 60));
}

} // namespace berg
