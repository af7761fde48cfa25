#include "core/vehicle/tangent_turn.h"

#include "core/base/angles.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

/** A turn this close to a full circle counts as no turn. */
constexpr double kNoTurn_rad = 1e-9;

struct TangentSide
{
    Point course = Point::Zero();
    double arc_rad = 0; ///< >= 0
    double length_m = 0;
    bool possible = false;
};

/** Computes the turn to the left (`side` 1) or right (-1). */
TangentSide turnTo(double side, const Pose& start, const LinePast& line, double radius_m)
{
    const Point toTarget_m = line.target_m - start.position_m - side * radius_m * start.left();
    const double squared_m2 = toTarget_m.squaredNorm();
    const double lateral_m = line.offset_m - side * radius_m;
    const double length_m2 = squared_m2 - lateral_m * lateral_m;
    TangentSide turn{.length_m = std::sqrt(std::max(0.0, length_m2)), .possible = length_m2 >= 0};
    // The course is the bearing of the target turned by -asin(lateral / distance).
    const double distance_m = turn.possible ? std::sqrt(squared_m2) : std::abs(lateral_m);
    turn.course = rotated(toTarget_m, turn.length_m / distance_m, -lateral_m / distance_m);
    turn.course.normalize();
    const double arc_rad =
        side * std::atan2(cross(start.ahead, turn.course), start.ahead.dot(turn.course));
    turn.arc_rad = arc_rad < -kNoTurn_rad ? arc_rad + 2 * kPi : std::max(0.0, arc_rad);
    return turn;
}

} // namespace

Pose poseOf(const DubinsState& state)
{
    return {.position_m = state.position_m,
            .ahead = Point(std::cos(state.psi_rad), std::sin(state.psi_rad))};
}

TangentTurn turnOntoLine(const Pose& start, const LinePast& line, double radius_m)
{
    const double lateral_m = start.left().dot(line.target_m - start.position_m) - line.offset_m;
    double side = lateral_m >= 0 ? 1 : -1;
    TangentSide turn = turnTo(side, start, line, radius_m);
    if (!turn.possible || turn.arc_rad >= kPi) {
        const TangentSide other = turnTo(-side, start, line, radius_m);
        if (other.possible && (!turn.possible || other.arc_rad < turn.arc_rad)) {
            turn = other;
            side = -side;
        }
    }
    return {.turn_rad = side * turn.arc_rad,
            .end = turnedTo(start, turn.course, side, radius_m),
            .length_m = turn.length_m};
}

} // namespace berg
