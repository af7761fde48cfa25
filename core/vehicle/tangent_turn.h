#pragma once

#include "core/vehicle/dubins.h"

namespace berg {

/** Place and heading without angles, which are dear where millions of legs are predicted. */
struct Pose
{
    Point position_m = Point::Zero();
    Point ahead = Point(1, 0); ///< unit vector

    [[nodiscard]] Point left() const { return {-ahead.y(), ahead.x()}; }
};

[[nodiscard]] Pose poseOf(const DubinsState& state);

/** A straight line past a point, for a UAV that has to turn onto it. */
struct LinePast
{
    Point target_m = Point::Zero();
    double offset_m = 0; ///< the target is left of the line by so much
};

/** A turn at the limit and the straight line that touches its end. */
struct TangentTurn
{
    double turn_rad = 0; ///< left positive, less than a full circle
    Pose end;            ///< where the line starts, and its course
    double length_m = 0; ///< from there to abeam of the target
};

/**
 * The turn of that radius from `start`, in still air, onto a line past the target: to the side on
 * which the line lies when that takes less than half a circle, else to the side of the shorter
 * turn. A target so near that no line from the turning circles passes it at that offset is passed
 * as far off as the circle allows.
 */
[[nodiscard]] TangentTurn turnOntoLine(const Pose& start, const LinePast& line, double radius_m);

/** `v` turned by the angle of this cosine and sine. */
[[nodiscard]] inline Point rotated(const Point& v, double cosine, double sine)
{
    return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y()};
}

/** Where a turn on that radius that ends with heading `ahead` ends; `side` 1 left, -1 right. */
[[nodiscard]] inline Pose turnedTo(const Pose& start, const Point& ahead, double side,
                                   double radius_m)
{
    const Pose end{.position_m = start.position_m, .ahead = ahead};
    return {.position_m = start.position_m + side * radius_m * (start.left() - end.left()),
            .ahead = ahead};
}

} // namespace berg
