#pragma once

#include "core/plan/solve/aimed_leg.h"
#include "core/vehicle/dubins.h"
#include "core/vehicle/los_guidance.h"

#include <optional>
#include <span>
#include <vector>

namespace berg {

/** A place over ground and when the UAV is there. */
struct PathPoint
{
    Point position_m = Point::Zero();
    double time_s = 0;
};

/** How a leg is flown over ground. */
struct AimedPath
{
    std::optional<Point> aim_m;    ///< where the line passes its iceberg, or would; none: a hold
    std::vector<PathPoint> points; ///< the turn, sampled, then the end of the line; never empty
};

/**
 * The way along legs that follow each other, from the UAV as it is at `time_s`, one for each leg. A
 * leg ends where the next one begins, on its line or still in its turn, the last one at its first
 * sighting or the end of its hold. Of a leg under way give what is left of its turn. The flight
 * stays within a few metres of it as long as it meets what was predicted.
 */
[[nodiscard]] std::vector<AimedPath> aimedPaths(std::span<const AimedLeg> legs,
                                                const DubinsState& uav, double time_s,
                                                const Motion& motion);

/** Length over ground of what is flown of the ways until then. */
[[nodiscard]] double lengthUntil_m(std::span<const AimedPath> paths, double time_s);

} // namespace berg
