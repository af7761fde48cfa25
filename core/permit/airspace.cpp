#include "core/permit/airspace.h"

#include "core/geometry/outline.h"
#include "core/permit/operation.h"
#include "core/scenario/text_checks.h"

namespace berg {

std::string titleOf(const AirspaceArea& area)
{
    return area.kind + (area.kind.empty() || area.name.empty() ? "" : " ") + area.name;
}

bool isActive(const AirspaceArea& area, const Scenario& scenario)
{
    if (!isUtcTime(scenario.startUtc))
        return true;
    const double start_s = utcSeconds(scenario.startUtc);
    return (!isUtcTime(area.fromUtc) ||
            utcSeconds(area.fromUtc) <= start_s + scenario.duration_s) &&
           (!isUtcTime(area.untilUtc) || utcSeconds(area.untilUtc) >= start_s);
}

bool endsTooEarly(const AirspaceArea& area)
{
    return isUtcTime(area.fromUtc) && isUtcTime(area.untilUtc) &&
           utcSeconds(area.untilUtc) < utcSeconds(area.fromUtc);
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
