#pragma once

#include "core/vehicle/los_guidance.h"

#include <optional>

namespace berg {

/** How long a sortie may take, and where it ends. */
struct SortieSpec
{
    double endurance_s = 0;
    double turnaround_s = 0; ///< on the ground before the next one
    Point home_m = Point::Zero();
};

/** Landed where the track passes home at this distance or less. */
inline constexpr double kLandingRadius_m = 25;
/** Endurance kept for what `pathTo` leaves out: rounding to time steps, the approach itself. */
inline constexpr double kHomeReserve_s = 10;
/** Kept besides for each visit promised: line-of-sight guidance turns later than `pathTo` has it.
 */
inline constexpr double kVisitReserve_s = 10;

/** A place that moves with a constant velocity over ground. */
struct MovingPlace
{
    Point place_m = Point::Zero();
    Point drift_mps = Point::Zero();
};

/** A way to a place: a turn at the limit, then straight on. */
struct Path
{
    double turn_rad = 0; ///< left positive, three full circles at most
    double time_s = 0;
    DubinsState end; ///< over the place, at that time
};

/**
 * The quicker one of the ways with a turn to the left and to the right, in constant wind, for an
 * autopilot with so much time between two commands: the turn takes whole commands, the last one at
 * a lower rate. None when the place may outrun the UAV (relative wind not below the airspeed).
 *
 * Flying the turn's rate and asking again at each command never takes longer: the rest of a way is
 * a way. That there is one: over three circles one of the two turns comes round to the bearing of
 * the place, which cannot be inside both circles at once.
 */
[[nodiscard]] std::optional<Path> pathTo(const DubinsState& start, const MovingPlace& place,
                                         const Motion& motion, double command_s);

/** An upper bound of `pathTo(...).time_s` to a place that stands still; much quicker to compute. */
[[nodiscard]] double longestPath_s(const DubinsState& start, const Point& place_m,
                                   const Motion& motion, double command_s);

/** Turn rate to begin the way with: of the next command. */
[[nodiscard]] double turnRateOf(const Path& path, const Motion& motion, double command_s);

} // namespace berg
