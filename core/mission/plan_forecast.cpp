#include "core/mission/plan_forecast.h"

#include "core/sim/clusters.h"
#include "core/sim/drift_ahead.h"
#include "core/sim/leg_flight.h"

#include <algorithm>

namespace berg {

namespace {

/** Growth of one sigma between two sightings. */
struct Growth
{
    Track track; ///< with the variances at `since_s`
    double since_s = 0;

    [[nodiscard]] double sigmaAt_m2(double time_s) const
    {
        return track.sigmaAfter_m2(time_s - since_s);
    }
    /** Integral of sigma from `since_s` to `time_s`. */
    [[nodiscard]] double areaUntil_m2s(double time_s) const
    {
        return positionIntegral_m2s(track.variances(), track.process(), time_s - since_s);
    }
    /** Applies an exact instantaneous sighting, which also improves the velocity. */
    void seeAt(double time_s)
    {
        track.grow(time_s - since_s);
        since_s = time_s;
        track.measured(track.anchor_m, 0, track.anchor_s);
        track.mixed_m2ps = 0;
        track.sigma_m2 = 0;
    }
};

/** Returns the first icebergs of the order that are seen from one point. */
std::span<const IcebergIndex> seenTogether(std::span<const IcebergIndex> order,
                                           std::span<const IcebergList> clusters)
{
    const std::span<const IcebergIndex> members = clusterWith(clusters, order.front());
    std::size_t count = 1;
    while (count < order.size() && std::ranges::find(members, order[count]) != members.end())
        ++count;
    return order.first(count);
}

/** Flies to the point from which they are seen; returns the distance of the farthest from it. */
double flyTo(std::span<const IcebergIndex> icebergs, const ForecastStart& start, LegFlight& flight)
{
    for (const IcebergIndex iceberg : icebergs)
        require(iceberg >= 0 && toIndex(iceberg) < start.world.tracks.size(),
                "order names an iceberg that is not there");
    std::vector<DriftAhead> places;
    for (const IcebergIndex iceberg : icebergs)
        places.emplace_back(start.world.tracks[toIndex(iceberg)],
                            start.forcings.empty() ? nullptr : start.forcings[toIndex(iceberg)],
                            start.time_s);
    if (icebergs.size() == 1) {
        flight.flyTo(places.front(), start.time_s);
        return 0;
    }
    const auto circleAt = [&](double after_s) {
        return circleRound(icebergs, [&](IcebergIndex i) {
            const auto k = std::ranges::find(icebergs, i) - icebergs.begin();
            return places[static_cast<std::size_t>(k)].at_m(after_s);
        });
    };
    return flight.flyTo(circleAt).radius_m;
}

bool startsWith(std::span<const IcebergIndex> order, std::span<const IcebergIndex> beginning)
{
    return std::mismatch(beginning.begin(), beginning.end(), order.begin(), order.end()).first ==
           beginning.end();
}

struct FlownRoute
{
    RouteForecast route;
    LegFlight flight; ///< at the end of the route
};

/** Predicts the visits of one UAV and their times, without sigmas. */
FlownRoute flyRoute(const ForecastStart& start, std::size_t uav,
                    std::span<const IcebergIndex> order, std::span<const IcebergList> clusters)
{
    FlownRoute flown{
        {},
        {start.world.uavs.at(uav).pose.position_m, start.airspeeds_mps.at(uav), start.wind_mps}};
    while (!order.empty()) {
        const std::span<const IcebergIndex> together = seenTogether(order, clusters);
        order = order.subspan(together.size());
        const Point from_m = flown.flight.position_m();
        const double spread_m = flyTo(together, start, flown.flight);
        const double leg_m = (flown.flight.position_m() - from_m).norm();
        flown.route.distance_m += leg_m;
        for (const IcebergIndex iceberg : together)
            flown.route.visits.push_back({.iceberg = iceberg,
                                          .place_m = flown.flight.position_m(),
                                          .leg_m = iceberg == together.front() ? leg_m : 0,
                                          .arrival_s = flown.flight.time_s(),
                                          .spread_m = spread_m});
    }
    return flown;
}

/** Returns all visits by time; those of one UAV stay in its order. */
std::vector<ForecastVisit*> inOrderOfTime(std::vector<RouteForecast>& routes)
{
    std::vector<ForecastVisit*> visits;
    for (RouteForecast& route : routes)
        for (ForecastVisit& visit : route.visits)
            visits.push_back(&visit);
    std::ranges::stable_sort(visits, {}, &ForecastVisit::arrival_s);
    return visits;
}

bool isIn(const OrdersByUav& orders, IcebergIndex iceberg)
{
    return std::ranges::any_of(orders, [iceberg](const IcebergList& order) {
        return std::ranges::find(order, iceberg) != order.end();
    });
}

/** Appends to each order the icebergs that only `others` visit, for the same UAV. */
OrdersByUav withVisitsOf(OrdersByUav orders, const OrdersByUav& others)
{
    const OrdersByUav own = orders;
    for (std::size_t uav = 0; uav < others.size(); ++uav)
        for (const IcebergIndex iceberg : others[uav])
            if (!isIn(own, iceberg))
                orders[uav].push_back(iceberg);
    return orders;
}

} // namespace

LegFlight flyAhead(const ForecastStart& start, std::size_t uav, std::span<const IcebergIndex> order,
                   std::span<const IcebergList> clusters)
{
    return flyRoute(start, uav, order, clusters).flight;
}

PlanForecast forecastPlan(const ForecastStart& start, const OrdersByUav& orders, double horizon_s,
                          std::span<const IcebergList> clusters)
{
    const std::vector<Track>& tracks = start.world.tracks;
    require(start.active.size() == tracks.size(), "forecastPlan: one flag for each iceberg");
    std::vector<Growth> growths;
    for (const Track& track : tracks)
        growths.push_back({.track = track});

    PlanForecast forecast;
    for (std::size_t uav = 0; uav < orders.size(); ++uav)
        forecast.uavs.push_back(flyRoute(start, uav, orders[uav], clusters).route);
    for (ForecastVisit* visit : inOrderOfTime(forecast.uavs)) {
        Growth& growth = growths[toIndex(visit->iceberg)];
        visit->arrivalSigma_m2 = growth.sigmaAt_m2(visit->arrival_s);
        if (visit->arrival_s > horizon_s)
            continue;
        forecast.zeta_m2s += growth.areaUntil_m2s(visit->arrival_s);
        growth.seeAt(visit->arrival_s);
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
