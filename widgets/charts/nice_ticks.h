#pragma once

#include <vector>

namespace berg {

/** Ticks of an axis: `below` steps under 0 and `count` steps above it. */
struct NiceTicks
{
    double step = 1;
    int count = 1;
    int below = 0;
    [[nodiscard]] double end() const { return step * count; }
    [[nodiscard]] double start() const { return -step * below; }
    /** Decimals needed to write the ticks. */
    [[nodiscard]] int decimals() const;
};

/** Steps of 1, 2, 2.5 or 5 times a power of ten that cover [0, largest] in at most `most` steps. */
[[nodiscard]] NiceTicks niceTicks(double largest, int most);

/** As `niceTicks` for [lowest, highest] and 0; `most` >= 2 where the range has both signs. */
[[nodiscard]] NiceTicks niceTicksAround(double lowest, double highest, int most);

/** Exactly `count` steps, so that two axes share one grid. */
[[nodiscard]] NiceTicks niceTicksExactly(double largest, int count);

/** Step of a time axis in seconds that people read well (10 s, 1 min, 5 min, 1 h, ...). */
[[nodiscard]] double timeStep_s(double duration_s, int most);

} // namespace berg
