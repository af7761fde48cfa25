#include "core/base/nice_ticks.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace berg {
namespace {

constexpr std::array<double, 17> kTimeSteps_s = {
    1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 21600, 43200, 86400};

/** Returns the smallest round step at or above `value` > 0. */
double roundUp(double value)
{
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double leading : {1.0, 2.0, 2.5, 5.0})
        if (value <= leading * decade * (1 + 1e-12))
            return leading * decade;
    return 10 * decade;
}

} // namespace

int NiceTicks::decimals() const
{
    int decimals = 0;
    for (double s = step; decimals < 9 && std::abs(s - std::round(s)) > 1e-6 * s; s *= 10)
        ++decimals;
    return decimals;
}

NiceTicks niceTicks(double largest, int most)
{
    if (!(largest > 0))
        return {.step = 1, .count = 1};
    const double step = roundUp(largest / most);
    return {.step = step, .count = std::max(1, static_cast<int>(std::ceil(largest / step - 1e-9)))};
}

NiceTicks niceTicksAround(double lowest, double highest, int most)
{
    if (!(lowest < 0))
        return niceTicks(highest, most);
    const double top = std::max(0.0, highest);
    const int least = top > 0 ? 2 : 1;
    const auto steps = [](double extent, double step) {
        return static_cast<int>(std::ceil(extent / step - 1e-9));
    };
    NiceTicks ticks{.step = roundUp((top - lowest) / std::max(most, least))};
    // 0 must be a tick, which may take one step more than the range.
    while (steps(-lowest, ticks.step) + steps(top, ticks.step) > std::max(most, least))
        ticks.step = roundUp(1.01 * ticks.step);
    ticks.below = steps(-lowest, ticks.step);
    ticks.count = steps(top, ticks.step);
    return ticks;
}

NiceTicks niceTicksExactly(double largest, int count)
{
    return {.step = largest > 0 ? roundUp(largest / count) : 1, .count = count};
}

NiceRange niceRange(double least, double largest, int most)
{
    // A single value has no extent; a tenth of the value puts it in the middle.
    const double extent =
        largest > least ? largest - least : std::max(0.1 * std::abs(largest), 1e-3);
    const double low = largest > least ? least : least - extent / 2;
    const double high = largest > least ? largest : largest + extent / 2;
    // Round ends may need one more step than the extent, so smaller counts are tried until they
    // fit.
    for (int wanted = most;; --wanted) {
        const double step = niceTicks(extent, std::max(1, wanted)).step;
        const double first = std::floor(low / step + 1e-9) * step;
        const int count = std::max(1, static_cast<int>(std::ceil((high - first) / step - 1e-9)));
        if (count <= most + 1 || wanted <= 1)
            return {.first = first, .step = step, .count = count};
    }
}

double timeStep_s(double duration_s, int most)
{
    for (const double step_s : kTimeSteps_s)
        if (duration_s <= step_s * most)
            return step_s;
    return 86400 * std::ceil(duration_s / 86400 / most);
}

} // namespace berg
