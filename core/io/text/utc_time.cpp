#include "core/io/text/utc_time.h"

#include "core/scenario/text_checks.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace berg {

namespace {

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

void appendDigits(std::string& text, int value, std::size_t width)
{
    const std::string digits = std::to_string(value);
    text.append(width - std::min(width, digits.size()), '0');
    text += digits;
}

} // namespace

std::optional<UtcTime> parseUtc(std::string_view text)
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

std::string utcText(UtcTime start, double after_s)
{
    using namespace std::chrono;
    const UtcTime instant = start + milliseconds(std::llround(after_s * 1e3));
    const sys_days midnight = floor<days>(instant);
    const year_month_day date(midnight);
    const hh_mm_ss<milliseconds> clock(instant - midnight);
    std::string text;
    appendDigits(text, static_cast<int>(date.year()), 4);
    text += '-';
    appendDigits(text, static_cast<int>(static_cast<unsigned>(date.month())), 2);
    text += '-';
    appendDigits(text, static_cast<int>(static_cast<unsigned>(date.day())), 2);
    text += 'T';
    appendDigits(text, static_cast<int>(clock.hours().count()), 2);
    text += ':';
    appendDigits(text, static_cast<int>(clock.minutes().count()), 2);
    text += ':';
    appendDigits(text, static_cast<int>(clock.seconds().count()), 2);
    if (clock.subseconds().count() != 0) {
        text += '.';
        appendDigits(text, static_cast<int>(clock.subseconds().count()), 3);
    }
    return text + 'Z';
}

} // namespace berg
