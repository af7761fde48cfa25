#pragma once

#include "core/base/random.h"
#include "core/scenario/scenario.h"

namespace berg {

/** Range of numbers from `low` to `high`. */
struct Span
{
    double low = 0;
    double high = 0;
};

/** Distributions from which an iceberg is drawn; each number is uniform. */
struct FieldDraws
{
    Point low_m = Point::Zero(); ///< corner of the rectangle of positions
    /** Opposite corner. */
    Point high_m = Point::Zero();
    Span speed_mps;
    Span direction_rad; ///< counter-clockwise from east
    Span sigma_m2;
    double q_m2ps = 0;
};

// The preset scenarios depend on the order of the draws and on the steps to which they are rounded
// (so that tables and files show short numbers). Both must not change.

/** Draws a position with two random numbers, in steps of 1 cm. */
[[nodiscard]] Point drawPosition(const FieldDraws& draws, Random& random);

/**
 * Draws an iceberg without an id at `position_m` with three random numbers: speed, direction and
 * sigma.
 */
[[nodiscard]] Iceberg drawIceberg(const FieldDraws& draws, const Point& position_m, Random& random);

} // namespace berg
