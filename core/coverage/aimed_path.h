#pragma once

#include "core/plan/problem/aimed_leg.h"
#include "core/vehicle/dubins.h"
#include "core/vehicle/los_guidance.h"

#include <optional>
#include <span>
#include <vector>

namespace berg {

/** A position over ground and the time at which the UAV is there. */
struct PathPoint
{
    Point position_m = Point::Zero();
    double time_s = 0;
};

/** Flight of a leg over ground. */
struct AimedPath
{
    /** Point at which the line passes its iceberg, or would pass it; nullopt for a hold. */
    std::optional<Point> aim_m;
    /** Points of the turn, then the end of the line; there is at least one. */
    std::vector<PathPoint> points;
};

/**
 * Returns the path of each leg, for legs that are flown one after the other from the UAV's state at
 * `time_s`. A leg ends where the next one begins, on its line or still in its turn, the last one at
 * its first sighting or the end of its hold. For a leg under way, pass the rest of its turn. The
 * flight stays within a few metres of the paths as long as the sightings are those predicted.
 */
[[nodiscard]] std::vector<AimedPath> aimedPaths(std::span<const AimedLeg> legs,
                                                const DubinsState& uav, double time_s,
                                                const Motion& motion);

/** Returns the length over ground, in metres, of the paths up to `time_s`. */
[[nodiscard]] double lengthUntil_m(std::span<const AimedPath> paths, double time_s);

} // namespace berg
