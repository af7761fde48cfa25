#include "core/sim/plan_requests.h"

#include "core/sim/clusters.h"

#include <algorithm>

namespace berg {

namespace {

UavRequest uavRequest(const Simulation& simulation, int uav, const std::vector<int>& ids)
{
    const World& world = simulation.world();
    const Observer& observer = simulation.observer();
    const Autopilot& me = simulation.fleet().autopilot(uav);
    FlightPicture picture{.time_s = world.time_s(),
                          .until_s = static_cast<double>(world.lastStep()) * world.dt_s(),
                          .uav = me.pose(),
                          .motion = me.motion(),
                          .sensor = me.sensor(),
                          .observer = world.observer(),
                          .seed = world.seed(),
                          .step = world.step()};
    if (me.guard().uav().sortie)
        picture.until_s = std::min(picture.until_s, picture.time_s + me.guard().enduranceLeft_s());
    UavRequest request{.uav = uav};
    std::vector<Point> nodes_m{me.pose().position_m};
    for (const int i : ids) {
        request.available.push_back(
            simulation.available(uav, i) &&
            !simulation.trigger().isTargetOfUnplanned(i, simulation.fleet()));
        nodes_m.push_back(observer.estimate_m(i));
        picture.tracks.push_back(observer.track(i));
        picture.weights.push_back(priority(observer, i));
    }
    request.picture = std::make_shared<const FlightPicture>(std::move(picture));
    // In the unit of a request: flight time times the speed of the first UAV.
    request.distance_m = simulation.motion(0).airspeed_mps / me.motion().airspeed_mps *
                         legLengths_m(me.guard().uav(), nodes_m);
    return request;
}

/** The request with the nodes of each cluster made one, that of its first member. */
PlanRequest withClusters(const Simulation& simulation, const PlanRequest& single,
                         std::vector<std::vector<int>> clusters)
{
    const Observer& observer = simulation.observer();
    const Autopilot& me = simulation.fleet().autopilot(0);
    PlanRequest request = single;
    request.ids.clear();
    request.uavs.front().available.clear();
    request.sigma_m2 = {0};
    std::vector<Point> nodes_m{me.pose().position_m};
    for (std::size_t k = 0; k < single.ids.size(); ++k) {
        const int id = single.ids[k];
        const double sigma_m2 = single.sigma_m2[k + 1];
        const std::span<const int> members = clusterWith(clusters, id);
        if (!members.empty() && members.front() != id) {
            const auto leader = std::ranges::find(request.ids, members.front());
            request.sigma_m2[static_cast<std::size_t>(leader - request.ids.begin()) + 1] +=
                sigma_m2;
            continue;
        }
        request.ids.push_back(id);
        request.uavs.front().available.push_back(single.uavs.front().available[k]);
        request.sigma_m2.push_back(sigma_m2);
        nodes_m.push_back(members.empty() ? observer.estimate_m(id) : middle_m(observer, members));
    }
    request.uavs.front().distance_m = legLengths_m(me.guard().uav(), nodes_m);
    request.clusters = std::move(clusters);
    return request;
}

} // namespace

PlanRequest planRequest(const Simulation& simulation)
{
    const Observer& observer = simulation.observer();
    const Fleet& fleet = simulation.fleet();
    std::vector<int> uavs = simulation.trigger().plannedUavs(fleet);
    if (uavs.empty())
        uavs = {0};
    PlanRequest request{.sigma_m2 = {0}, .speed_mps = simulation.motion(0).airspeed_mps};
    for (int i = 0; i < simulation.icebergCount(); ++i) {
        if (!simulation.active(i))
            continue;
        request.ids.push_back(i);
        request.sigma_m2.push_back(priority(observer, i) * observer.track(i).sigma_m2);
    }
    std::vector<Point> starts_m;
    for (const int uav : uavs) {
        request.uavs.push_back(uavRequest(simulation, uav, request.ids));
        starts_m.push_back(fleet.autopilot(uav).pose().position_m);
    }
    if (uavs.size() > 1)
        request.betweenUavs_m = legLengths_m(fleet.autopilot(0).guard().uav(), starts_m);
    return request;
}

PlanRequest clusteredRequest(const Simulation& simulation)
{
    PlanRequest single = planRequest(simulation);
    const Fleet& fleet = simulation.fleet();
    if (!fleet.plansClusters())
        return single;
    const Autopilot& me = fleet.autopilot(0); // clusters are planned for one UAV only
    std::vector<int> candidates;
    std::vector<Track> tracks;
    for (const int id : single.ids)
        if (fleet.clusterable(id)) {
            candidates.push_back(id);
            tracks.push_back(simulation.track(id));
        }
    const double seen_m = surelySeen_m(me.sensor());
    const std::optional<double>& reach_m = simulation.observer().cameras().reachRadius_m();
    std::vector<std::vector<int>> clusters =
        clustersOf(tracks, {.time_s = simulation.time_s(),
                            .uav = me.pose(),
                            .motion = me.motion(),
                            .cover_m = std::min(seen_m, reach_m.value_or(seen_m)),
                            .fence = me.guard().uav().fence});
    for (std::vector<int>& members : clusters)
        for (int& member : members)
            member = candidates[toIndex(member)];
    // What cannot be flown to whole in this sortie is left to single visits.
    std::erase_if(clusters, [&](const std::vector<int>& members) {
        const std::optional<int> visits = thisSortie(me, members, simulation.observer());
        return visits && *visits < static_cast<int>(members.size());
    });
    return clusters.empty() ? single : withClusters(simulation, single, std::move(clusters));
}

PlanRequest requestFor(const Simulation& simulation, PolicyKind policy)
{
    return traitsOf(policy).plansClusters ? clusteredRequest(simulation) : planRequest(simulation);
}

} // namespace berg
