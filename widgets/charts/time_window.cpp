#include "widgets/charts/time_window.h"

#include <algorithm>

namespace berg {

TimeWindow zoomed(const TimeWindow& window, double factor, double anchor_s, double duration_s)
{
    const double length_s =
        std::min(std::max(window.length_s() * factor, kLeastWindow_s), duration_s);
    const double part = (anchor_s - window.from_s) / window.length_s();
    const double from_s = anchor_s - part * length_s;
    return shifted({.from_s = from_s, .to_s = from_s + length_s}, 0, duration_s);
}

TimeWindow shifted(const TimeWindow& window, double by_s, double duration_s)
{
    const double length_s = window.length_s();
    const double from_s =
        std::clamp(window.from_s + by_s, 0.0, std::max(0.0, duration_s - length_s));
    return {.from_s = from_s, .to_s = from_s + length_s};
}

} // namespace berg
