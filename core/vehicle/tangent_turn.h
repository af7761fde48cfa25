#pragma once

#include "core/vehicle/dubins.h"

namespace berg {

/** Position and heading without angles, which are costly where millions of legs are predicted. */
struct Pose
{
    Point position_m = Point::Zero();
    Point ahead = Point(1, 0); ///< unit vector

    /** Returns the unit vector to the left. */
    [[nodiscard]] Point left() const { return {-ahead.y(), ahead.x()}; }
};

/** Returns the state as position and unit vector. */
[[nodiscard]] Pose poseOf(const DubinsState& state);

/** A straight line past a point, which a UAV has to turn onto. */
struct LinePast
{
    Point target_m = Point::Zero();
    double offset_m = 0; ///< distance of the target to the left of the line
};

/** A turn at the limit and the straight line that touches its end. */
struct TangentTurn
{
    double turn_rad = 0; ///< positive to the left, less than a full circle
    Pose end;            ///< start and course of the straight line
    double length_m = 0; ///< length of the line from there to abeam of the target
};

/**
 * Returns the turn of radius `radius_m` from `start`, in still air, onto a line past the target. It
 * turns to the side of the line if that takes less than half a circle, else to the side of the
 * shorter turn. If the target is so near that no line from the turning circles passes it at that
 * offset, the line passes it as far off as the circle allows.
 */
[[nodiscard]] TangentTurn turnOntoLine(const Pose& start, const LinePast& line, double radius_m);

/** Returns `v` rotated by the angle that has this cosine and sine. */
[[nodiscard]] inline Point rotated(const Point& v, double cosine, double sine)
{
    return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y()};
}

/**
 * Returns the end of a turn of that radius that ends with heading `ahead`; `side` is 1 for left, -1
 * for right.
 */
[[nodiscard]] inline Pose turnedTo(const Pose& start, const Point& ahead, double side,
                                   double radius_m)
{
    const Pose end{.position_m = start.position_m, .ahead = ahead};
    return {.position_m = start.position_m + side * radius_m * (start.left() - end.left()),
            .ahead = ahead};
}

} // namespace berg
