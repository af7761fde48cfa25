#pragma once

#include "core/base/issue.h"
#include "core/scenario/scenario.h"

namespace berg {

/** "TRA Barents West": kind and name, as far as there are any. */
[[nodiscard]] std::string titleOf(const AirspaceArea& area);

/** Whether the area has its rule within the run; true where either of the times is not known. */
[[nodiscard]] bool isActive(const AirspaceArea& area, const Scenario& scenario);

/** Whether both times are known, and it ends before it begins. */
[[nodiscard]] bool endsTooEarly(const AirspaceArea& area);

/** Warnings for airspace that the operation enters (`operationVolume`: contingency volume, from the
 * sea to its height), of a scenario that has no errors. */
[[nodiscard]] std::vector<Issue> airspaceIssues(const Scenario& scenario);

} // namespace berg
