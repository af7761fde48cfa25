#pragma once

#include "core/base/issue.h"
#include "core/scenario/scenario.h"

namespace berg {

/** Returns kind and name, such as "TRA Barents West"; empty if both are missing. */
[[nodiscard]] std::string titleOf(const AirspaceArea& area);

/**
 * Returns true if the airspace is active at some time of the run. An unknown begin or end does not
 * limit the time of activity; if the start of the run is unknown, returns true.
 */
[[nodiscard]] bool isActive(const AirspaceArea& area, const Scenario& scenario);

/** Returns true if both times are known and the airspace ends before it begins. */
[[nodiscard]] bool endsTooEarly(const AirspaceArea& area);

/**
 * Returns a warning for each active airspace that the operation enters, i.e. whose outline meets
 * the contingency volume (`operationVolume`) and whose floor is not above its ceiling. The
 * scenario must have no errors.
 */
[[nodiscard]] std::vector<Issue> airspaceIssues(const Scenario& scenario);

} // namespace berg
