#pragma once

#include "core/scenario/scenario.h"

namespace berg {

// Sizes beyond which planning or checking would take memory or time without end.
inline constexpr std::size_t kMostIcebergs = 1000;
inline constexpr std::size_t kMostUavs = 100;
inline constexpr std::size_t kMostAreaCorners = 2000;
inline constexpr std::size_t kMostTrackPoints = 10'000; ///< of one iceberg

// What nothing that flies is below: smaller numbers make flights that never end.
inline constexpr double kSlowestAirspeed_mps = 1;
inline constexpr double kFastestAirspeed_mps = 1000;
inline constexpr double kSmallestExtent_m = 1; ///< of a field of view, a radius, an altitude
inline constexpr double kShortestFlight_s = 1;

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
