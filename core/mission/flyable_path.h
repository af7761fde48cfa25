#pragma once

#include "core/mission/visits.h"

#include <vector>

namespace berg {

/** Flown path through an order, turns included. */
struct FlyablePath
{
    std::vector<TrackPoint> track; ///< one point per second, and the end
    /** Times at which each iceberg is in view or reached, and the arrival home. */
    std::vector<Visit> visits;
};

/**
 * Flies a UAV's plan with the first UAV of the scene from its start, with the simulation that flies
 * missions but without replanning. Icebergs already in view count as visited; with limited
 * endurance the UAV flies home when the rest is too far. Aimed legs are flown to their ends
 * (`aimedPaths`), then the icebergs left are flown to straight. With `home` the path ends with a
 * straight line home. An iceberg that the UAV cannot catch up with ends the path. The scene is that
 * of `presentScene`, without errors; times of legs count from its start. Returns the path with
 * times in seconds since that start.
 */
[[nodiscard]] FlyablePath flyOrder(const Scenario& scene, const UavPlan& plan, bool home);

} // namespace berg
