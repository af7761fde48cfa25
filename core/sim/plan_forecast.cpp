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

} // namespace

PlanForecast forecastPlan(const ForecastStart& start, std::span<const int> order, double horizon_s,
                          std::span<const std::vector<int>> clusters)
{
    const std::vector<Track>& tracks = start.world.tracks;
    require(start.active.size() == tracks.size(), "forecastPlan: one flag for each iceberg");
    std::vector<Growth> growths;
    for (const Track& track : tracks)
        growths.push_back({.sigma_m2 = track.sigma_m2, .q_m2ps = track.q_m2ps});

    PlanForecast forecast;
    Point from_m = start.world.uav.position_m;
    double arrival_s = 0;
    while (!order.empty()) {
        const std::span<const int> together = seenTogether(order, clusters);
        order = order.subspan(together.size());
        const Point to_m = placeOf(together, start);
        const Point leg_m = to_m - from_m;
        arrival_s += flightTime_s(leg_m, start.airspeed_mps, start.wind_mps);
        forecast.distance_m += leg_m.norm();
        from_m = to_m;
        for (const int iceberg : together) {
            Growth& growth = growths[static_cast<std::size_t>(iceberg)];
            forecast.visits.push_back({.iceberg = iceberg,
                                       .leg_m = iceberg == together.front() ? leg_m.norm() : 0,
                                       .arrival_s = arrival_s,
                                       .arrivalSigma_m2 = growth.sigmaAt_m2(arrival_s)});
            if (arrival_s > horizon_s)
                continue;
            forecast.zeta_m2s += growth.areaUntil_m2s(arrival_s);
            growth = {.since_s = arrival_s, .sigma_m2 = 0, .q_m2ps = growth.q_m2ps};
        }
    }
    for (std::size_t i = 0; i < growths.size(); ++i)
        if (start.active[i])
            forecast.zeta_m2s += growths[i].areaUntil_m2s(horizon_s);
    return forecast;
}

std::optional<PlanChange> planChange(const ForecastStart& start, std::vector<int> before,
                                     std::span<const int> after, double horizon_s,
                                     const ChangedClusters& clusters)
{
    if (before.empty() || startsWith(after, before))
        return std::nullopt;
    std::vector<int> flown = before;
    for (const int iceberg : after)
        if (std::find(before.begin(), before.end(), iceberg) == before.end())
            flown.push_back(iceberg);
    const PlanForecast old = forecastPlan(start, flown, horizon_s, clusters.before);
    const PlanForecast now = forecastPlan(start, after, horizon_s, clusters.after);
    return PlanChange{.before = std::move(before),
                      .distance_m = now.distance_m - old.distance_m,
                      .zeta_m2s = now.zeta_m2s - old.zeta_m2s};
}

} // namespace berg
