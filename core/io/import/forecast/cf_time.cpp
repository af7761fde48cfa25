#include "core/io/import/forecast/cf_time.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace berg {

namespace {

using CfSeconds = std::chrono::duration<double>;

std::string lowerCased(std::string_view text)
{
    std::string lower(text);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z')
            c = static_cast<char>(c - 'A' + 'a');
    return lower;
}

std::optional<CfSeconds> lengthOfUnit(std::string_view name)
{
    struct NamedUnit
    {
        std::string_view name;
        double length_s;
    };
    constexpr std::array<NamedUnit, 18> kUnits{{{"milliseconds", 1e-3},
                                                {"millisecond", 1e-3},
                                                {"msec", 1e-3},
                                                {"ms", 1e-3},
                                                {"seconds", 1},
                                                {"second", 1},
                                                {"sec", 1},
                                                {"secs", 1},
                                                {"s", 1},
                                                {"minutes", 60},
                                                {"minute", 60},
                                                {"min", 60},
                                                {"mins", 60},
                                                {"hours", 3600},
                                                {"hour", 3600},
                                                {"hr", 3600},
                                                {"h", 3600},
                                                {"days", 86400}}};
    if (name == "day" || name == "d")
        name = "days";
    for (const NamedUnit& unit : kUnits)
        if (unit.name == name)
            return CfSeconds(unit.length_s);
    return std::nullopt;
}

/** Reads a date and time from the front of a text. */
class DateReader
{
public:
    explicit DateReader(std::string_view text) : m_rest(text) {}

    void skipBlanks()
    {
        while (!m_rest.empty() && m_rest.front() == ' ')
            m_rest.remove_prefix(1);
    }
    bool skip(char c)
    {
        if (m_rest.empty() || m_rest.front() != c)
            return false;
        m_rest.remove_prefix(1);
        return true;
    }
    [[nodiscard]] bool atDigit() const
    {
        return !m_rest.empty() && m_rest.front() >= '0' && m_rest.front() <= '9';
    }
    [[nodiscard]] bool atEnd() const { return m_rest.empty(); }
    [[nodiscard]] std::string_view rest() const { return m_rest; }

    /** Reads a whole number without a sign. */
    std::optional<int> whole()
    {
        int value = 0;
        if (!atDigit())
            return std::nullopt;
        const auto [end, error] =
            std::from_chars(m_rest.data(), m_rest.data() + m_rest.size(), value);
        if (error != std::errc())
            return std::nullopt;
        m_rest.remove_prefix(static_cast<std::size_t>(end - m_rest.data()));
        return value;
    }
    /** Reads a number without a sign, with or without decimals. */
    std::optional<double> decimal()
    {
        double value = 0;
        if (!atDigit())
            return std::nullopt;
        const auto [end, error] = std::from_chars(m_rest.data(), m_rest.data() + m_rest.size(),
                                                  value, std::chars_format::fixed);
        if (error != std::errc())
            return std::nullopt;
        m_rest.remove_prefix(static_cast<std::size_t>(end - m_rest.data()));
        return value;
    }

private:
    std::string_view m_rest;
};

/** Days from 1970-01-01 of the Gregorian calendar to a date of the Julian calendar. */
std::chrono::sys_days julianDay(int year, unsigned month, unsigned day)
{
    // After Meeus, Astronomical Algorithms, 7.1; 2440587.5 is the Julian day of 1970-01-01.
    const int y = month > 2 ? year : year - 1;
    const unsigned m = month > 2 ? month : month + 12;
    const double number = std::floor(365.25 * (y + 4716)) + std::floor(30.6001 * (m + 1)) +
                          static_cast<double>(day) - 1524.5;
    return std::chrono::sys_days(std::chrono::days(std::lround(number - 2440587.5)));
}

std::optional<std::chrono::sys_days> readDate(DateReader& reader, bool mayBeJulian)
{
    const std::optional<int> year = reader.whole();
    if (!year || *year > 9999 || !reader.skip('-'))
        return std::nullopt;
    const std::optional<int> month = reader.whole();
    if (!month || *month < 1 || *month > 12 || !reader.skip('-'))
        return std::nullopt;
    const std::optional<int> day = reader.whole();
    if (!day || *day < 1 || *day > 31)
        return std::nullopt;
    const auto m = static_cast<unsigned>(*month);
    const auto d = static_cast<unsigned>(*day);
    if (mayBeJulian && (*year * 100 + *month) * 100 + *day < 15821015)
        return julianDay(*year, m, d);
    const std::chrono::year_month_day date{std::chrono::year(*year), std::chrono::month(m),
                                           std::chrono::day(d)};
    return date.ok() ? std::optional<std::chrono::sys_days>(date) : std::nullopt;
}

/** Reads "06:00:00.5", "06:00" or "06", 0 if nothing is left. */
std::optional<CfSeconds> readTimeOfDay(DateReader& reader)
{
    reader.skipBlanks();
    if (!reader.skip('t'))
        (void)reader.skip('T');
    if (!reader.atDigit())
        return CfSeconds(0);
    const std::optional<int> hours = reader.whole();
    std::optional<int> minutes = 0;
    std::optional<double> seconds = 0;
    if (reader.skip(':')) {
        minutes = reader.whole();
        if (reader.skip(':'))
            seconds = reader.decimal();
    }
    if (!hours || !minutes || !seconds || *hours > 24 || *minutes > 59 || *seconds >= 61)
        return std::nullopt;
    return CfSeconds(*hours * 3600.0 + *minutes * 60.0 + *seconds);
}

/** Reads "Z", "UTC", "+01:00", "-0130" or "+1", 0 if nothing is left. */
std::optional<CfSeconds> readOffset(DateReader& reader)
{
    reader.skipBlanks();
    const std::string_view rest = reader.rest();
    if (rest.empty() || rest == "z" || rest == "utc" || rest == "gmt")
        return CfSeconds(0);
    const bool isWest = reader.skip('-');
    if (!isWest && !reader.skip('+'))
        return std::nullopt;
    const std::size_t before = reader.rest().size();
    std::optional<int> hours = reader.whole();
    std::optional<int> minutes = 0;
    if (hours && before - reader.rest().size() > 2) {
        minutes = *hours % 100;
        hours = *hours / 100;
    } else if (reader.skip(':')) {
        minutes = reader.whole();
    }
    if (!hours || !minutes || *hours > 18 || *minutes > 59 || !reader.atEnd())
        return std::nullopt;
    const double offset_s = *hours * 3600.0 + *minutes * 60.0;
    return CfSeconds(isWest ? -offset_s : offset_s);
}

} // namespace

std::optional<CfTimeUnit> cfTimeUnit(std::string_view unit, std::string_view calendar)
{
    const std::string kind = lowerCased(calendar);
    const bool isMixed = kind.empty() || kind == "standard" || kind == "gregorian";
    if (!isMixed && kind != "proleptic_gregorian" && kind != "utc" && kind != "tai")
        return std::nullopt;
    const std::string text = lowerCased(unit);
    const std::size_t blank = text.find(' ');
    const std::size_t since = text.find(" since ");
    if (blank == std::string::npos || since == std::string::npos || since != blank)
        return std::nullopt;
    const std::optional<CfSeconds> length = lengthOfUnit(text.substr(0, blank));
    std::string_view date = std::string_view(text).substr(since + 7);
    while (!date.empty() && (date.back() == ' ' || date.back() == '\0'))
        date.remove_suffix(1);
    DateReader reader(date);
    reader.skipBlanks();
    const std::optional<std::chrono::sys_days> day = readDate(reader, isMixed);
    if (!length || !day)
        return std::nullopt;
    const std::optional<CfSeconds> time = readTimeOfDay(reader);
    const std::optional<CfSeconds> offset = time ? readOffset(reader) : std::nullopt;
    if (!offset)
        return std::nullopt;
    return CfTimeUnit{.unit = *length,
                      .origin = ForecastTime(*day) +
                                std::chrono::round<std::chrono::milliseconds>(*time - *offset)};
}

std::optional<ForecastTime> cfTime(const CfTimeUnit& unit, double value)
{
    using namespace std::chrono;
    constexpr double kMost_s = 3e11; // far beyond the years that follow, far within 64 bits
    const CfSeconds after = value * unit.unit;
    if (!std::isfinite(value) || std::abs(after.count()) > kMost_s)
        return std::nullopt;
    const ForecastTime time = unit.origin + round<milliseconds>(after);
    if (time < sys_days(year(1000) / 1 / 1) || time > sys_days(year(3000) / 1 / 1))
        return std::nullopt;
    return time;
}

} // namespace berg
