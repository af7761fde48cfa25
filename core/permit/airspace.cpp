#include "core/permit/airspace.h"

#include "core/geometry/outline.h"
#include "core/permit/operation.h"
#include "core/scenario/text_checks.h"

#include <charconv>
#include <chrono>

namespace berg {

namespace {

/** Returns the seconds since 1970 for a text accepted by `isUtcTime`. */
double seconds(const std::string& text)
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

} // namespace

std::string titleOf(const AirspaceArea& area)
{
    return area.kind + (area.kind.empty() || area.name.empty() ? "" : " ") + area.name;
}

bool isActive(const AirspaceArea& area, const Scenario& scenario)
{
    if (!isUtcTime(scenario.startUtc))
        return true;
    const double start_s = seconds(scenario.startUtc);
    return (!isUtcTime(area.fromUtc) || seconds(area.fromUtc) <= start_s + scenario.duration_s) &&
           (!isUtcTime(area.untilUtc) || seconds(area.untilUtc) >= start_s);
}

bool endsTooEarly(const AirspaceArea& area)
{
    return isUtcTime(area.fromUtc) && isUtcTime(area.untilUtc) &&
           seconds(area.untilUtc) < seconds(area.fromUtc);
}

std::vector<Issue> airspaceIssues(const Scenario& scenario)
{
    std::vector<Issue> issues;
    if (scenario.airspace.empty())
        return issues;
    const OperationVolume volume =
        operationVolume(scenario, scenario.operation.value_or(Operation()));
    for (std::size_t i = 0; i < scenario.airspace.size(); ++i) {
        const AirspaceArea& area = scenario.airspace[i];
        const std::string path = entryPath("airspace", i);
        if (area.floor_m <= volume.ceiling_m && isActive(area, scenario) &&
            polygonsMeet(volume.outline_m(VolumePart::Contingency), area.corners_m))
            issues.push_back(
                {Severity::Warning,
                 path + ".area_m",
                 {.id = IssueId::AirspaceEntered,
                  .arguments = {titleOf(area).empty() ? path : printable(titleOf(area)),
                                Amount{area.floor_m, Quantity::Height}}}});
    }
    return issues;
}

} // namespace berg
