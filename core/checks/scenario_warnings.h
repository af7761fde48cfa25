#pragma once

#include "core/base/issue.h"
#include "core/scenario/scenario.h"

#include <optional>
#include <string>
#include <vector>

namespace berg {

/**
 * Returns warnings and hints that matter before take-off, for a scenario without errors: icebergs
 * and UAVs outside the area, icebergs that leave it, share a place, drift fast or are out of reach,
 * UAVs that start near each other in one altitude layer or land on one pad, recorded tracks that do
 * not fit, turns too wide for the field of view, endurance and duration too short, too little room
 * inside the geofence, solvers at their limit, and members of the file that are stored but not
 * used. Called by `validate`. Throws `std::logic_error` for a scenario without UAVs.
 */
[[nodiscard]] std::vector<Issue> scenarioWarnings(const Scenario& scenario);

/**
 * Returns a hint about unknown members of a file's object, naming the first, or nullopt if there
 * are none.
 */
[[nodiscard]] std::optional<Issue> unknownMembers(const std::string& field,
                                                  const std::string& extraJson);

} // namespace berg
