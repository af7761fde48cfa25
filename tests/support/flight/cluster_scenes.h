#pragma once

#include "core/presets/presets.h"
#include "tests/support/flight/scenario_builder.h"

#include <vector>

namespace berg::test {

using Groups = std::vector<std::vector<int>>; ///< indices of tracks
using Clusters = std::vector<IcebergList>;

/**
 * Two stationary icebergs, 0 and 2, 400 m apart across the path, 2 km ahead, and one far beyond.
 */
inline Scenario pairAhead()
{
    Scenario scenario = emptySea();
    scenario.clusters = true;
    scenario.planner.policy = PolicyKind::Nearest;
    addIceberg(scenario, 2000, 200, 3);
    addIceberg(scenario, 5000, 0, 5);
    addIceberg(scenario, 2000, -200, 4);
    return scenario;
}

/** Returns 14 icebergs so close together that many are within one field of view. */
inline Scenario crowd(std::int64_t seed)
{
    Scenario scenario = randomScenario(seed, {.icebergs = 14, .size_m = Point(2500, 2000)});
    scenario.clusters = true;
    return scenario;
}

} // namespace berg::test
