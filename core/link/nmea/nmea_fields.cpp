#include "core/link/nmea/nmea_fields.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>

namespace berg {

namespace {

/** Returns the two-digit number at `at`. */
std::optional<int> twoDigits(std::string_view text, std::size_t at)
{
    if (text.size() < at + 2)
        return std::nullopt;
    int value = 0;
    for (char c : text.substr(at, 2)) {
        if (c < '0' || c > '9')
            return std::nullopt;
        value = 10 * value + (c - '0');
    }
    return value;
}

/** Parses "ddmm.mmm" (or "dddmm.mmm") and its hemisphere. */
std::optional<double> nmeaDegrees(std::string_view text, std::string_view hemisphere,
                                  bool isLatitude)
{
    const std::size_t point = std::min(text.find('.'), text.size());
    if (point < 3 || hemisphere.size() != 1)
        return std::nullopt;
    const double limit = isLatitude ? 90 : 180;
    const std::optional<double> degrees = nmeaNumber(text.substr(0, point - 2), 0, limit);
    const std::optional<double> minutes = nmeaNumber(text.substr(point - 2), 0, 60);
    const bool isPositive = hemisphere == (isLatitude ? "N" : "E");
    const bool isNegative = hemisphere == (isLatitude ? "S" : "W");
    if (!degrees || !minutes || *minutes >= 60 || (!isPositive && !isNegative))
        return std::nullopt;
    const double value = *degrees + *minutes / 60;
    return value > limit ? std::nullopt : std::optional(isPositive ? value : -value);
}

} // namespace

std::uint8_t nmeaChecksum(std::string_view content)
{
    std::uint8_t sum = 0;
    for (char c : content)
        sum = static_cast<std::uint8_t>(sum ^ static_cast<std::uint8_t>(c));
    return sum;
}

bool hasNmeaChecksum(std::string_view line, std::string_view content)
{
    if (line.size() < 3 || line[line.size() - 3] != '*')
        return false;
    int read = 0;
    const char* const end = line.data() + line.size();
    const auto [stop, error] = std::from_chars(end - 2, end, read, 16);
    return error == std::errc() && stop == end && read == nmeaChecksum(content);
}

std::vector<std::string_view> nmeaFields(std::string_view content)
{
    std::vector<std::string_view> fields;
    while (true) {
        const std::size_t comma = content.find(',');
        fields.push_back(content.substr(0, comma));
        if (comma == std::string_view::npos)
            return fields;
        content.remove_prefix(comma + 1);
    }
}

std::optional<double> nmeaNumber(std::string_view text, double low, double high)
{
    double value = 0;
    const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
    const bool isRead = error == std::errc() && end == text.data() + text.size();
    return isRead && std::isfinite(value) && value >= low && value <= high ? std::optional(value)
                                                                           : std::nullopt;
}

std::optional<LatLon> nmeaPlace(std::span<const std::string_view> four)
{
    const std::optional<double> latitude = nmeaDegrees(four[0], four[1], true);
    const std::optional<double> longitude = nmeaDegrees(four[2], four[3], false);
    if (!latitude || !longitude)
        return std::nullopt;
    return LatLon{.latitude_deg = *latitude, .longitude_deg = *longitude};
}

std::optional<double> nmeaTimeOfDay(std::string_view text)
{
    const std::optional<int> hours = twoDigits(text, 0);
    const std::optional<int> minutes = twoDigits(text, 2);
    if (!hours || !minutes || *hours > 23 || *minutes > 59)
        return std::nullopt;
    // Allows a leap second.
    const std::optional<double> seconds = nmeaNumber(text.substr(4), 0, 60.999);
    return seconds ? std::optional(3600 * *hours + 60 * *minutes + *seconds) : std::nullopt;
}

std::optional<std::int64_t> nmeaUnixTime(std::string_view date, std::optional<double> timeOfDay_s)
{
    const std::optional<int> day = twoDigits(date, 0);
    const std::optional<int> month = twoDigits(date, 2);
    const std::optional<int> year = twoDigits(date, 4);
    if (date.size() != 6 || !day || !month || !year || !timeOfDay_s)
        return std::nullopt;
    const std::chrono::year_month_day value{std::chrono::year(*year + (*year < 80 ? 2000 : 1900)),
                                            std::chrono::month(static_cast<unsigned>(*month)),
                                            std::chrono::day(static_cast<unsigned>(*day))};
    if (!value.ok())
        return std::nullopt;
    const std::int64_t days = std::chrono::sys_days(value).time_since_epoch().count();
    return days * 86'400'000'000 + std::llround(1e6 * *timeOfDay_s);
}

std::optional<double> nmeaSpeed(std::string_view knots)
{
    const std::optional<double> value = nmeaNumber(knots, 0, 2000);
    return value ? std::optional(*value * kKnot_mps) : std::nullopt;
}

std::optional<std::int64_t> nmeaTagTime(std::string_view before)
{
    constexpr std::int64_t kFirstInMilliseconds = 100'000'000'000; // in seconds: the year 5138
    constexpr std::int64_t kLast_ms = 4'102'444'800'000;           // the year 2100
    if (before.size() < 6 || before.back() != '\\')
        return std::nullopt;
    before.remove_suffix(1);
    const std::size_t start = before.rfind('\\');
    const std::size_t star = before.rfind('*');
    if (start == std::string_view::npos || star == std::string_view::npos || star < start)
        return std::nullopt;
    const std::string_view content = before.substr(start + 1, star - start - 1);
    if (!hasNmeaChecksum(before, content))
        return std::nullopt;
    for (std::string_view field : nmeaFields(content)) {
        if (!field.starts_with("c:"))
            continue;
        field.remove_prefix(2);
        std::int64_t value = 0;
        const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
        if (error != std::errc() || end != field.data() + field.size() || value < 0)
            return std::nullopt;
        const std::int64_t time_ms = value < kFirstInMilliseconds ? 1000 * value : value;
        return time_ms < kLast_ms ? std::optional(1000 * time_ms) : std::nullopt;
    }
    return std::nullopt;
}

} // namespace berg
