#include "core/scenario/utc_time.h"

#include "core/scenario/text_checks.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

void appendDigits(std::string& text, int value, std::size_t width)
{
    const std::string digits = std::to_string(value);
    text.append(width - std::min(width, digits.size()), '0');
    text += digits;
}

} // namespace

std::optional<UtcTime> parseUtc(std::string_view text)
{
    return utcTimeOf(text);
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

std::string minuteText(UtcTime start, double after_s)
{
    constexpr std::size_t kDay = 10;
    const std::string text = utcText(start, after_s);
    return text.substr(0, kDay) + ' ' + text.substr(kDay + 1, 5);
}

} // namespace berg
