#include "core/link/nmea_reader.h"

#include <array>
#include <charconv>
#include <chrono>
#include <cmath>

namespace berg {

namespace {

constexpr std::size_t kLongestLine = 256; ///< The standard allows 82, receivers send more.
constexpr double kKnot_mps = 1852.0 / 3600;

std::uint8_t nmeaChecksum(std::string_view content)
{
    std::uint8_t sum = 0;
    for (char c : content)
        sum = static_cast<std::uint8_t>(sum ^ static_cast<std::uint8_t>(c));
    return sum;
}

std::vector<std::string_view> fieldsOf(std::string_view content)
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

/** Returns a decimal number in [low, high], or nullopt for any other text. */
std::optional<double> decimal(std::string_view text, double low, double high)
{
    double value = 0;
    const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
    const bool isRead = error == std::errc() && end == text.data() + text.size();
    return isRead && std::isfinite(value) && value >= low && value <= high ? std::optional(value)
                                                                           : std::nullopt;
}

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
std::optional<double> degreesOf(std::string_view text, std::string_view hemisphere, bool isLatitude)
{
    const std::size_t point = std::min(text.find('.'), text.size());
    if (point < 3 || hemisphere.size() != 1)
        return std::nullopt;
    const double limit = isLatitude ? 90 : 180;
    const std::optional<double> degrees = decimal(text.substr(0, point - 2), 0, limit);
    const std::optional<double> minutes = decimal(text.substr(point - 2), 0, 60);
    const bool isPositive = hemisphere == (isLatitude ? "N" : "E");
    const bool isNegative = hemisphere == (isLatitude ? "S" : "W");
    if (!degrees || !minutes || *minutes >= 60 || (!isPositive && !isNegative))
        return std::nullopt;
    const double value = *degrees + *minutes / 60;
    return value > limit ? std::nullopt : std::optional(isPositive ? value : -value);
}

std::optional<LatLon> placeOf(std::span<const std::string_view> four)
{
    const std::optional<double> latitude = degreesOf(four[0], four[1], true);
    const std::optional<double> longitude = degreesOf(four[2], four[3], false);
    if (!latitude || !longitude)
        return std::nullopt;
    return LatLon{.latitude_deg = *latitude, .longitude_deg = *longitude};
}

std::optional<double> timeOf(std::string_view text)
{
    const std::optional<int> hours = twoDigits(text, 0);
    const std::optional<int> minutes = twoDigits(text, 2);
    if (!hours || !minutes || *hours > 23 || *minutes > 59)
        return std::nullopt;
    // Allows a leap second.
    const std::optional<double> seconds = decimal(text.substr(4), 0, 60.999);
    return seconds ? std::optional(3600 * *hours + 60 * *minutes + *seconds) : std::nullopt;
}

/** Returns the time on a day given as "ddmmyy"; years 80 to 99 belong to the last century. */
std::optional<std::int64_t> unixTime(std::string_view date, std::optional<double> timeOfDay_s)
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

std::optional<double> speedOfKnots(std::string_view text)
{
    const std::optional<double> knots = decimal(text, 0, 2000);
    return knots ? std::optional(*knots * kKnot_mps) : std::nullopt;
}

} // namespace

std::vector<NmeaFix> NmeaReader::feed(std::span<const std::uint8_t> bytes)
{
    std::vector<NmeaFix> fixes;
    for (std::uint8_t byte : bytes) {
        if (byte != '\n' && byte != '\r') {
            m_isTooLong = m_isTooLong || m_line.size() >= kLongestLine;
            if (!m_isTooLong)
                m_line.push_back(static_cast<char>(byte));
            continue;
        }
        if (m_isTooLong) {
            ++m_counts.others;
        } else if (!m_line.empty()) {
            if (std::optional<NmeaFix> fix = fixOf(m_line)) {
                ++m_counts.fixes;
                fixes.push_back(std::move(*fix));
            }
        }
        m_line.clear();
        m_isTooLong = false;
    }
    return fixes;
}

std::optional<NmeaFix> NmeaReader::fixOf(std::string_view line)
{
    const std::size_t start = line.rfind('$'); // skips noise and a multiplexer's tag block
    const std::size_t star = line.rfind('*');
    if (start == std::string_view::npos || line.size() < start + 7) {
        ++m_counts.others;
        return std::nullopt;
    }
    const std::string_view sentence = line.substr(start + 3, 3);
    if (sentence != "GGA" && sentence != "RMC" && sentence != "VTG") {
        ++m_counts.others;
        return std::nullopt;
    }
    std::optional<int> sum;
    if (int read = 0;
        star != std::string_view::npos && star > start && line.size() == star + 3 &&
        std::from_chars(line.data() + star + 1, line.data() + line.size(), read, 16).ec ==
            std::errc())
        sum = read;
    const std::string_view content =
        line.substr(start + 1, star == std::string_view::npos ? star : star - start - 1);
    if (sum != nmeaChecksum(content)) {
        ++m_counts.badChecksums;
        return std::nullopt;
    }

    const std::vector<std::string_view> fields = fieldsOf(content);
    const std::span<const std::string_view> all(fields);
    NmeaFix fix{.talker = std::string(content.substr(0, 2)), .sentence = std::string(sentence)};
    bool isFix = true;
    bool isRead = false;
    if (sentence == "GGA" && fields.size() >= 10) {
        isFix = fields[6] != "0" && !fields[6].empty();
        fix.place = placeOf(all.subspan(2, 4));
        fix.timeOfDay_s = timeOf(fields[1]);
        fix.altitude_m = decimal(fields[9], -1000, 100'000);
        isRead = fix.place.has_value();
    } else if (sentence == "RMC" && fields.size() >= 10) {
        isFix = fields[2] == "A";
        fix.place = placeOf(all.subspan(3, 4));
        fix.timeOfDay_s = timeOf(fields[1]);
        fix.unix_us = unixTime(fields[9], fix.timeOfDay_s);
        fix.speed_mps = speedOfKnots(fields[7]);
        fix.course_deg = decimal(fields[8], 0, 360);
        isRead = fix.place.has_value();
    } else if (sentence == "VTG" && fields.size() >= 9) {
        isFix = fields.size() < 10 || fields[9] != "N";
        fix.course_deg = decimal(fields[1], 0, 360);
        fix.speed_mps = speedOfKnots(fields[5]);
        isRead = fix.speed_mps.has_value();
    }
    if (!isFix) {
        ++m_counts.withoutFix;
        return std::nullopt;
    }
    if (!isRead) {
        ++m_counts.malformed;
        return std::nullopt;
    }
    return fix;
}

std::string nmeaSentence(std::string_view content)
{
    constexpr std::string_view kHex = "0123456789ABCDEF";
    const std::uint8_t sum = nmeaChecksum(content);
    std::string sentence = "$";
    sentence += content;
    sentence += '*';
    sentence += kHex[sum / 16U];
    sentence += kHex[sum % 16U];
    return sentence + "\r\n";
}

} // namespace berg
