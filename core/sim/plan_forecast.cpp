#include "core/sim/plan_forecast.h"

#include "core/base/enclosing_circle.h"
#include "core/sim/clusters.h"

#include <algorithm>

namespace berg {

namespace {

/** Growth of one sigma between two sightings. */
struct Growth
{
    double since_s = 0;
    double sigma_m2 = 0; ///< at `since_s`
    double q_m2ps = 0;

    [[nodiscard]] double sigmaAt_m2(double time_s) const
    {
        return sigma_m2 + q_m2ps * (time_s - since_s);
    }
    /** Integral of sigma until `time_s`. */
    [[nodiscard]] double areaUntil_m2s(double time_s) const
    {
        return (time_s - since_s) * (sigma_m2 + sigmaAt_m2(time_s)) / 2;
    }
};

/** The first ones of an order that are seen from one point. */
std::span<const int> seenTogether(std::span<const int> order,
                                  std::span<const std::vector<int>> clusters)
{
    const std::span<const int> members = clusterWith(clusters, order.front());
    std::size_t count = 1;
    while (count < order.size() && std::ranges::find(members, order[count]) != members.end())
        ++count;
    return order.first(count);
}

/** Where they are seen from. */
Point placeOf(std::span<const int> icebergs, const ForecastStart& start)
{
    std::vector<Point> estimates_m;
    for (const int iceberg : icebergs) {
        const auto i = static_cast<std::size_t>(iceberg);
        require(iceberg >= 0 && i < start.world.tracks.size(),
                "order names an iceberg that is not there");
        estimates_m.push_back(start.world.tracks[i].estimate_m(start.time_s));
    }
    return enclosingCircle(estimates_m).centre_m;
}

bool startsWith(std::span<const int> order, std::span<const int> beginning)
{
    return std::mismatch(beginning.begin(), beginning.end(), order.begin(), order.end()).first ==
           beginning.end();
}

/** The visits of one UAV and when they are; sigmas are another matter. */
RouteForecast routeOf(const ForecastStart& start, std::size_t uav, std::span<const int> order,
                      std::span<const std::vector<int>> clusters)
{
    RouteForecast route;
    Point from_m = start.world.uavs.at(uav).pose.position_m;
    double arrival_s = 0;
    while (!order.empty()) {
        const std::span<const int> together = seenTogether(order, clusters);
        order = order.subspan(together.size());
        const Point to_m = placeOf(together, start);
        const Point leg_m = to_m - from_m;
        arrival_s += flightTime_s(leg_m, start.airspeeds_mps.at(uav), start.wind_mps);
        route.distance_m += leg_m.norm();
        from_m = to_m;
        for (const int iceberg : together)
            route.visits.push_back({.iceberg = iceberg,
                                    .leg_m = iceberg == together.front() ? leg_m.norm() : 0,
                                    .arrival_s = arrival_s});
    }
    return route;
}

/** All visits in order of time, those of one UAV in its order. */
std::vector<ForecastVisit*> inOrderOfTime(std::vector<RouteForecast>& routes)
{
    std::vector<ForecastVisit*> visits;
    for (RouteForecast& route : routes)
        for (ForecastVisit& visit : route.visits)
            visits.push_back(&visit);
    std::ranges::stable_sort(visits, {}, &ForecastVisit::arrival_s);
    return visits;
}

bool isIn(const OrdersByUav& orders, int iceberg)
{
    return std::ranges::any_of(orders, [iceberg](const std::vector<int>& order) {
        return std::ranges::find(order, iceberg) != order.end();
    });
}

/** The orders, and at their ends what only `others` visit, with the same UAV. */
OrdersByUav withVisitsOf(OrdersByUav orders, const OrdersByUav& others)
{
    const OrdersByUav own = orders;
    for (std::size_t uav = 0; uav < others.size(); ++uav)
        for (const int iceberg : others[uav])
            if (!isIn(own, iceberg))
                orders[uav].push_back(iceberg);
    return orders;
}

} // namespace

PlanForecast forecastPlan(const ForecastStart& start, const OrdersByUav& orders, double horizon_s,
                          std::span<const std::vector<int>> clusters)
{
    const std::vector<Track>& tracks = start.world.tracks;
    require(start.active.size() == tracks.size(), "forecastPlan: one flag for each iceberg");
    std::vector<Growth> growths;
    for (const Track& track : tracks)
        growths.push_back({.sigma_m2 = track.sigma_m2, .q_m2ps = track.q_m2ps});

    PlanForecast forecast;
    for (std::size_t uav = 0; uav < orders.size(); ++uav)
        forecast.uavs.push_back(routeOf(start, uav, orders[uav], clusters));
    for (ForecastVisit* visit : inOrderOfTime(forecast.uavs)) {
        Growth& growth = growths[static_cast<std::size_t>(visit->iceberg)];
        visit->arrivalSigma_m2 = growth.sigmaAt_m2(visit->arrival_s);
        if (visit->arrival_s > horizon_s)
            continue;
        forecast.zeta_m2s += growth.areaUntil_m2s(visit->arrival_s);
        growth = {.since_s = visit->arrival_s, .sigma_m2 = 0, .q_m2ps = growth.q_m2ps};
    }
    for (std::size_t i = 0; i < growths.size(); ++i)
        if (start.active[i])
            forecast.zeta_m2s += growths[i].areaUntil_m2s(horizon_s);
    return forecast;
}

std::vector<std::optional<PlanChange>> planChanges(const ForecastStart& start,
                                                   const OrdersByUav& before,
                                                   const OrdersByUav& after, double horizon_s,
                                                   const ChangedClusters& clusters)
{
    std::vector<std::optional<PlanChange>> changes(after.size());
    const auto isChanged = [&](std::size_t uav) {
        return !before[uav].empty() && !startsWith(after[uav], before[uav]);
    };
    bool any = false;
    for (std::size_t uav = 0; uav < after.size(); ++uav)
        any = any || isChanged(uav);
    if (!any)
        return changes;
    const PlanForecast old =
        forecastPlan(start, withVisitsOf(before, after), horizon_s, clusters.before);
    const bool isFleet = after.size() > 1;
    const PlanForecast now = forecastPlan(start, isFleet ? withVisitsOf(after, before) : after,
                                          horizon_s, clusters.after);
    for (std::size_t uav = 0; uav < after.size(); ++uav)
        if (isChanged(uav))
            changes[uav] = {.before = before[uav],
                            .distance_m = now.uavs[uav].distance_m - old.uavs[uav].distance_m,
                            .zeta_m2s = now.zeta_m2s - old.zeta_m2s};
    return changes;
}

} // namespace berg
