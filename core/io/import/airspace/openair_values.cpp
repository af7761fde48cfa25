#include "core/io/import/airspace/openair_values.h"

#include "core/earth/coordinate_reader.h"
#include "core/io/import/airspace/import_airspace.h"
#include "core/io/import/fields/import_fields.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace berg {

namespace {

constexpr double kFoot_m = 0.3048;
constexpr double kMile_m = 1852;
constexpr double kLevel_m = 100 * kFoot_m;
constexpr double kLargestRadius_m = 2e6; // a larger radius is an error

bool isDecimalDigit(char c)
{
    return c >= '0' && c <= '9';
}

bool isPlainLetter(char c)
{
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

std::string capitalsOf(std::string_view text)
{
    std::string capitals(text);
    std::ranges::transform(capitals, capitals.begin(), [](char c) {
        return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    });
    return capitals;
}

bool isAmong(std::string_view word, std::initializer_list<std::string_view> words)
{
    return std::ranges::find(words, word) != words.end();
}

template <std::size_t Size>
bool isAmong(std::string_view word, const std::array<std::string_view, Size>& words)
{
    return std::ranges::find(words, word) != words.end();
}

/** Replaces tabs and the narrow and non-breaking blanks of UTF-8 by plain blanks. */
std::string withPlainBlanks(std::string_view line)
{
    constexpr std::array<std::string_view, 4> kBlanks{"\t", "\xC2\xA0", "\xE2\x80\xAF",
                                                      "\xE2\x80\x89"};
    std::string text(line);
    for (const std::string_view blank : kBlanks)
        for (std::size_t at = text.find(blank); at != std::string::npos; at = text.find(blank, at))
            text.replace(at, blank.size(), " ");
    return text;
}

std::string_view withoutComment(std::string_view line)
{
    if (line.starts_with('*') || line.starts_with('#') || line.starts_with(';') ||
        line.starts_with("//"))
        return {};
    return trimmed(line.substr(0, line.find(" *")));
}

/** Whether there is no blank between a tag of two letters and the word behind it. */
bool isGlued(std::string_view word)
{
    const std::string_view tag = word.substr(0, 2);
    const std::string_view rest = word.substr(2);
    if (tag == "AL" || tag == "AH")
        return isAmong(rest, {"FL", "GND", "SFC", "UNL", "UNLIM", "UNLIMITED", "MSL"});
    if (tag == "AC")
        return rest.size() == 1 || isAmong(rest, {"CTR", "TMA", "TMZ", "RMZ", "UNC", "GP"});
    return tag == "DP" && isAmong(rest, {"N", "S", "E", "W"});
}

/** Returns the length of the tag at the start of the line. */
std::size_t tagLength(const std::string& capitals)
{
    const std::size_t letters = static_cast<std::size_t>(
        std::ranges::find_if_not(capitals, isPlainLetter) - capitals.begin());
    const std::string_view word = std::string_view(capitals).substr(0, letters);
    if (isAmong(word, {"VX", "VD", "VW", "VZ", "VT"}))
        return 1;
    if (word.size() > 2 && isGlued(word))
        return 2;
    const bool isTable =
        letters < capitals.size() &&
        std::string_view(",;|\"").find(capitals[letters]) != std::string_view::npos;
    if (!isTable &&
        isAmong(word, {"V", "AC", "AN", "AY", "AL", "AH", "DP", "DC", "DA", "DB", "DY"}))
        return letters;
    return std::min(capitals.find(' '), capitals.size());
}

/** Removes a number without sign from the front and returns it, or returns nullopt. */
std::optional<double> takeNumber(std::string_view& text, bool mayHaveDecimals)
{
    std::size_t end = 0;
    while (end < text.size() && isDecimalDigit(text[end]))
        ++end;
    std::string number(text.substr(0, end));
    if (mayHaveDecimals && end + 1 < text.size() && (text[end] == '.' || text[end] == ',') &&
        isDecimalDigit(text[end + 1])) {
        number += '.';
        while (++end < text.size() && isDecimalDigit(text[end]))
            number += text[end];
    }
    double value = 0;
    const auto [last, error] = std::from_chars(number.data(), number.data() + number.size(), value,
                                               std::chars_format::fixed);
    if (number.empty() || error != std::errc() || last != number.data() + number.size())
        return std::nullopt;
    text.remove_prefix(end);
    return value;
}

void skipSpaces(std::string_view& text)
{
    text = text.substr(std::min(text.size(), text.find_first_not_of(' ')));
}

struct Angle
{
    double angle_deg = 0; ///< with its sign
    std::optional<char> letter;
};

/** Removes and returns the letter of a hemisphere; returns nullopt if none comes next. */
std::optional<char> takeHemisphere(std::string_view& text)
{
    skipSpaces(text);
    const bool isThere =
        !text.empty() && std::string_view("NSEW").find(text.front()) != std::string_view::npos;
    if (!isThere)
        return std::nullopt;
    const char letter = text.front();
    text.remove_prefix(1);
    return letter;
}

/** Reads "dd:mm:ss H", "dd:mm.mmm H", "dd.ddd H", or one with its letter in front. */
std::optional<Angle> takeAngle(std::string_view& text)
{
    Angle angle{.letter = takeHemisphere(text)};
    const bool isInFront = angle.letter.has_value();
    for (const double part : {1.0, 60.0, 3600.0}) {
        skipSpaces(text);
        const std::string_view before = text;
        const std::optional<double> number = takeNumber(text, true);
        if (!number || (part > 1 && *number > 60))
            return std::nullopt;
        angle.angle_deg += *number / part;
        const bool isLast = before.substr(0, before.size() - text.size()).find_first_of(".,") !=
                            std::string_view::npos;
        const std::string_view behind = text;
        text = text.substr(std::min(text.size(), text.find_first_not_of(" :*'\"")));
        if (isLast || text.empty() || !isDecimalDigit(text.front()))
            break;
        if (behind.size() == text.size() || part == 3600)
            return std::nullopt;
    }
    if (!isInFront)
        angle.letter = takeHemisphere(text);
    const char letter = angle.letter.value_or(' ');
    if (letter == 'S' || letter == 'W')
        angle.angle_deg = -angle.angle_deg;
    return angle.letter ? std::optional(angle) : std::nullopt;
}

bool isLatitude(const Angle& angle)
{
    const char letter = angle.letter.value_or(' ');
    return letter == 'N' || letter == 'S';
}

std::optional<LatLon> takePlace(std::string_view& text)
{
    std::optional<Angle> latitude = takeAngle(text);
    skipSpaces(text);
    if (text.starts_with(','))
        text.remove_prefix(1);
    std::optional<Angle> longitude = takeAngle(text);
    if (!latitude || !longitude || isLatitude(*latitude) == isLatitude(*longitude))
        return std::nullopt;
    if (!isLatitude(*latitude))
        std::swap(latitude, longitude);
    if (std::abs(longitude->angle_deg) > 180)
        return std::nullopt;
    return scenePlace(latitude->angle_deg, longitude->angle_deg);
}

/** Splits at commas; a comma is a decimal comma if only that gives three parts. */
std::vector<std::string> threeParts(std::string_view text)
{
    std::vector<std::string> tight;  // parts between all separators
    std::vector<std::string> spaced; // parts between separators with a blank, and semicolons
    const auto split = [&](std::vector<std::string>& parts, const auto& isEnd) {
        std::size_t begin = 0;
        for (std::size_t i = 0; i <= text.size(); ++i)
            if (i == text.size() || isEnd(i)) {
                parts.emplace_back(trimmed(text.substr(begin, i - begin)));
                begin = i + 1;
            }
    };
    const auto isDecimal = [&](std::size_t i) {
        return i > 0 && i + 1 < text.size() && isDecimalDigit(text[i - 1]) &&
               isDecimalDigit(text[i + 1]);
    };
    split(tight, [&](std::size_t i) { return text[i] == ',' || text[i] == ';'; });
    split(spaced,
          [&](std::size_t i) { return text[i] == ';' || (text[i] == ',' && !isDecimal(i)); });
    if (tight.size() == 3)
        return tight;
    return spaced.size() == 3 ? spaced : std::vector<std::string>();
}

/** Reads the whole text as a number from 0 on. */
std::optional<double> wholeNumber(std::string_view text)
{
    const std::optional<double> number = takeNumber(text, true);
    return text.empty() ? number : std::nullopt;
}

/** Reads a number whose thousands may be separated by a blank, comma, point or apostrophe. */
std::optional<double> takeGrouped(std::string_view& text)
{
    const auto isGroup = [&](std::size_t at) {
        return at + 3 < text.size() &&
               std::string_view(" ,.'").find(text[at]) != std::string_view::npos &&
               isDecimalDigit(text[at + 1]) && isDecimalDigit(text[at + 2]) &&
               isDecimalDigit(text[at + 3]) &&
               (at + 4 == text.size() || !isDecimalDigit(text[at + 4]));
    };
    std::size_t end = 0;
    while (end < text.size() && isDecimalDigit(text[end]))
        ++end;
    if (end == 0 || end > 3 || text.front() == '0' || !isGroup(end))
        return takeNumber(text, true);
    std::string digits(text.substr(0, end));
    for (; isGroup(end); end += 4)
        digits += text.substr(end + 1, 3);
    text.remove_prefix(end);
    std::string_view rest = digits;
    return takeNumber(rest, false);
}

constexpr std::array<std::string_view, 16> kReferences{
    "MSL", "AMSL",  "ASL", "AGL",   "AAL",    "AGND", "ALT", "A",
    "STD", "ABOVE", "SEA", "LEVEL", "GROUND", "THE",  "QNH", "MEAN"};
constexpr std::array<std::string_view, 12> kJoining{"OR",     "AND",   "WHICHEVER", "IS",
                                                    "HIGHER", "LOWER", "GREATER",   "HIGHEST",
                                                    "LOWEST", "OF",    "MIN",       "MAX"};
constexpr std::array<std::string_view, 4> kFeet{"FT", "F", "FEET", "FOOT"};
constexpr std::array<std::string_view, 6> kMetres{"M", "METER", "METERS", "METRE", "METRES", "MTR"};
constexpr double kHighestLevel = 999;

/** Reads all heights of a text in capitals, with the words between them. */
class HeightsReading
{
public:
    explicit HeightsReading(std::string_view text) : m_text(text) {}

    /** Returns every height in metres, or an empty list if a part is not understood. */
    std::vector<double> take()
    {
        for (skip(); !m_text.empty(); skip())
            if (!(isDecimalDigit(m_text.front()) ? takeWithUnit() : takeWordOrLevel()))
                return {};
        if (m_hasMetres) // a bare number may be in metres, too
            for (const double number : m_bare)
                m_heights_m.push_back(number);
        return m_heights_m;
    }

private:
    void skip() { m_text = m_text.substr(std::min(m_text.size(), m_text.find_first_not_of(" |"))); }

    std::string_view takeWord()
    {
        skipSpaces(m_text);
        const std::size_t end = static_cast<std::size_t>(
            std::ranges::find_if_not(m_text, isPlainLetter) - m_text.begin());
        const std::string_view word = m_text.substr(0, end);
        m_text.remove_prefix(end);
        return word;
    }

    bool takeWithUnit()
    {
        const std::optional<double> number = takeGrouped(m_text);
        if (!number)
            return false;
        const bool hasMark = m_text.starts_with('\''); // means feet
        m_text.remove_prefix(hasMark ? 1 : 0);
        const std::string_view before = m_text;
        const std::string_view unit = hasMark ? "FT" : takeWord();
        if (unit == "FL")
            return takeLevel(number);
        const bool isMetres = isAmong(unit, kMetres);
        m_hasMetres = m_hasMetres || isMetres;
        m_heights_m.push_back(*number * (isMetres ? 1 : kFoot_m));
        if (!isMetres && !isAmong(unit, kFeet)) {
            m_bare.push_back(*number);
            m_text = before;
        }
        return true;
    }

    bool takeLevel(const std::optional<double>& level)
    {
        if (!level || *level > kHighestLevel)
            return false;
        m_heights_m.push_back(*level * kLevel_m);
        return true;
    }

    bool takeWordOrLevel()
    {
        const std::string_view word = takeWord();
        if (word == "FL") {
            m_text = m_text.substr(std::min(m_text.size(), m_text.find_first_not_of(" .")));
            return takeLevel(takeNumber(m_text, false));
        }
        if (isAmong(word, {"GND", "SFC", "SURFACE"}))
            m_heights_m.push_back(0);
        else if (word.starts_with("UNL"))
            m_heights_m.push_back(HUGE_VAL);
        else
            return isAmong(word, kReferences) || isAmong(word, kJoining);
        return true;
    }

    std::string_view m_text;
    std::vector<double> m_heights_m;
    std::vector<double> m_bare; ///< numbers without unit, which count as feet
    bool m_hasMetres = false;
};

} // namespace

OpenAirLine openAirLine(std::string_view line)
{
    const std::string plain = withPlainBlanks(line);
    const std::string_view text = withoutComment(trimmed(plain));
    if (text.empty())
        return {};
    const std::string capitals = capitalsOf(text);
    const std::size_t length = std::min(tagLength(capitals), text.size());
    return {.tag = capitals.substr(0, length), .value = std::string(trimmed(text.substr(length)))};
}

std::optional<LatLon> openAirPlace(std::string_view text)
{
    const std::string capitals = capitalsOf(plainCharacters(text));
    std::string_view rest = capitals;
    const std::optional<LatLon> place = takePlace(rest);
    return trimmed(rest).empty() ? place : std::nullopt;
}

std::optional<std::pair<LatLon, LatLon>> openAirPlaces(std::string_view text)
{
    const std::string capitals = capitalsOf(plainCharacters(text));
    std::string_view rest = capitals;
    const std::optional<LatLon> from = takePlace(rest);
    skipSpaces(rest);
    if (!from || !rest.starts_with(','))
        return std::nullopt;
    rest.remove_prefix(1);
    const std::optional<LatLon> to = takePlace(rest);
    return to && trimmed(rest).empty() ? std::optional(std::pair(*from, *to)) : std::nullopt;
}

std::optional<double> openAirRadius_m(std::string_view text)
{
    std::string_view rest = trimmed(text);
    const std::optional<double> number = takeNumber(rest, true);
    const std::string unit = capitalsOf(trimmed(rest));
    const bool isMiles = isAmong(unit, {"", "NM", "NMI"});
    if (!number || !(isMiles || isAmong(unit, {"KM", "M"})))
        return std::nullopt;
    const double radius_m = *number * (isMiles ? kMile_m : unit == "KM" ? 1000.0 : 1.0);
    return radius_m > 0 && radius_m <= kLargestRadius_m ? std::optional(radius_m) : std::nullopt;
}

std::optional<OpenAirAngles> openAirAngles(std::string_view text)
{
    const std::vector<std::string> parts = threeParts(text);
    if (parts.empty())
        return std::nullopt;
    const std::optional<double> radius_m = openAirRadius_m(parts[0]);
    const std::optional<double> from_deg = wholeNumber(parts[1]);
    const std::optional<double> to_deg = wholeNumber(parts[2]);
    if (!radius_m || !from_deg || !to_deg || *from_deg > 360 || *to_deg > 360)
        return std::nullopt;
    return OpenAirAngles{.radius_m = *radius_m, .from_deg = *from_deg, .to_deg = *to_deg};
}

std::optional<double> airspaceHeight_m(std::string_view given, HeightLimit limit)
{
    std::string capitals = capitalsOf(trimmed(plainCharacters(given)));
    std::ranges::replace_if(
        capitals, [](char c) { return c == '/' || c == '(' || c == ')' || c == ';'; }, '|');
    if (isAmong(capitals, {"MSL", "GROUND", "SEA LEVEL"}))
        return 0;
    const std::vector<double> heights_m = HeightsReading(capitals).take();
    if (heights_m.empty())
        return std::nullopt;
    return limit == HeightLimit::Floor ? std::ranges::min(heights_m) : std::ranges::max(heights_m);
}

} // namespace berg
