#pragma once

#include "core/scenario/scenario.h"

namespace berg {

// Sizes beyond which planning or checking would take memory or time without end.
inline constexpr std::size_t kMostIcebergs = 1000;
inline constexpr std::size_t kMostUavs = 100;
inline constexpr std::size_t kMostAreaCorners = 2000;

/**
 * All findings about a scenario at once. Errors: what no program can fly (out of range, not
 * finite, duplicate ids, self-crossing area, wind as fast as the UAV). Warnings: what is kept in
 * the file but not used by this version (more than one UAV, an asset, endurance), wind above 0.7
 * of the airspeed. Hints: nothing to plan. Fields are named by their path in the scenario file.
 */
[[nodiscard]] std::vector<Issue> validate(const Scenario& scenario);

} // namespace berg
