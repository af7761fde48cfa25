#pragma once

#include "core/vehicle/los_guidance.h"

#include <optional>

namespace berg {

/** Duration limit of a sortie, and the place it returns to. */
struct SortieSpec
{
    double endurance_s = 0;
    double turnaround_s = 0; ///< time on the ground before the next sortie
    Point home_m = Point::Zero();
};

/** A returning UAV has landed when its track passes home within this distance. */
inline constexpr double kLandingRadius_m = 25;
/** Endurance kept for what `pathTo` leaves out: rounding to time steps, and the approach. */
inline constexpr double kHomeReserve_s = 10;
/**
 * Endurance kept once in addition when the visits before the return are counted
 * (`SafetyGuard::visitsInTime`), because line-of-sight guidance turns later than `pathTo` predicts.
 */
inline constexpr double kVisitReserve_s = 10;

/** A place that moves with a constant velocity over ground. */
struct MovingPlace
{
    Point place_m = Point::Zero();
    Point drift_mps = Point::Zero();
};

/** A path to a place: a turn at the limit, then a straight line. */
struct Path
{
    double turn_rad = 0; ///< positive to the left, at most three full circles
    double time_s = 0;
    DubinsState end; ///< state over the place at the end of the path
};

/**
 * Returns the quicker of the two paths that begin with a turn to the left and to the right, in
 * constant wind, for an autopilot that gives a command every `command_s`: the turn takes whole
 * commands, the last of them at a lower rate. Returns nullopt if the place may outrun the UAV (the
 * wind relative to the place is not below the airspeed).
 *
 * Replanning at each command while flying the turn never takes longer, because the rest of a path
 * is a path. A path always exists: within three circles one of the two turns reaches the bearing of
 * the place, which cannot be inside both circles at once.
 */
[[nodiscard]] std::optional<Path> pathTo(const DubinsState& start, const MovingPlace& place,
                                         const Motion& motion, double command_s);

/**
 * Returns an upper bound, s, of the time of `pathTo` to a fixed place; much quicker to compute. The
 * wind must be below the airspeed.
 */
[[nodiscard]] double longestPath_s(const DubinsState& start, const Point& place_m,
                                   const Motion& motion, double command_s);

/**
 * Returns whether `pathTo` reaches a fixed place within `left_s`; quicker, because a bound or the
 * path of one side often answers. The wind must be below the airspeed.
 */
[[nodiscard]] bool reachesWithin(double left_s, const DubinsState& start, const Point& place_m,
                                 const Motion& motion, double command_s);

/** Returns the turn rate, rad/s and within the limit, of the next command on the path. */
[[nodiscard]] double turnRateOf(const Path& path, const Motion& motion, double command_s);

} // namespace berg
