#include "core/io/import/airspace/import_airspace.h"
#include "core/io/import/airspace/openair_shape.h"
#include "core/io/import/airspace/openair_values.h"
#include "core/io/import/fields/import_fields.h"
#include "core/io/text/byte_order_mark.h"
#include "core/io/text/text_lines.h"
#include "core/scenario/utc_time.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace berg {

namespace {

/** Records that do not affect where or when an area is. */
constexpr std::array<std::string_view, 10> kOtherTags{"AF", "AG", "AI", "AX", "AT",
                                                      "SP", "SB", "SA", "AE", "AR"};
constexpr std::array<std::string_view, 5> kShapeTags{"DP", "DC", "DA", "DB", "DY"};

template <std::size_t Size>
bool isTagOf(const std::array<std::string_view, Size>& tags, std::string_view tag)
{
    return std::ranges::find(tags, tag) != tags.end();
}

/** Reads "2026-05-01T12:00Z/2026-05-01T14:00Z"; returns nullopt for anything else. */
std::optional<std::pair<std::string, std::string>> timesOf(std::string_view text)
{
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos)
        return std::nullopt;
    const std::string from(trimmed(text.substr(0, slash)));
    const std::string until(trimmed(text.substr(slash + 1)));
    return isUtcTime(from) && isUtcTime(until) ? std::optional(std::pair(from, until))
                                               : std::nullopt;
}

/** Whether a part of the line is a place, so that the outline may lack it. */
bool mayHoldPlace(const std::string& line)
{
    constexpr std::string_view kDigits = "0123456789";
    for (std::size_t at = line.find_first_of(kDigits); at != std::string::npos;
         at = line.find_first_of(kDigits, line.find_first_not_of(kDigits, at)))
        if (openAirPlace(line.substr(at)))
            return true;
    return false;
}

/** An area while its lines are read. */
struct AreaReading
{
    explicit AreaReading(ReadBudget& budget) : shape(budget) {}

    FileAirspace area;
    OpenAirShape shape;
    bool hasName = false;
    bool hasFloor = false;
    bool hasCeiling = false;
    bool hasColours = false;
    bool isRejected = false;
    bool isAlways = false; ///< a time of the area was not understood

    /** Whether only its class or only its name was read. */
    [[nodiscard]] bool isBare() const
    {
        return shape.isEmpty() && !isRejected && !hasFloor && !hasCeiling;
    }
};

/** Reads a text line by line. */
class OpenAirReading
{
public:
    OpenAirReading(std::string_view text, ReadBudget& budget) : m_rest(text), m_budget(budget) {}

    AirspaceTable take()
    {
        while (!m_rest.empty()) {
            m_budget.throwIfStopped();
            const std::string_view line = takeLine(m_rest);
            ++m_line;
            const OpenAirLine record = openAirLine(line);
            if (!record.tag.empty())
                readRecord(record, line);
        }
        finish();
        return std::move(m_table);
    }

private:
    void readRecord(const OpenAirLine& record, std::string_view line)
    {
        const std::string& tag = record.tag;
        if (tag == "AC")
            readClass(record.value);
        else if (tag == "AN")
            readName(record.value);
        else if (tag.starts_with("TO") || tag.starts_with("TC"))
            beginTerrain();
        else if (m_reading)
            readOfArea(record, line);
        else if (isTagOf(kShapeTags, tag) && !m_isTerrain)
            rejectStray(line);
    }

    /** Begins an area, unless the current one has only its name yet. */
    void readClass(const std::string& value)
    {
        const bool isOfPresent = m_reading && m_reading->hasName && !m_hasClass && !m_mayName &&
                                 m_reading->isBare() && !m_reading->hasColours;
        if (!isOfPresent)
            begin();
        m_hasClass = true;
        m_reading->area.kind = cleanText(value, kLongestId);
    }

    /** Begins an area, unless the current one has no name and no outline yet. */
    void readName(const std::string& value)
    {
        if (!m_reading || m_reading->hasName || !m_reading->shape.isEmpty())
            begin();
        m_reading->hasName = true;
        m_reading->area.name = cleanText(value, kLongestName);
    }

    void begin()
    {
        finish();
        m_isTerrain = false;
        m_reading = std::make_unique<AreaReading>(m_budget);
        m_reading->area.line = m_line;
    }

    /** Ends the area, because lakes and the like have outlines of their own. */
    void beginTerrain()
    {
        finish();
        m_isTerrain = true;
    }

    void readOfArea(const OpenAirLine& record, std::string_view line)
    {
        const std::string& tag = record.tag;
        FileAirspace& area = m_reading->area;
        if (tag == "AY") {
            const std::string type = cleanText(record.value, kLongestId);
            area.kind = type.empty() || openAirLine(type).tag == "UNCLASSIFIED" ? area.kind : type;
        } else if (tag == "AL")
            setFloor(record.value);
        else if (tag == "AH")
            setCeiling(record.value);
        else if (tag == "AA")
            addTimes(record.value);
        else if (tag == "V")
            rejectUnless(m_reading->shape.setVariable(record.value), tag + ' ' + record.value);
        else if (isTagOf(kShapeTags, tag))
            rejectUnless(m_reading->shape.add(tag, record.value), tag + ' ' + record.value);
        else if (isTagOf(kOtherTags, tag))
            m_reading->hasColours = m_reading->hasColours || tag == "SP" || tag == "SB";
        else if (tag.starts_with('D') || tag.starts_with("AC") || mayHoldPlace(std::string(line)))
            rejectUnless(false, std::string(line));
        else
            note(m_line, IssueId::AirspaceLine, cleanText(line, 60));
    }

    /** Sets a floor; of several the lowest is used, as is the highest ceiling. */
    void setFloor(const std::string& value)
    {
        FileAirspace& area = m_reading->area;
        const std::optional<double> height_m = airspaceHeight_m(value, HeightLimit::Floor);
        const double floor_m = std::min(height_m.value_or(0), kLargestLength_m);
        area.floor_m = m_reading->hasFloor ? std::min(area.floor_m, floor_m) : floor_m;
        m_reading->hasFloor = true;
        if (!height_m)
            note(m_line, IssueId::AirspaceFloor, titled(area, "AL " + value));
    }

    void setCeiling(const std::string& value)
    {
        FileAirspace& area = m_reading->area;
        const std::optional<double> height_m = airspaceHeight_m(value, HeightLimit::Ceiling);
        const bool isOpen =
            !height_m || *height_m > kLargestLength_m || (m_reading->hasCeiling && !area.ceiling_m);
        area.ceiling_m =
            isOpen ? std::nullopt : std::optional(std::max(*height_m, area.ceiling_m.value_or(0)));
        m_reading->hasCeiling = true;
        if (!height_m)
            note(m_line, IssueId::AirspaceCeiling, titled(area, "AH " + value));
    }

    /** Extends the times of the area. If one is not understood, the area is always in force. */
    void addTimes(std::string_view value)
    {
        FileAirspace& area = m_reading->area;
        const auto times = timesOf(value.substr(0, value.find(';'))); // a comment follows
        m_reading->isAlways = m_reading->isAlways || !times;
        if (m_reading->isAlways) {
            area.fromUtc.clear();
            area.untilUtc.clear();
            return;
        }
        const auto& [from, until] = *times;
        const auto isBefore = [](const std::string& a, const std::string& b) {
            return parseUtc(a) < parseUtc(b);
        };
        area.fromUtc = area.fromUtc.empty() ? from : std::min(area.fromUtc, from, isBefore);
        area.untilUtc = std::max(area.untilUtc, until, isBefore);
    }

    static std::string titled(const FileAirspace& area, const std::string& text)
    {
        const std::string name = area.name.empty() ? area.kind : area.name;
        const std::string between = name.empty() || text.empty() ? "" : ": ";
        return cleanText(name + between + text, 120);
    }

    void note(std::size_t line, IssueId fault, std::string detail)
    {
        m_table.noted.add({.line = line, .fault = fault, .detail = std::move(detail)});
    }

    /** Rejects the area unless the record was read; reports this once. */
    void rejectUnless(bool isRead, const std::string& text)
    {
        if (isRead || m_reading->isRejected)
            return;
        m_reading->isRejected = true;
        m_table.rejected.add({.line = m_line,
                              .fault = IssueId::AirspaceUnreadable,
                              .detail = titled(m_reading->area, text)});
    }

    /** Reports once that an outline belongs to no area. */
    void rejectStray(std::string_view line)
    {
        m_isTerrain = true;
        m_table.rejected.add(
            {.line = m_line, .fault = IssueId::AirspaceStray, .detail = cleanText(line, 60)});
    }

    void finish()
    {
        if (m_reading)
            store(*m_reading);
        m_reading.reset();
        m_hasClass = false;
    }

    void store(AreaReading& reading)
    {
        FileAirspace& area = reading.area;
        const bool isBare = reading.isBare();
        if (isBare && reading.hasColours && !reading.hasName)
            return; // the colours of a class
        if (isBare && !m_hasClass && m_mayName) {
            nameLast(area.name);
            return;
        }
        m_mayName = false;
        if (reading.isRejected)
            return;
        if (reading.shape.isEmpty()) {
            m_table.rejected.add(
                {.line = area.line, .fault = IssueId::AirspaceBare, .detail = titled(area, {})});
            return;
        }
        noteMissing(reading);
        for (std::vector<LatLon>& outline : reading.shape.outlines()) {
            m_budget.takeRow(sizeof area + area.name.size() + area.kind.size() +
                             outline.size() * sizeof(LatLon));
            m_table.areas.push_back(area);
            m_table.areas.back().rings.push_back(std::move(outline));
        }
        m_mayName = !reading.hasName;
    }

    /** Names the last area, if the name follows its outline. */
    void nameLast(const std::string& name)
    {
        const std::size_t line = m_table.areas.back().line;
        for (auto it = m_table.areas.rbegin(); it != m_table.areas.rend() && it->line == line; ++it)
            it->name = name;
        m_mayName = false;
    }

    void noteMissing(const AreaReading& reading)
    {
        const FileAirspace& area = reading.area;
        if (area.kind.empty())
            note(area.line, IssueId::AirspaceNoClass, titled(area, {}));
        if (!reading.hasFloor)
            note(area.line, IssueId::AirspaceFloor, titled(area, "AL"));
        if (!reading.hasCeiling)
            note(area.line, IssueId::AirspaceCeiling, titled(area, "AH"));
    }

    std::string_view m_rest;
    ReadBudget& m_budget;
    std::size_t m_line = 0;
    AirspaceTable m_table;
    std::unique_ptr<AreaReading> m_reading; ///< null if no area has begun
    bool m_hasClass = false;                ///< the area has its class
    bool m_isTerrain = false;               ///< outlines are those of terrain, not airspace
    bool m_mayName = false; ///< the last area has no name, so the following one may be its name
};

} // namespace

bool isOpenAir(std::string_view text)
{
    text = withoutByteOrderMark(text);
    bool isFirst = true;
    bool hasArea = false;
    while (!text.empty()) {
        const std::string tag = openAirLine(takeLine(text)).tag;
        if (tag.empty())
            continue;
        const bool isArea = tag == "AC" || tag == "AN";
        const bool isKnown = isArea || isTagOf(kOtherTags, tag) || tag == "V" || tag == "AY" ||
                             tag == "AL" || tag == "AH";
        if (isFirst && !isKnown)
            return false;
        isFirst = false;
        hasArea = hasArea || isArea;
        if (hasArea && (isTagOf(kShapeTags, tag) || tag == "AL" || tag == "AH"))
            return true;
    }
    return false;
}

AirspaceTable readOpenAir(std::string_view text, ReadBudget& budget)
{
    return OpenAirReading(text, budget).take();
}

} // namespace berg
