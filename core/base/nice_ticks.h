#pragma once

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

/** Round ticks round a range that need not hold 0: `count` steps from `first` on. */
struct NiceRange
{
    double first = 0;
    double step = 1;
    int count = 1;
    [[nodiscard]] double share(double value) const { return (value - first) / (step * count); }
    [[nodiscard]] double at(int tick) const { return first + tick * step; }
    /** Decimals needed to write the ticks. */
    [[nodiscard]] int decimals() const { return NiceTicks{.step = step}.decimals(); }
};

/** At most one step more than `most` over [least, largest]; a single value is in the middle. */
[[nodiscard]] NiceRange niceRange(double least, double largest, int most);

/** Step of a time axis in seconds that people read well (10 s, 1 min, 5 min, 1 h, ...). */
[[nodiscard]] double timeStep_s(double duration_s, int most);

} // namespace berg
