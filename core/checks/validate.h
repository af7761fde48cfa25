#pragma once

#include "core/scenario/limits.h"
#include "core/scenario/scenario.h"

namespace berg {

/**
 * Returns all findings about a scenario. Errors prevent a flight: values out of range or not
 * finite, duplicate ids, a self-crossing area, wind as fast as the UAV. Warnings concern scenarios
 * that this version cannot fly as given, and wind above 0.7 of the airspeed. Hints report that
 * there is nothing to plan. A scenario without errors also gets the warnings and hints of
 * `scenarioWarnings`. Each finding names its field by the path in the scenario file.
 */
[[nodiscard]] std::vector<Issue> validate(const Scenario& scenario);

/**
 * Returns the errors of `validate` that even an editor cannot show: a single field that is out of
 * range, not finite or not text, an id that is missing or taken, a list that is too long. A
 * positive number below a lower limit above 0 is not among them. The remaining errors mostly
 * concern fields that do not fit together, such as a UAV outside the geofence; such a scenario can
 * be saved and opened for correction, but not flown.
 */
[[nodiscard]] std::vector<Issue> unreadable(const Scenario& scenario);

/**
 * Returns why another object of the scenario cannot have this id, or nullopt if it can: it must be
 * UTF-8 text and unique among icebergs and UAVs.
 */
[[nodiscard]] std::optional<IssueReason> idFault(const Scenario& scenario, const std::string& id);

} // namespace berg
