#pragma once

#include "core/base/random.h"
#include "core/scenario/scenario.h"

namespace berg {

/** Numbers from `low` to `high`. */
struct Span
{
    double low = 0;
    double high = 0;
};

/** What an iceberg is drawn from, each number uniform. */
struct FieldDraws
{
    Point low_m = Point::Zero(); ///< corners of a rectangle
    Point high_m = Point::Zero();
    Span speed_mps;
    Span direction_rad; ///< counter-clockwise from east
    Span sigma_m2;
    double q_m2ps = 0;
};

// The order of the draws, and the steps they are rounded to so that tables and files show short
// numbers, are part of the preset scenarios and must not change.

/** Two draws, in steps of 1 cm. */
[[nodiscard]] Point drawPosition(const FieldDraws& draws, Random& random);

/** An iceberg without an id at `position_m`: three draws, speed, direction and sigma. */
[[nodiscard]] Iceberg drawIceberg(const FieldDraws& draws, const Point& position_m, Random& random);

} // namespace berg
