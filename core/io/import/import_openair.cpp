#include "core/base/angles.h"
#include "core/base/error.h"
#include "core/io/import/import_airspace.h"
#include "core/io/import/import_fields.h"
#include "core/io/text/byte_order_mark.h"
#include "core/io/text/utc_time.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace berg {

namespace {

constexpr double kFoot_m = 0.3048;
constexpr double kMile_m = 1852;
constexpr double kLevel_m = 100 * kFoot_m;
constexpr double kArcStep_rad = 5 * kPi / 180;
constexpr double kLargestRadius_m = 2e6; // more is a mistake

char upper(char c)
{
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

std::string inCapitals(std::string_view text)
{
    std::string capitals(text);
    std::ranges::transform(capitals, capitals.begin(), upper);
    return capitals;
}

void skipBlanks(std::string_view& text)
{
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t'))
        text.remove_prefix(1);
}

/** Takes a number without sign from the front. */
std::optional<double> takeNumber(std::string_view& text)
{
    double value = 0;
    if (text.empty() || text.front() == '-' || text.front() == '+')
        return std::nullopt;
    const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
    if (error != std::errc() || !std::isfinite(value))
        return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

/** Takes "dd:mm:ss H", "dd:mm.mmm H" or "dd.ddd H" with H one of two letters. */
std::optional<double> takeAngle_deg(std::string_view& text, char positive, char negative)
{
    double angle_deg = 0;
    for (const double part : {1.0, 60.0, 3600.0}) {
        skipBlanks(text);
        const std::optional<double> number = takeNumber(text);
        if (!number || (part > 1 && *number >= 60))
            return std::nullopt;
        angle_deg += *number / part;
        skipBlanks(text);
        if (text.empty() || text.front() != ':')
            break;
        text.remove_prefix(1);
    }
    const char letter = text.empty() ? '\0' : upper(text.front());
    if (letter != positive && letter != negative)
        return std::nullopt;
    text.remove_prefix(1);
    return letter == positive ? angle_deg : -angle_deg;
}

std::optional<LatLon> takePlace(std::string_view& text)
{
    const std::optional<double> latitude_deg = takeAngle_deg(text, 'N', 'S');
    const std::optional<double> longitude_deg = takeAngle_deg(text, 'E', 'W');
    if (!latitude_deg || !longitude_deg || *longitude_deg > 180)
        return std::nullopt;
    return scenePlace(*latitude_deg, *longitude_deg);
}

bool takeComma(std::string_view& text)
{
    skipBlanks(text);
    if (text.empty() || text.front() != ',')
        return false;
    text.remove_prefix(1);
    skipBlanks(text);
    return true;
}

/** "2026-05-01T12:00Z/2026-05-01T14:00Z". Of several the whole span; empty: not understood. */
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

/** Reads one text line by line. */
class OpenAirReading
{
public:
    OpenAirReading(std::string_view text, ReadBudget& budget) : m_rest(text), m_budget(budget) {}

    AirspaceTable take()
    {
        while (!m_rest.empty()) {
            m_budget.goOn();
            const std::size_t end = m_rest.find('\n');
            const std::string_view line = trimmed(m_rest.substr(0, end));
            m_rest = end == std::string_view::npos ? std::string_view() : m_rest.substr(end + 1);
            ++m_line;
            if (line.size() > 2 && line.front() != '*')
                readLine(line);
        }
        finish();
        return std::move(m_table);
    }

private:
    void readLine(std::string_view line)
    {
        const std::size_t blank = line.find_first_of(" \t");
        const std::string tag = inCapitals(line.substr(0, blank));
        const std::string_view value =
            blank == std::string_view::npos ? std::string_view() : trimmed(line.substr(blank));
        if (tag == "AC") {
            finish();
            m_area = FileAirspace{.kind = cleanText(value, kLongestId), .line = m_line};
            return;
        }
        if (!m_area)
            return;
        if (tag == "AN")
            m_area->name = cleanText(value, kLongestName);
        else if (tag == "AY" && inCapitals(value) != "UNCLASSIFIED")
            m_area->kind = cleanText(value, kLongestId);
        else if (tag == "AL")
            m_area->floor_m = std::min(airspaceHeight_m(value).value_or(0), kLargestLength_m);
        else if (tag == "AH")
            setCeiling(value);
        else if (tag == "AA")
            addTimes(value);
        else if (tag == "V")
            readVariable(value);
        else if (tag == "DP" || tag == "DC" || tag == "DA" || tag == "DB")
            readShape(tag, value);
    }

    /** From the first to the last of all; always where one of them is not understood. */
    void addTimes(std::string_view value)
    {
        const auto times = timesOf(value);
        m_isAlways = m_isAlways || !times;
        if (m_isAlways) {
            m_area->fromUtc.clear();
            m_area->untilUtc.clear();
            return;
        }
        const auto& [from, until] = *times;
        const auto isBefore = [](const std::string& a, const std::string& b) {
            return parseUtc(a) < parseUtc(b);
        };
        m_area->fromUtc =
            m_area->fromUtc.empty() ? from : std::min(m_area->fromUtc, from, isBefore);
        m_area->untilUtc = std::max(m_area->untilUtc, until, isBefore);
    }

    void setCeiling(std::string_view value)
    {
        const std::optional<double> height_m = airspaceHeight_m(value);
        m_area->ceiling_m = height_m && *height_m <= kLargestLength_m ? height_m : std::nullopt;
    }

    void readVariable(std::string_view value)
    {
        const std::size_t equals = value.find('=');
        if (equals == std::string_view::npos)
            return;
        const std::string name = inCapitals(trimmed(value.substr(0, equals)));
        std::string_view rest = trimmed(value.substr(equals + 1));
        if (name == "X") {
            m_centre = takePlace(rest);
            if (!m_centre)
                reject(value);
        } else if (name == "D") {
            m_isClockwise = !rest.starts_with('-');
        }
    }

    void readShape(const std::string& tag, std::string_view value)
    {
        std::string_view rest = value;
        bool isRead = false;
        if (tag == "DP") {
            const std::optional<LatLon> place = takePlace(rest);
            isRead = place.has_value();
            if (place)
                add(*place);
        } else if (m_centre) {
            isRead = tag == "DC" ? addCircle(rest) : tag == "DA" ? addAngles(rest) : addArc(rest);
        }
        if (!isRead)
            reject(value);
    }

    bool addCircle(std::string_view rest)
    {
        const std::optional<double> radius = takeNumber(rest);
        return radius && addTurn({.radius_m = *radius * kMile_m, .bearing_rad = 0},
                                 {.radius_m = *radius * kMile_m, .bearing_rad = 2 * kPi});
    }

    /** Radius and two bearings from the centre. */
    bool addAngles(std::string_view rest)
    {
        const std::optional<double> radius = takeNumber(rest);
        if (!radius || !takeComma(rest))
            return false;
        const std::optional<double> from_deg = takeNumber(rest);
        if (!from_deg || !takeComma(rest))
            return false;
        const std::optional<double> to_deg = takeNumber(rest);
        return to_deg && *from_deg <= 360 && *to_deg <= 360 &&
               addBetween({.radius_m = *radius * kMile_m, .bearing_rad = radFromDeg(*from_deg)},
                          {.radius_m = *radius * kMile_m, .bearing_rad = radFromDeg(*to_deg)});
    }

    /** Between two places, about the centre. */
    bool addArc(std::string_view rest)
    {
        const std::optional<LatLon> from = takePlace(rest);
        if (!from || !takeComma(rest))
            return false;
        const std::optional<LatLon> to = takePlace(rest);
        if (!to)
            return false;
        add(*from);
        const bool isRead = addBetween(rayTo(*from), rayTo(*to));
        add(*to);
        return isRead;
    }

    /** A place about the centre. */
    struct Ray
    {
        double radius_m = 0;
        double bearing_rad = 0; ///< clockwise from north
    };

    [[nodiscard]] Ray rayTo(const LatLon& place) const
    {
        const Point away_m = LocalFrame(*m_centre).toPlane(place);
        return {.radius_m = away_m.norm(), .bearing_rad = std::atan2(away_m.x(), away_m.y())};
    }

    bool addBetween(const Ray& from, Ray to)
    {
        const double turn_rad = to.bearing_rad - from.bearing_rad;
        const double turns = turn_rad / (2 * kPi);
        const double part = turns - std::floor(turns); // 0: the whole circle
        to.bearing_rad = from.bearing_rad + 2 * kPi *
                                                (!m_isClockwise ? part - 1
                                                 : part > 0     ? part
                                                                : 1);
        return addTurn(from, to);
    }

    bool addTurn(const Ray& from, const Ray& to)
    {
        if (!(from.radius_m <= kLargestRadius_m && to.radius_m <= kLargestRadius_m))
            return false;
        const LocalFrame about(*m_centre);
        const double turn_rad = to.bearing_rad - from.bearing_rad;
        const int steps =
            std::max(1, static_cast<int>(std::ceil(std::abs(turn_rad) / kArcStep_rad)));
        for (int step = 0; step <= steps; ++step) {
            const double part = static_cast<double>(step) / steps;
            const double radius_m = std::lerp(from.radius_m, to.radius_m, part);
            const double bearing_rad = from.bearing_rad + part * turn_rad;
            add(about.toGeographic(
                {radius_m * std::sin(bearing_rad), radius_m * std::cos(bearing_rad)}));
        }
        return true;
    }

    void add(const LatLon& place)
    {
        m_budget.take(3 * sizeof place); // while the ring moves to twice the room
        m_ring.push_back(place);
    }

    /** Told once of an area. */
    void reject(std::string_view text)
    {
        if (m_isRejected)
            return;
        m_isRejected = true;
        m_table.rejected.add(
            {.line = m_line, .fault = IssueId::AirspaceUnreadable, .detail = cleanText(text, 60)});
    }

    void finish()
    {
        if (m_area && m_ring.empty() && !m_isRejected) {
            m_isRejected = true;
            m_table.rejected.add({.line = m_area->line,
                                  .fault = IssueId::AirspaceUnreadable,
                                  .detail = cleanText(m_area->name, 60)});
        }
        if (m_area && !m_isRejected) {
            m_budget.takeRow(sizeof(FileAirspace) + m_area->name.size() + m_area->kind.size());
            m_area->rings.push_back(std::move(m_ring));
            m_table.areas.push_back(std::move(*m_area));
        }
        m_area.reset();
        m_ring.clear();
        m_centre.reset();
        m_isClockwise = true;
        m_isRejected = false;
        m_isAlways = false;
    }

    std::string_view m_rest;
    ReadBudget& m_budget;
    std::size_t m_line = 0;
    AirspaceTable m_table;
    std::optional<FileAirspace> m_area;
    std::vector<LatLon> m_ring;
    std::optional<LatLon> m_centre;
    bool m_isClockwise = true;
    bool m_isRejected = false;
    bool m_isAlways = false; ///< a time of the area was not understood
};

} // namespace

std::optional<double> airspaceHeight_m(std::string_view given)
{
    const std::string capitals = inCapitals(trimmed(given));
    std::string_view text = capitals;
    for (const std::string_view ground : {"GND", "SFC", "MSL"})
        if (text == ground)
            return 0;
    if (text.starts_with("UNL"))
        return HUGE_VAL;
    if (text.starts_with("FL")) {
        text.remove_prefix(2);
        skipBlanks(text);
        const std::optional<double> level = takeNumber(text);
        return level ? std::optional(*level * kLevel_m) : std::nullopt;
    }
    const std::optional<double> number = takeNumber(text);
    if (!number)
        return std::nullopt;
    if (text.starts_with(',') || text.starts_with('E')) // "3,500", "1E+15"
        return std::nullopt;
    skipBlanks(text);
    const bool isMetres = text.starts_with('M') && !text.starts_with("MSL");
    return *number * (isMetres ? 1 : kFoot_m);
}

bool isOpenAir(std::string_view text)
{
    text = withoutByteOrderMark(text);
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        const std::string_view line = trimmed(text.substr(0, end));
        if (!line.empty() && line.front() != '*')
            return line.size() > 3 && inCapitals(line.substr(0, 2)) == "AC" &&
                   (line[2] == ' ' || line[2] == '\t');
        if (end == std::string_view::npos)
            break;
        text.remove_prefix(end + 1);
    }
    return false;
}

AirspaceTable readOpenAir(std::string_view text, ReadBudget& budget)
{
    return OpenAirReading(text, budget).take();
}

} // namespace berg
