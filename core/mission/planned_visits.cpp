#include "core/mission/planned_visits.h"

#include <algorithm>

namespace berg {

std::vector<std::vector<double>> plannedVisits(std::span<const PlanPointer> plans,
                                               std::size_t icebergs, double now_s)
{
    std::vector<std::vector<double>> visits(icebergs);
    std::vector<const UavPlan*> own;
    for (std::size_t uav = 0; uav < plans.size(); ++uav)
        if (plans[uav])
            own.push_back(plans[uav]->of(static_cast<int>(uav)));
    if (std::ranges::all_of(own, [](const UavPlan* plan) { return plan->laterVisits.empty(); }))
        return visits;
    const auto add = [&](IcebergIndex iceberg, double time_s) {
        if (const std::size_t i = toIndex(iceberg); i < icebergs && time_s >= now_s)
            visits[i].push_back(time_s);
    };
    for (const UavPlan* plan : own) {
        if (plan->outlook)
            for (std::size_t k = 0;
                 k < std::min(plan->order.size(), plan->outlook->sightings_s.size()); ++k)
                add(plan->order[k], plan->outlook->sightings_s[k]);
        for (const PlannedVisit& visit : plan->laterVisits)
            add(visit.iceberg, visit.time_s);
    }
    for (std::vector<double>& times_s : visits)
        std::sort(times_s.begin(), times_s.end());
    return visits;
}

std::optional<RevisitGap> longestGap(std::span<const std::vector<double>> visits,
                                     std::span<const Track> tracks)
{
    std::optional<RevisitGap> longest;
    for (std::size_t i = 0; i < std::min(visits.size(), tracks.size()); ++i) {
        double before_s = tracks[i].seen_s;
        for (const double time_s : visits[i]) {
            if (!longest || time_s - before_s > longest->gap_s)
                longest = {.iceberg = IcebergIndex::of(i), .gap_s = time_s - before_s};
            before_s = time_s;
        }
    }
    return longest;
}

} // namespace berg
