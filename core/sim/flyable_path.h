#pragma once

#include "core/sim/visits.h"

#include <vector>

namespace berg {

/** An order for one UAV, as planners give it. */
struct UavOrder
{
    std::vector<int> icebergs;              ///< indices in visiting order
    std::vector<std::vector<int>> clusters; ///< visited as one; all in `icebergs`, in sequence
    std::vector<AimedLeg> legs; ///< how it is flown to begin with; empty: straight to each
    std::vector<PlannedSearch> searches = {}; ///< for lost icebergs, on the legs
};

/** A way through an order with turns. */
struct FlyablePath
{
    std::vector<TrackPoint> track; ///< one a second, and its end
    std::vector<Visit> visits;     ///< when each is in view or in reach, and home
};

/**
 * Flies the order with the first UAV of the scene from its start, by the very simulation that flies
 * missions, without planning anew: to each iceberg that is not in view already, and with limited
 * endurance home when the rest is too far. `home`: at the end straight home. Icebergs that cannot
 * be caught up with end it. Legs with aims are flown to their ends (`aimedPaths`), and what they
 * leave is flown to straight. The scene is that of `presentScene`, times of legs
 * count from its start.
 */
[[nodiscard]] FlyablePath flyOrder(const Scenario& scene, const UavOrder& order, bool home);

} // namespace berg
