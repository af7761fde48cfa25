#pragma once

#include <algorithm>

namespace berg {

/** Time range of a chart, seconds. */
struct TimeWindow
{
    double from_s = 0;
    double to_s = 1;
    [[nodiscard]] double length_s() const { return to_s - from_s; }
    bool operator==(const TimeWindow&) const = default;
};

/** Smallest range that can be zoomed to. */
inline constexpr double kLeastWindow_s = 5;

/** Range moved by `by_s`, limited to [0, duration]. */
[[nodiscard]] inline TimeWindow shifted(const TimeWindow& window, double by_s, double duration_s)
{
    const double length_s = window.length_s();
    const double from_s =
        std::clamp(window.from_s + by_s, 0.0, std::max(0.0, duration_s - length_s));
    return {.from_s = from_s, .to_s = from_s + length_s};
}

/**
 * Range scaled by `factor` with `anchor_s` at an unchanged place; limited to [0, duration] and to
 * at least `kLeastWindow_s`.
 */
[[nodiscard]] inline TimeWindow zoomed(const TimeWindow& window, double factor, double anchor_s,
                                       double duration_s)
{
    const double length_s =
        std::min(std::max(window.length_s() * factor, kLeastWindow_s), duration_s);
    const double part = (anchor_s - window.from_s) / window.length_s();
    const double from_s = anchor_s - part * length_s;
    return shifted({.from_s = from_s, .to_s = from_s + length_s}, 0, duration_s);
}

} // namespace berg
