#pragma once

#include "core/scenario/limits.h"
#include "core/scenario/scenario.h"

namespace berg {

/**
 * All findings about a scenario at once. Errors: what no program can fly (out of range, not
 * finite, duplicate ids, self-crossing area, wind as fast as the UAV). Warnings: what this version
 * does not fly as it stands, wind above 0.7 of the airspeed. Hints: nothing to plan. A scenario
 * without errors also gets the warnings and hints of `advice`. Fields are named by their path in
 * the scenario file.
 */
[[nodiscard]] std::vector<Issue> validate(const Scenario& scenario);

/**
 * Of those errors the ones that no editor can show either: a field that by itself is out of range,
 * not finite or no text, an id that is missing or taken, a list too long. The others are about
 * fields that do not fit together, such as a UAV outside the geofence: such a scenario is saved and
 * opened to be put right, but not flown.
 */
[[nodiscard]] std::vector<Issue> unreadable(const Scenario& scenario);

} // namespace berg
