#pragma once

#include "core/io/export_content.h"

#include <vector>

namespace berg {

/** An order for one UAV, as planners give it. */
struct UavOrder
{
    std::vector<int> icebergs;              ///< indices in visiting order
    std::vector<std::vector<int>> clusters; ///< visited as one; all in `icebergs`, in sequence
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
 * be caught up with end it. Aims of coverage plans are not followed: it flies at each iceberg. The
 * scene is that of `presentScene`.
 */
[[nodiscard]] FlyablePath flyOrder(const Scenario& scene, const UavOrder& order, bool home);

} // namespace berg
