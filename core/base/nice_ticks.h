#pragma once

namespace berg {

/** Ticks of an axis with `below` steps under 0 and `count` steps above it. */
struct NiceTicks
{
    double step = 1;
    int count = 1;
    int below = 0;
    [[nodiscard]] double end() const { return step * count; }
    [[nodiscard]] double start() const { return -step * below; }
    /** Returns the number of decimals needed to write the ticks. */
    [[nodiscard]] int decimals() const;
};

/**
 * Returns at most `most` >= 1 steps that cover [0, largest], each 1, 2, 2.5 or 5 times a power of
 * ten. Returns one step of 1 if `largest` is not above 0.
 */
[[nodiscard]] NiceTicks niceTicks(double largest, int most);

/**
 * Returns steps like those of `niceTicks` that cover [lowest, highest] and 0. `most` must be at
 * least 2 if the range has both signs.
 */
[[nodiscard]] NiceTicks niceTicksAround(double lowest, double highest, int most);

/** Returns exactly `count` steps that cover [0, largest], so that two axes share one grid. */
[[nodiscard]] NiceTicks niceTicksExactly(double largest, int count);

/** Round ticks around a range that need not contain 0, with `count` steps from `first` on. */
struct NiceRange
{
    double first = 0;
    double step = 1;
    int count = 1;
    /** Returns the position of the value on the axis, 0 at the start and 1 at the end. */
    [[nodiscard]] double share(double value) const { return (value - first) / (step * count); }
    [[nodiscard]] double at(int tick) const { return first + tick * step; }
    /** Returns the number of decimals needed to write the ticks. */
    [[nodiscard]] int decimals() const { return NiceTicks{.step = step}.decimals(); }
};

/**
 * Returns at most `most` + 1 steps that cover [least, largest]. A single value is in the middle.
 */
[[nodiscard]] NiceRange niceRange(double least, double largest, int most);

/**
 * Returns a step of a time axis in seconds that reads well (10 s, 1 min, 5 min, 1 h, ...), so that
 * at most `most` steps cover the duration.
 */
[[nodiscard]] double timeStep_s(double duration_s, int most);

} // namespace berg
