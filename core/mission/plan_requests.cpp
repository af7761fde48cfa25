#include "core/mission/plan_requests.h"

#include "core/sim/clusters.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

/**
 * Returns the matrix of distances between UAV and places in the unit of a request: flight time
 * times the airspeed of the first UAV.
 */
Eigen::MatrixXd distances_m(const Simulation& simulation, int uav, std::span<const Point> places_m)
{
    const Autopilot& me = simulation.fleet().autopilot(uav);
    std::vector<Point> nodes_m{me.pose().position_m};
    nodes_m.insert(nodes_m.end(), places_m.begin(), places_m.end());
    return simulation.motion(0).airspeed_mps / me.motion().airspeed_mps *
           legLengths_m(me.guard().uav(), nodes_m);
}

/**
 * Probability that a place flown to is seen, by the samples on the path from the edge of the view
 * to its middle.
 */
double chanceSeen(const Autopilot& me, const ObserverSpec& observer)
{
    const double half_s = surelySeen_m(me.sensor()) / me.motion().airspeed_mps;
    const double samples = half_s / observer.interval_s;
    return samples < 1 ? samples * observer.detection
                       : 1 - std::pow(1 - observer.detection, samples);
}

/**
 * Returns the likely places of a lost iceberg for the plan to search; empty if the UAV may not
 * search for it.
 */
std::vector<SearchPlace> placesOf(const Simulation& simulation, int uav, IcebergIndex iceberg)
{
    constexpr std::size_t kMost = 4;
    /** Half the spacing of places as a share of the smaller extent of the view. */
    constexpr double kHalf = 0.45;
    const Fleet& fleet = simulation.fleet();
    const Search* search = fleet.observer().searches().ofIceberg(iceberg);
    if (search == nullptr || !fleet.searchesByPlan() || !fleet.maySearch(uav, iceberg))
        return {};
    const Autopilot& me = fleet.autopilot(uav);
    double view_m = 2 * surelySeen_m(me.sensor());
    double seen = 1;
    // All UAVs get the same places, so they suit the weakest camera.
    for (const Autopilot& other : fleet.autopilots()) {
        view_m = std::min(view_m, 2 * surelySeen_m(other.sensor()));
        seen = std::min(seen, chanceSeen(other, simulation.world().observer()));
    }
    std::vector<SearchPlace> places = search->path.likeliestPlaces(kHalf * view_m, kMost);
    for (SearchPlace& place : places)
        place.chance *= seen;
    return places;
}

UavRequest uavRequest(const Simulation& simulation, int uav, const IcebergList& ids)
{
    const World& world = simulation.world();
    const Observer& observer = simulation.observer();
    const Autopilot& me = simulation.fleet().autopilot(uav);
    PredictionInput prediction{.time_s = world.time_s(),
                               .until_s = static_cast<double>(world.lastStep()) * world.dt_s(),
                               .uav = me.pose(),
                               .motion = me.motion(),
                               .wind = simulation.windAhead(),
                               .sensor = me.sensor(),
                               .reachRadius_m = observer.cameras().reachRadius_m(),
                               .observer = world.observer(),
                               .seed = world.seed(),
                               .step = world.step()};
    if (const std::optional<SortieSpec>& sortie = me.guard().uav().sortie) {
        const double runEnd_s = prediction.until_s;
        prediction.until_s = std::min(runEnd_s, prediction.time_s + me.guard().slotLeft_s());
        if (prediction.until_s < runEnd_s)
            prediction.laterSorties = {.spec = *sortie, .runEnd_s = runEnd_s};
    }
    UavRequest request{.uav = uav};
    std::vector<Point> places_m;
    for (const IcebergIndex i : ids) {
        request.available.push_back(
            simulation.available(uav, i) &&
            !simulation.trigger().isTargetOfUnplanned(i, simulation.fleet()));
        if (world.parameters(i).assignedUav == uav)
            request.assigned.push_back(i);
        places_m.push_back(observer.estimate_m(i));
        prediction.tracks.push_back(observer.track(i));
        prediction.weights.push_back(priority(observer, i));
        prediction.places.push_back(placesOf(simulation, uav, i));
    }
    request.prediction = std::make_shared<const PredictionInput>(std::move(prediction));
    request.distance_m = distances_m(simulation, uav, places_m);
    return request;
}

/** A group of icebergs planned as one point. */
struct Cluster
{
    IcebergList members;
    std::vector<bool> uavs; ///< by UAV of the request: whether it may visit the cluster
};

/** Replaces the nodes of each cluster by the node of its first member. */
PlanRequest withClusters(const Simulation& simulation, const PlanRequest& single,
                         const std::vector<Cluster>& clusters)
{
    const Observer& observer = simulation.observer();
    PlanRequest request = single;
    request.ids.clear();
    request.sigma_m2 = {0};
    for (UavRequest& uav : request.uavs)
        uav.available.clear();
    for (const Cluster& cluster : clusters)
        request.clusters.push_back(cluster.members);
    std::vector<Point> places_m;
    for (std::size_t k = 0; k < single.ids.size(); ++k) {
        const IcebergIndex id = single.ids[k];
        const double sigma_m2 = single.sigma_m2[k + 1];
        const auto found = std::ranges::find_if(clusters, [id](const Cluster& cluster) {
            return std::ranges::find(cluster.members, id) != cluster.members.end();
        });
        const bool isSingle = found == clusters.end();
        if (!isSingle && found->members.front() != id) {
            const auto leader = std::ranges::find(request.ids, found->members.front());
            request.sigma_m2[static_cast<std::size_t>(leader - request.ids.begin()) + 1] +=
                sigma_m2;
            continue;
        }
        request.ids.push_back(id);
        for (std::size_t uav = 0; uav < request.uavs.size(); ++uav)
            request.uavs[uav].available.push_back(isSingle ? single.uavs[uav].available[k]
                                                           : found->uavs[uav]);
        request.sigma_m2.push_back(sigma_m2);
        places_m.push_back(isSingle ? observer.estimate_m(id) : middle_m(observer, found->members));
    }
    for (UavRequest& uav : request.uavs)
        uav.distance_m = distances_m(simulation, uav.uav, places_m);
    return request;
}

/** Returns the rules by which a UAV of the request may visit clusters of `candidates`. */
ClusterRules clusterRules(const Simulation& simulation, const PlanRequest& single,
                          std::size_t place, std::span<const int> candidates)
{
    const UavRequest& asked = single.uavs[place];
    const Autopilot& me = simulation.fleet().autopilot(asked.uav);
    const double seen_m = surelySeen_m(me.sensor());
    const std::optional<double>& reach_m = simulation.observer().cameras().reachRadius_m();
    ClusterRules rules{.time_s = simulation.time_s(),
                       .uav = me.pose(),
                       .motion = me.motion(),
                       .cover_m = std::min(seen_m, reach_m.value_or(seen_m)),
                       .fence = me.guard().uav().fence};
    for (const int k : candidates)
        rules.visitable.push_back(
            asked.available[toIndex(k)] &&
            simulation.fleet().clusterable(asked.uav, single.ids[toIndex(k)]));
    return rules;
}

/**
 * Returns true if the UAV can visit all members in this sortie; otherwise they stay single nodes.
 */
bool isOfThisSortie(const Simulation& simulation, int uav, std::span<const IcebergIndex> members)
{
    const std::optional<int> visits =
        thisSortie(simulation.fleet().autopilot(uav), members, simulation.observer());
    return !visits || *visits == static_cast<int>(members.size());
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
    for (const IcebergIndex i : simulation.icebergs()) {
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
    request.betweenUavs_m = legLengths_m(fleet.autopilot(0).guard().uav(), starts_m);
    return request;
}

PlanRequest clusteredRequest(const Simulation& simulation)
{
    PlanRequest single = planRequest(simulation);
    const Fleet& fleet = simulation.fleet();
    if (!fleet.plansClusters())
        return single;
    std::vector<int> candidates; // indices into `single.ids`
    std::vector<Track> tracks;
    for (std::size_t k = 0; k < single.ids.size(); ++k) {
        const auto isFor = [&](const UavRequest& uav) {
            return uav.available[k] && fleet.clusterable(uav.uav, single.ids[k]);
        };
        if (!std::ranges::any_of(single.uavs, isFor))
            continue;
        candidates.push_back(static_cast<int>(k));
        tracks.push_back(simulation.track(single.ids[k]));
    }
    std::vector<ClusterRules> rules;
    for (std::size_t uav = 0; uav < single.uavs.size(); ++uav)
        rules.push_back(clusterRules(simulation, single, uav, candidates));
    std::vector<Cluster> clusters;
    for (const std::vector<int>& group : clustersOf(tracks, rules)) {
        Cluster cluster;
        for (const int member : group)
            cluster.members.push_back(single.ids[toIndex(candidates[toIndex(member)])]);
        for (std::size_t uav = 0; uav < rules.size(); ++uav)
            cluster.uavs.push_back(
                mayVisit(rules[uav], group) &&
                isOfThisSortie(simulation, single.uavs[uav].uav, cluster.members));
        if (std::ranges::find(cluster.uavs, true) != cluster.uavs.end())
            clusters.push_back(std::move(cluster));
    }
    return clusters.empty() ? single : withClusters(simulation, single, clusters);
}

PlanRequest requestFor(const Simulation& simulation, PolicyKind policy)
{
    return traitsOf(policy).plansClusters ? clusteredRequest(simulation) : planRequest(simulation);
}

} // namespace berg
