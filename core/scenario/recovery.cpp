#include "core/scenario/recovery.h"

#include "core/scenario/fence.h"
#include "core/scenario/limits.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace berg {

std::vector<int> padMates(const Scenario& scenario, std::size_t uav)
{
    std::vector<int> mates;
    const Uav& me = scenario.uavs[uav];
    const std::optional<SortieSpec> mine = sortieOf(me);
    for (std::size_t other = 0; other < scenario.uavs.size() && mine; ++other) {
        const Uav& them = scenario.uavs[other];
        const std::optional<SortieSpec> theirs = sortieOf(them);
        if (other != uav && theirs &&
            std::abs(them.spec.altitude_m - me.spec.altitude_m) < kLayerHeight_m &&
            (theirs->home_m - mine->home_m).norm() < scenario.separation_m)
            mates.push_back(static_cast<int>(other));
    }
    return mates;
}

double withheldFor_s(double usable_s, std::vector<double> taken_s)
{
    double arrival_s = usable_s - kRecoverySlot_s;
    std::ranges::sort(taken_s, std::greater());
    for (const double time_s : taken_s)
        if (std::abs(arrival_s - time_s) < kRecoverySlot_s)
            arrival_s = time_s - kRecoverySlot_s;
    return usable_s - std::max(arrival_s, usable_s / 2);
}

std::vector<double> withheldAtStart_s(const Scenario& scenario)
{
    std::vector<std::size_t> longestFirst(scenario.uavs.size());
    std::iota(longestFirst.begin(), longestFirst.end(), std::size_t{0});
    const auto usable_s = [&](std::size_t uav) {
        return usableEndurance_s(scenario.uavs[uav].spec);
    };
    std::ranges::stable_sort(longestFirst, std::greater(), usable_s);
    std::vector<double> withheld_s(scenario.uavs.size());
    for (const std::size_t uav : longestFirst) {
        const std::vector<int> mates = padMates(scenario, uav);
        std::vector<double> taken_s;
        for (const int mate : mates)
            if (const auto other = static_cast<std::size_t>(mate); withheld_s[other] > 0)
                taken_s.push_back(usable_s(other) - withheld_s[other]);
        if (!mates.empty())
            withheld_s[uav] = withheldFor_s(usable_s(uav), std::move(taken_s));
    }
    return withheld_s;
}

std::optional<double> slotOfSortie_s(const Scenario& scenario, std::size_t uav, double withheld_s)
{
    if (padMates(scenario, uav).empty())
        return std::nullopt;
    return usableEndurance_s(scenario.uavs[uav].spec) - withheld_s;
}

} // namespace berg
