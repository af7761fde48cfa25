// What planners are asked: the part of `Simulation` that makes problems of what is known.

#include "core/sim/clusters.h"
#include "core/sim/simulation.h"
#include "core/vehicle/geofence.h"

#include <algorithm>

namespace berg {

PlanRequest requestFor(const Simulation& simulation, PolicyKind policy)
{
    return traitsOf(policy).plansClusters ? simulation.clusteredRequest()
                                          : simulation.planRequest();
}

PlanRequest Simulation::planRequest() const
{
    std::vector<int> uavs = plannedUavs();
    if (uavs.empty())
        uavs = {0};
    PlanRequest request{.sigma_m2 = {0}, .speed_mps = motion(0).airspeed_mps};
    for (int i = 0; i < icebergCount(); ++i) {
        if (!active(i))
            continue;
        request.ids.push_back(i);
        request.sigma_m2.push_back(priority(i) * track(i).sigma_m2);
    }
    std::vector<Point> starts_m;
    for (const int uav : uavs) {
        request.uavs.push_back(uavRequest(uav, request.ids));
        starts_m.push_back(this->uav(uav).pose.position_m);
    }
    if (uavs.size() > 1)
        request.betweenUavs_m = legLengths_m(0, starts_m);
    return request;
}

UavRequest Simulation::uavRequest(int uav, const std::vector<int>& ids) const
{
    const UavState& me = m_state.uavs[index(uav)];
    const Craft& craft = m_crafts[index(uav)];
    FlightPicture picture{.time_s = time_s(),
                          .until_s = static_cast<double>(m_lastStep) * m_dt_s,
                          .uav = me.pose,
                          .motion = craft.motion,
                          .sensor = craft.sensor,
                          .seed = m_seed,
                          .step = m_state.step};
    if (craft.sortie)
        picture.until_s = std::min(picture.until_s, picture.time_s + enduranceLeft_s(uav));
    UavRequest request{.uav = uav};
    std::vector<Point> nodes_m{me.pose.position_m};
    for (const int i : ids) {
        request.available.push_back(available(uav, i) && !isTargetOfUnplanned(i));
        nodes_m.push_back(estimate_m(i));
        picture.tracks.push_back(track(i));
        picture.weights.push_back(priority(i));
    }
    request.picture = std::make_shared<const FlightPicture>(std::move(picture));
    request.distance_m = nodeDistances_m(uav, nodes_m);
    return request;
}

/** In the unit of a request: flight time times the speed of the first UAV. */
Eigen::MatrixXd Simulation::nodeDistances_m(int uav, std::span<const Point> places_m) const
{
    return motion(0).airspeed_mps / motion(uav).airspeed_mps * legLengths_m(uav, places_m);
}

/** Of the legs between places: over ground, or through the air in wind. */
Eigen::MatrixXd Simulation::legLengths_m(int uav, std::span<const Point> places_m) const
{
    const Craft& craft = m_crafts[index(uav)];
    if (craft.fence)
        return craft.fence->distances_m(places_m);
    const auto n = static_cast<Eigen::Index>(places_m.size());
    Eigen::MatrixXd lengths_m(n, n);
    const bool calm = craft.motion.wind_mps.isZero(0);
    for (Eigen::Index j = 0; j < n; ++j)
        for (Eigen::Index i = 0; i < n; ++i) {
            const Point leg_m =
                places_m[static_cast<std::size_t>(j)] - places_m[static_cast<std::size_t>(i)];
            // Air distance U t_ij: what a leg costs when the wind helps or hinders.
            lengths_m(i, j) =
                calm ? leg_m.norm()
                     : craft.motion.airspeed_mps *
                           flightTime_s(leg_m, craft.motion.airspeed_mps, craft.motion.wind_mps);
        }
    return lengths_m;
}

PlanRequest Simulation::clusteredRequest() const
{
    PlanRequest single = planRequest();
    if (!m_clusters)
        return single;
    const Craft& craft = m_crafts.front(); // clusters are planned for one UAV only
    std::vector<int> candidates;
    std::vector<Track> tracks;
    for (const int id : single.ids)
        if (clusterable(id)) {
            candidates.push_back(id);
            tracks.push_back(track(id));
        }
    std::vector<std::vector<int>> clusters = clustersOf(
        tracks, {.time_s = time_s(),
                 .uav = uav(0).pose,
                 .motion = craft.motion,
                 .cover_m = std::min(surelySeen_m(craft.sensor),
                                     m_reachRadius_m.value_or(surelySeen_m(craft.sensor))),
                 .fence = craft.fence});
    for (std::vector<int>& members : clusters)
        for (int& member : members)
            member = candidates[index(member)];
    // What cannot be flown to whole in this sortie is left to single visits.
    std::erase_if(clusters, [this](const std::vector<int>& members) {
        const std::optional<int> visits = thisSortie(0, members);
        return visits && *visits < static_cast<int>(members.size());
    });
    return clusters.empty() ? single : withClusters(std::move(single), std::move(clusters));
}

/** The request with the nodes of each cluster made one, that of its first member. */
PlanRequest Simulation::withClusters(PlanRequest single,
                                     std::vector<std::vector<int>> clusters) const
{
    PlanRequest request = single;
    request.ids.clear();
    request.uavs.front().available.clear();
    request.sigma_m2 = {0};
    std::vector<Point> nodes_m{uav(0).pose.position_m};
    for (std::size_t k = 0; k < single.ids.size(); ++k) {
        const int id = single.ids[k];
        const double sigma_m2 = single.sigma_m2[k + 1];
        const std::span<const int> members = clusterWith(clusters, id);
        if (!members.empty() && members.front() != id) {
            const auto leader = std::ranges::find(request.ids, members.front());
            request.sigma_m2[index(static_cast<int>(leader - request.ids.begin())) + 1] += sigma_m2;
            continue;
        }
        request.ids.push_back(id);
        request.uavs.front().available.push_back(single.uavs.front().available[k]);
        request.sigma_m2.push_back(sigma_m2);
        nodes_m.push_back(members.empty() ? estimate_m(id) : middleOf_m(members));
    }
    request.uavs.front().distance_m = legLengths_m(0, nodes_m);
    request.clusters = std::move(clusters);
    return request;
}

} // namespace berg
