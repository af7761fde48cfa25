#include "core/base/error.h"
#include "core/io/import/fields/import_fields.h"
#include "core/io/import/missions/import_mission.h"
#include "core/io/import/missions/mission_readers.h"
#include "core/io/text/byte_order_mark.h"
#include "core/scenario/text_checks.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace berg {

namespace {

constexpr std::string_view kHead = "QGC WPL";
constexpr std::string_view kBlanks = " \t\r\v\f";

/**
 * Number of columns: index, current, frame, command, p1 .. p4, latitude, longitude, altitude,
 * autocontinue.
 */
constexpr std::size_t kColumns = 12;
using Columns = std::array<std::string_view, kColumns>;
constexpr std::size_t kIndex = 0;
constexpr std::size_t kFrame = 2;
constexpr std::size_t kCommand = 3;
constexpr std::size_t kParam1 = 4;
constexpr std::size_t kParam2 = 5;
constexpr std::size_t kLatitude = 8;
constexpr std::size_t kLongitude = 9;
constexpr std::size_t kAltitude = 10;

constexpr std::int64_t kWaypoint = 16;

/** Whether the text is a number of the C locale, including `nan`, which means none. */
bool isNumber(std::string_view text)
{
    if (text.starts_with('+'))
        text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

/** Reads a file line by line. */
class WplReading
{
public:
    explicit WplReading(const ImportText& source)
        : m_budget(source.budget), m_rest(withoutByteOrderMark(source.text)), m_places(source)
    {
    }

    SightingTable take()
    {
        const bool firstIsHome = readHead();
        bool first = true;
        while (nextLine()) {
            m_budget.throwIfStopped();
            if (trimmed(m_text).empty()) {
                m_comment = {};
                continue;
            }
            if (trimmed(m_text).starts_with('#')) {
                m_comment = trimmed(trimmed(m_text).substr(1));
                continue;
            }
            readRow(first && firstIsHome);
            first = false;
        }
        return m_places.take();
    }

private:
    [[noreturn]] void fail(IssueReason reason, ErrorCode code = ErrorCode::SyntaxError) const
    {
        throw Error(code, m_budget.subject(),
                    {{Severity::Error, "line " + std::to_string(m_line), std::move(reason)}});
    }

    bool nextLine()
    {
        if (m_rest.empty())
            return false;
        const std::size_t end = m_rest.find('\n');
        m_text = m_rest.substr(0, end);
        m_rest = end == std::string_view::npos ? std::string_view() : m_rest.substr(end + 1);
        ++m_line;
        return true;
    }

    /** Reads the header. Returns whether the first row is the home. */
    bool readHead()
    {
        nextLine();
        if (!m_text.starts_with(kHead))
            fail({IssueId::NotFormat, {"QGC WPL 110"}}, ErrorCode::WrongFormat);
        const std::string_view version = trimmed(m_text.substr(kHead.size()));
        if (version != "110" && version != "120")
            fail({IssueId::UnknownVersion,
                  {'"' + printable(cleanText(version, 20)) + '"', "110, 120"}},
                 ErrorCode::UnsupportedVersion);
        return version == "110";
    }

    void readRow(bool mayBeHome)
    {
        const std::size_t mark = m_text.find('#');
        if (mark != std::string_view::npos)
            m_comment = trimmed(m_text.substr(mark + 1));
        const Columns columns = columnsOf(m_text.substr(0, mark));
        const MissionItem item{.line = m_line,
                               .command = whole(columns[kCommand]),
                               .frame = whole(columns[kFrame]),
                               .param1 = std::string(columns[kParam1]),
                               .param2 = std::string(columns[kParam2]),
                               .latitude = std::string(columns[kLatitude]),
                               .longitude = std::string(columns[kLongitude]),
                               .altitude = std::string(columns[kAltitude]),
                               .name = std::string(m_comment)};
        m_comment = {};
        // Some writers declare 110 but leave out the home, so their first row is an item.
        if (mayBeHome && whole(columns[kIndex]) == 0 && item.command == kWaypoint)
            m_places.setHome(item);
        else
            m_places.add(item);
    }

    [[nodiscard]] Columns columnsOf(std::string_view row) const
    {
        Columns columns;
        std::size_t count = 0;
        for (std::size_t at = row.find_first_not_of(kBlanks); at != std::string_view::npos;
             at = row.find_first_not_of(kBlanks, at)) {
            const std::size_t end = std::min(row.find_first_of(kBlanks, at), row.size());
            if (count < kColumns)
                columns[count] = row.substr(at, end - at);
            ++count;
            at = end;
        }
        if (count != kColumns)
            fail({IssueId::ColumnCount, {12, countOf(count)}});
        for (const std::string_view column : columns)
            if (!isNumber(column))
                fail(notANumber(column));
        return columns;
    }

    static IssueReason notANumber(std::string_view column)
    {
        const bool comma = column.find(',') != std::string_view::npos;
        return {comma ? IssueId::DecimalComma : IssueId::NotANumber,
                {printable(cleanText(column, 40))}};
    }

    [[nodiscard]] std::int64_t whole(std::string_view column) const
    {
        constexpr std::int64_t kLargest = 65535;
        std::int64_t value = 0;
        const auto [end, error] =
            std::from_chars(column.data(), column.data() + column.size(), value);
        if (error != std::errc() || end != column.data() + column.size() || value < 0 ||
            value > kLargest)
            fail({IssueId::NotWhole, {0, kLargest, '"' + printable(cleanText(column, 40)) + '"'}});
        return value;
    }

    ReadBudget& m_budget;
    std::string_view m_rest;
    std::string_view m_text; ///< current line
    std::size_t m_line = 0;
    std::string_view m_comment; ///< name in the line above
    MissionPlaces m_places;
};

} // namespace

SightingTable readWpl(const ImportText& source)
{
    return WplReading(source).take();
}

bool isWpl(std::string_view text)
{
    return withoutByteOrderMark(text).starts_with(kHead);
}

} // namespace berg
