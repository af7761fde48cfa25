#include "core/scenario/text_checks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <optional>

namespace berg {

namespace {

/** Returns the value of `count` digits at `from`, or nullopt if one of them is not a digit. */
std::optional<int> digits(std::string_view text, std::size_t from, std::size_t count)
{
    int value = 0;
    for (const char c : text.substr(from, count)) {
        if (c < '0' || c > '9')
            return std::nullopt;
        value = value * 10 + (c - '0');
    }
    return value;
}

/** Returns the number of `width` digits at `at`; the text has been checked. */
int numberAt(std::string_view text, std::size_t at, std::size_t width)
{
    const std::string_view part = text.substr(at, width);
    int value = 0;
    std::from_chars(part.data(), part.data() + part.size(), value);
    return value;
}

/** Thousandths of a fraction given as "fff...Z". */
int thousandths(std::string_view fraction)
{
    int value = 0;
    for (std::size_t i = 0; i < 3; ++i)
        value = value * 10 + (i + 1 < fraction.size() ? fraction[i] - '0' : 0);
    return value;
}

} // namespace

std::optional<IssueReason> outOfLimits(double value, const Limits& limits)
{
    const bool lowOk = limits.above ? value > limits.low : value >= limits.low;
    if (lowOk && value <= limits.high)
        return std::nullopt;
    if (!std::isfinite(value))
        return IssueReason{.id = IssueId::NotFinite};
    return IssueReason{.id = limits.above ? IssueId::OutOfOpenRange : IssueId::OutOfRange,
                       .arguments = {limits.low, limits.high, value}};
}

std::string entryPath(const std::string& list, std::size_t i)
{
    return list + '[' + std::to_string(i) + ']';
}

std::string printable(std::string_view text)
{
    constexpr std::size_t kLongest = 40;
    std::size_t end = std::min(text.size(), kLongest);
    // A multi-byte character is never cut.
    while (end > 0 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
        --end;
    std::string shown(text.substr(0, end));
    for (char& c : shown)
        if (static_cast<unsigned char>(c) < 0x20U || c == 0x7F)
            c = '?';
    return end < text.size() ? shown + "..." : shown;
}

double utcSeconds(std::string_view text)
{
    const auto number = [&](std::size_t from, std::size_t length) {
        int value = 0;
        std::from_chars(text.data() + from, text.data() + from + length, value);
        return value;
    };
    const std::chrono::sys_days day = std::chrono::year_month_day(
        std::chrono::year(number(0, 4)), std::chrono::month(static_cast<unsigned>(number(5, 2))),
        std::chrono::day(static_cast<unsigned>(number(8, 2))));
    double time_s = 86400.0 * static_cast<double>(day.time_since_epoch().count()) +
                    3600.0 * number(11, 2) + 60.0 * number(14, 2);
    if (text.size() > 17) // the fraction does not matter here
        time_s += number(17, 2);
    return time_s;
}

bool isUtf8(std::string_view text)
{
    // Smallest code point by number of bytes after the lead; a smaller one is an overlong form.
    constexpr std::array<std::uint32_t, 4> kSmallest{0, 0x80, 0x800, 0x10000};
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i++]);
        const int ones = std::countl_one(lead); // 0, or the number of bytes of the character
        const std::size_t following = ones == 0 ? 0 : static_cast<std::size_t>(ones - 1);
        if (ones == 1 || ones > 4 || text.size() - i < following)
            return false;
        std::uint32_t code = lead & (0x7FU >> ones);
        for (std::size_t k = 0; k < following; ++k) {
            const auto byte = static_cast<unsigned char>(text[i++]);
            if ((byte & 0xC0U) != 0x80U)
                return false;
            code = (code << 6U) | (byte & 0x3FU);
        }
        const bool surrogate = code >= 0xD800U && code <= 0xDFFFU;
        if (code < kSmallest[following] || surrogate || code > 0x10FFFFU)
            return false;
    }
    return true;
}

bool isUtcTime(std::string_view text)
{
    // Format: YYYY-MM-DDThh:mm:ss, then an optional fraction, then Z.
    constexpr std::string_view kPattern = "dddd-dd-ddTdd:dd:dd";
    constexpr std::size_t kMostFractionDigits = 9;
    const std::size_t length = kPattern.size();
    constexpr std::size_t kWithoutSeconds = 17;
    if (text.size() == kWithoutSeconds && text.back() == 'Z')
        return isUtcTime(std::string(text.substr(0, kWithoutSeconds - 1)) + ":00Z");
    if (text.size() <= length || text.back() != 'Z')
        return false;
    for (std::size_t i = 0; i < length; ++i)
        if (kPattern[i] != 'd' && text[i] != kPattern[i])
            return false;
    const std::string_view fraction = text.substr(length, text.size() - length - 1);
    if (!fraction.empty() &&
        (fraction[0] != '.' || fraction.size() < 2 || fraction.size() > kMostFractionDigits + 1 ||
         !digits(fraction, 1, fraction.size() - 1)))
        return false;

    const std::optional<int> year = digits(text, 0, 4);
    const std::optional<int> month = digits(text, 5, 2);
    const std::optional<int> day = digits(text, 8, 2);
    const std::optional<int> hour = digits(text, 11, 2);
    const std::optional<int> minute = digits(text, 14, 2);
    const std::optional<int> second = digits(text, 17, 2);
    if (!year || !month || !day || !hour || !minute || !second)
        return false;
    const std::chrono::year_month_day date{std::chrono::year(*year),
                                           std::chrono::month(static_cast<unsigned>(*month)),
                                           std::chrono::day(static_cast<unsigned>(*day))};
    return date.ok() && *hour <= 23 && *minute <= 59 && *second <= 59;
}

std::optional<std::chrono::sys_time<std::chrono::milliseconds>> utcTimeOf(std::string_view text)
{
    using namespace std::chrono;
    if (!isUtcTime(text))
        return std::nullopt;
    // YYYY-MM-DDThh:mm, then Z, :ssZ or :ss.fff...Z
    const year_month_day date{year(numberAt(text, 0, 4)),
                              month(static_cast<unsigned>(numberAt(text, 5, 2))),
                              day(static_cast<unsigned>(numberAt(text, 8, 2)))};
    constexpr std::size_t kPoint = 19;
    const bool hasFraction = text.size() > kPoint && text[kPoint] == '.';
    const int millisecond = hasFraction ? thousandths(text.substr(kPoint + 1)) : 0;
    return sys_days(date) + hours(numberAt(text, 11, 2)) + minutes(numberAt(text, 14, 2)) +
           seconds(numberAt(text, 17, 2)) + milliseconds(millisecond);
}

} // namespace berg
