#include "widgets/flight/planned_sorties.h"

#include "core/scenario/recovery.h"

#include <algorithm>

namespace berg {
namespace {

PlannedPath pathOf(const MissionSnapshot& now, std::size_t uav, const RouteForecast& route)
{
    PlannedPath path{.places_m = {now.world.uavs[uav].pose.position_m},
                     .thisSortie = 1,
                     .aloft_s = now.world.uavs[uav].aloft_s,
                     .wind_mps = now.wind,
                     .fence = now.fences[uav]};
    for (const ForecastVisit& visit : route.visits)
        path.places_m.push_back(visit.place_m);
    const UavPlan& plan = *planOf(now, static_cast<int>(uav));
    path.thisSortie +=
        static_cast<std::size_t>(plan.thisSortie.value_or(static_cast<int>(route.visits.size())));
    return path;
}

} // namespace

std::vector<std::optional<PlannedPath>> plannedPaths(const MissionSnapshot& now,
                                                     const Scenario& scenario)
{
    std::vector<std::optional<PlannedPath>> paths(scenario.uavs.size());
    // Until it is planned, a newly edited scenario may have other UAVs than the mission.
    const std::size_t uavs = std::min(scenario.uavs.size(), now.world.uavs.size());
    if (uavs == 0 || !now.plan || now.plan->uavs.front().outlook)
        return paths;
    const PlanForecast forecast =
        forecastPlan(forecastStart(now), ordersOf(now), 0, now.plan->uavs.front().clusters);
    for (std::size_t uav = 0; uav < uavs; ++uav) {
        const UavPlan* plan = planOf(now, static_cast<int>(uav));
        if (plan != nullptr && plan->legs.empty() && now.world.uavs[uav].isPlanned())
            paths[uav] = pathOf(now, uav, forecast.uavs[uav]);
    }
    return paths;
}

std::vector<std::optional<PlannedSortie>> plannedSorties(const MissionSnapshot& now,
                                                         const Scenario& scenario)
{
    std::vector<std::optional<PlannedSortie>> sorties;
    const std::vector<std::optional<PlannedPath>> paths = plannedPaths(now, scenario);
    for (std::size_t uav = 0; uav < paths.size(); ++uav) {
        std::optional<PlannedSortie>& sortie = sorties.emplace_back();
        if (!paths[uav])
            continue;
        const Uav& own = scenario.uavs[uav];
        const UavState& state = now.world.uavs[uav];
        sortie = {.outlook = sortieOutlook(scenario, own, *paths[uav]),
                  .lowMargin_s = lowMargin_s(own, *paths[uav]),
                  .slot_s = slotOfSortie_s(scenario, uav, state.withheld_s),
                  .uav = own.name.empty() ? own.id : own.name};
        if (sortie->slot_s)
            *sortie->slot_s += now.time_s - state.aloft_s;
    }
    return sorties;
}

std::vector<PlannedSortie> landingOrder(const std::vector<std::optional<PlannedSortie>>& sorties)
{
    std::vector<PlannedSortie> landings;
    for (const std::optional<PlannedSortie>& sortie : sorties)
        if (sortie && sortie->slot_s)
            landings.push_back(*sortie);
    std::ranges::stable_sort(landings, {},
                             [](const PlannedSortie& landing) { return *landing.slot_s; });
    return landings;
}

} // namespace berg
