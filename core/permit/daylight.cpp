#include "core/permit/daylight.h"

#include "core/scenario/text_checks.h"

#include <algorithm>
#include <optional>
#include <string>

namespace berg {

namespace {

std::string padded(int value, std::size_t width)
{
    const std::string digits = std::to_string(value);
    return std::string(width - std::min(width, digits.size()), '0') + digits;
}

/**
 * Returns the time as "06:40", or with its date as "2027-01-16 06:40" if that differs from `day`.
 * The time is cut to the minute.
 */
std::string clockOn(SunTime day, SunTime time)
{
    using namespace std::chrono;
    const sys_days date = floor<days>(time);
    const hh_mm_ss clock(floor<minutes>(time - date));
    std::string text = padded(static_cast<int>(clock.hours().count()), 2) + ':' +
                       padded(static_cast<int>(clock.minutes().count()), 2);
    if (date == floor<days>(day))
        return text;
    const year_month_day shown(date);
    return padded(static_cast<int>(shown.year()), 4) + '-' +
           padded(static_cast<int>(static_cast<unsigned>(shown.month())), 2) + '-' +
           padded(static_cast<int>(static_cast<unsigned>(shown.day())), 2) + ' ' + text;
}

bool isDark(SunTime time, LatLon place)
{
    return sunElevation_deg(time, place) < kCivilTwilight_deg;
}

} // namespace

std::vector<Issue> daylightIssues(std::size_t index, const FlightHours& flight)
{
    std::vector<Issue> issues;
    const auto warn = [&](IssueId id, SunTime time, const std::optional<SunTime>& light) {
        if (light)
            issues.push_back(
                Issue{Severity::Warning,
                      entryPath("uavs", index),
                      {.id = id, .arguments = {clockOn(time, time), clockOn(time, *light)}}});
    };
    if (flight.takeOff && isDark(*flight.takeOff, flight.from))
        warn(IssueId::DarkTakeOff, *flight.takeOff,
             nextRise(*flight.takeOff, flight.from, kCivilTwilight_deg));
    if (isDark(flight.landing, flight.to))
        warn(IssueId::DarkLanding, flight.landing,
             lastSet(flight.landing, flight.to, kCivilTwilight_deg));
    return issues;
}

} // namespace berg
