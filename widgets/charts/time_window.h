#pragma once

namespace berg {

/** The stretch of time a chart shows, seconds. */
struct TimeWindow
{
    double from_s = 0;
    double to_s = 1;
    [[nodiscard]] double length_s() const { return to_s - from_s; }
    bool operator==(const TimeWindow&) const = default;
};

/** Nothing shorter can be zoomed to. */
inline constexpr double kLeastWindow_s = 5;

/**
 * The window `factor` times as long that shows `anchor_s` where it was; within [0, duration] and
 * no shorter than `kLeastWindow_s`.
 */
[[nodiscard]] TimeWindow zoomed(const TimeWindow& window, double factor, double anchor_s,
                                double duration_s);

/** The window moved by `by_s` as far as [0, duration] lets it. */
[[nodiscard]] TimeWindow shifted(const TimeWindow& window, double by_s, double duration_s);

} // namespace berg
