#pragma once

#include "core/base/issue.h"
#include "core/scenario/scenario.h"

#include <optional>
#include <string>
#include <vector>

namespace berg {

/**
 * What whoever flies a scenario would want to know before take-off, of one that has no errors:
 * icebergs and UAVs outside the area, icebergs that leave it, at one place, fast or out of reach,
 * UAVs that start near each other in one altitude layer or land on one pad,
 * recorded tracks that do not fit, turns too wide for the field of view, endurance and duration too
 * short, too little room inside the geofence, solvers at their limit, members that are kept but not
 * used. Called by `validate`.
 */
[[nodiscard]] std::vector<Issue> advice(const Scenario& scenario);

/** A hint about the members that are not known of an object of a file, by the name of the first;
 * none when all are. */
[[nodiscard]] std::optional<Issue> unknownMembers(const std::string& field,
                                                  const std::string& extraJson);

/** UAVs whose altitudes differ by less are in one layer, where they have to be kept apart. */
inline constexpr double kLayerHeight_m = 30;

} // namespace berg
