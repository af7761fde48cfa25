// What is seen, with measurements: the part of `Simulation` that filters, loses and finds icebergs.

#include "core/sim/clusters.h"
#include "core/sim/simulation.h"
#include "core/vehicle/geofence.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace berg {

namespace {

/** An iceberg whose estimate is in this middle part of the view should be seen. */
constexpr double kMiddleOfView = 0.5;
/** Before the first look in vain: all but what may be wrong with the filter. */
constexpr double kBelieved = 0.99;
/** Less likely in view than this after looks in vain: lost. */
constexpr double kLostBelow = 0.1;
/** A filter that starts again doubts the velocity it was given at least so much. */
constexpr double kFoundVelocitySd_mps = 0.1;

/** Whether no UAV that comes straight from there can fly over the place and stay inside. */
bool isFencedOff(const Geofence* fence, const Point& from_m, const Point& place_m)
{
    const Point leg_m = place_m - from_m;
    return fence != nullptr &&
           fence->room_m({.position_m = place_m, .psi_rad = std::atan2(leg_m.y(), leg_m.x())}) < 0;
}

SensorSpec middleOf(SensorSpec sensor)
{
    sensor.fov_m *= kMiddleOfView;
    return sensor;
}

/** Index of the first view with the place in it; -1: none. */
int firstWith(std::span<const FieldOfView> views, const Point& place_m)
{
    const auto it = std::ranges::find_if(
        views, [&](const FieldOfView& view) { return view.contains(place_m); });
    return it == views.end() ? -1 : static_cast<int>(it - views.begin());
}

} // namespace

void Simulation::observeFiltered(double now_s, double dt_s)
{
    for (std::size_t i = 0; i < m_state.tracks.size(); ++i) {
        Track& track = m_state.tracks[i];
        const std::int64_t age = m_state.step - m_appearsStep[i];
        if (age == 0)
            m_newlyAppeared.push_back(static_cast<int>(i));
        if (age <= 0)
            continue;
        const double before_m2 = track.sigma_m2;
        track.grow(dt_s);
        growSearches(i, track.sigma_m2 - before_m2);
    }
    if (m_state.step % m_lookSteps == 0)
        lookForMeasurements(now_s);
}

/** Of the iceberg, whoever searches or has given up. */
void Simulation::growSearches(std::size_t iceberg, double added_m2)
{
    for (UavState& uav : m_state.uavs)
        if (uav.search && index(uav.search->iceberg) == iceberg)
            uav.search->way.grow(added_m2);
    for (Search& search : m_state.givenUp)
        if (index(search.iceberg) == iceberg)
            search.way.grow(added_m2);
}

/** Without measurements, once a second: what is not in view although its estimate is in the middle
 * of one is lost, and looked for as with measurements. */
void Simulation::watchEstimates()
{
    std::vector<FieldOfView> views;
    std::vector<FieldOfView> middles;
    for (int uav = 0; uav < uavCount(); ++uav) {
        const DubinsState& pose = this->uav(uav).pose;
        views.push_back(fieldOfView(uav));
        middles.emplace_back(middleOf(m_crafts[index(uav)].sensor), pose.position_m, pose.psi_rad);
    }
    for (std::size_t i = 0; i < m_state.tracks.size(); ++i) {
        Track& track = m_state.tracks[i];
        if (!active(static_cast<int>(i)) || track.inView)
            continue;
        const Point estimate_m = track.estimate_m(time_s());
        if (track.status != TrackStatus::Tracked) {
            growSearches(i, track.q_m2ps);
            for (UavState& uav : m_state.uavs)
                if (uav.search && index(uav.search->iceberg) == i)
                    for (const FieldOfView& view : views)
                        uav.search->way.miss(view, estimate_m, 1);
        } else if (firstWith(views, estimate_m) >= 0) {
            if (const int uav = firstWith(middles, estimate_m); uav >= 0)
                lose(i, uav, views);
        }
    }
}

void Simulation::lookForMeasurements(double now_s)
{
    std::vector<FieldOfView> views;
    std::vector<FieldOfView> middles;
    for (int uav = 0; uav < uavCount(); ++uav) {
        const DubinsState& pose = this->uav(uav).pose;
        views.push_back(fieldOfView(uav));
        middles.emplace_back(middleOf(m_crafts[index(uav)].sensor), pose.position_m, pose.psi_rad);
    }
    const std::int64_t look = m_state.step / m_lookSteps;
    for (std::size_t i = 0; i < m_state.tracks.size(); ++i) {
        if (!appeared(static_cast<int>(i)))
            continue;
        const Point truth_m = m_drift[i].position_m(now_s);
        const int seenBy = firstWith(views, truth_m);
        if (seenBy < 0) {
            miss(i, views, middles);
            continue;
        }
        // One look of several UAVs at once has the luck of one.
        const LookDraw draw = m_noise ? lookDraw(m_seed, m_bodies[i].stream, look) : LookDraw{};
        if (draw.chance < m_observer.detection)
            measure(i, truth_m + m_observer.positionSd_m * draw.noise, now_s, seenBy);
        else
            miss(i, views, middles);
    }
}

void Simulation::measure(std::size_t iceberg, const Point& measured_m, double now_s, int seenBy)
{
    Track& track = m_state.tracks[iceberg];
    const int i = static_cast<int>(iceberg);
    const double variance_m2 = m_observer.positionSd_m * m_observer.positionSd_m;
    if (!track.inView)
        m_newlySeen.push_back({.iceberg = i, .uav = seenBy});
    track.inView = true;
    track.presence = 1;
    if (track.status == TrackStatus::Tracked) {
        track.measured(measured_m, variance_m2, now_s);
        return;
    }
    // What the filter believed was wrong: it starts again.
    const double sd_mps = std::max(std::sqrt(m_bodies[iceberg].velocity_m2ps2), //
                                   kFoundVelocitySd_mps);
    track.anchor_m = measured_m;
    track.anchor_s = now_s;
    track.velocity_mps = m_bodies[iceberg].velocity_mps;
    track.sigma_m2 = variance_m2;
    track.mixed_m2ps = 0;
    track.velocity_m2ps2 = sd_mps * sd_mps;
    track.status = TrackStatus::Tracked;
    endSearchFor(i);
    m_events.push_back({.kind = EventKind::Found, .iceberg = i, .uav = seenBy});
    triggerPlans(PlanReason::Found);
}

/** What the UAVs saw of the iceberg with one look was nothing. */
void Simulation::miss(std::size_t iceberg, std::span<const FieldOfView> views,
                      std::span<const FieldOfView> middles)
{
    Track& track = m_state.tracks[iceberg];
    const Point estimate_m = track.estimate_m(time_s());
    if (track.status != TrackStatus::Tracked) {
        for (UavState& uav : m_state.uavs)
            if (uav.search && index(uav.search->iceberg) == iceberg)
                for (const FieldOfView& view : views)
                    uav.search->way.miss(view, estimate_m, m_observer.detection);
        return;
    }
    if (firstWith(views, estimate_m) < 0) {
        track.inView = false;
        track.presence = 1;
    } else if (const int uav = firstWith(middles, estimate_m); uav >= 0) {
        track.presence = afterMiss(std::min(track.presence, kBelieved), m_observer.detection);
        if (track.presence < kLostBelow)
            lose(iceberg, uav, views);
    }
}

/** The UAV that looked for it in vain searches, unless it does so for another one already. */
void Simulation::lose(std::size_t iceberg, int uav, std::span<const FieldOfView> views)
{
    UavState& me = m_state.uavs[index(uav)];
    Track& track = m_state.tracks[iceberg];
    const int i = static_cast<int>(iceberg);
    track.inView = false;
    track.status = TrackStatus::Lost;
    m_events.push_back({.kind = EventKind::Lost, .iceberg = i, .uav = uav});
    triggerPlans(PlanReason::Lost);
    LostSearch way(m_observer, m_crafts[index(uav)].sensor, std::sqrt(track.sigma_m2),
                   me.pose.psi_rad);
    for (const FieldOfView& view : views)
        way.miss(view, track.estimate_m(time_s()), m_observer.detection);
    if (m_observer.model == ObserverModel::Kalman) // else sigma is that of Eq. (22)
        track.sigma_m2 = std::max(track.sigma_m2, way.variance_m2());
    if (!me.search && !me.homeward() && way.hasCorner()) {
        me.search = {.iceberg = i, .way = std::move(way)};
        return;
    }
    // One at a time: by the end of the search for another this one is far behind.
    giveUp({.iceberg = i, .way = std::move(way)}, uav);
}

void Simulation::endSearchFor(int iceberg)
{
    for (UavState& uav : m_state.uavs)
        if (uav.search && uav.search->iceberg == iceberg)
            uav.search.reset();
    std::erase_if(m_state.givenUp,
                  [iceberg](const Search& search) { return search.iceberg == iceberg; });
}

/** For now: `searchAgain` compares at every plan. */
void Simulation::giveUp(Search search, int uav)
{
    m_state.tracks[index(search.iceberg)].status = TrackStatus::GivenUp;
    m_events.push_back({.kind = EventKind::GivenUp, .iceberg = search.iceberg, .uav = uav});
    triggerPlans(PlanReason::GivenUp);
    m_state.givenUp.push_back(std::move(search));
}

void Simulation::giveUpSearch(int uav)
{
    UavState& me = m_state.uavs[index(uav)];
    giveUp(std::move(*std::exchange(me.search, std::nullopt)), uav);
}

/** Of a UAV that goes home: the nearest one that may search goes on with it, else nobody for now.
 */
void Simulation::handSearchOn(int uav)
{
    Search search = std::move(*std::exchange(m_state.uavs[index(uav)].search, std::nullopt));
    const Point datum_m = estimate_m(search.iceberg);
    UavState* next = nullptr;
    for (int other = 0; other < uavCount(); ++other) {
        UavState& candidate = m_state.uavs[index(other)];
        const auto away_m = [&](const UavState& of) {
            return (of.pose.position_m - datum_m).norm();
        };
        if (other != uav && !candidate.homeward() && !candidate.search &&
            maySearch(other, search.iceberg) &&
            (next == nullptr || away_m(candidate) < away_m(*next)))
            next = &candidate;
    }
    if (next != nullptr)
        next->search = std::move(search);
    else
        giveUp(std::move(search), uav);
}

/** Whether it may be sent there at all. */
bool Simulation::maySearch(int uav, int iceberg) const
{
    const int assigned = m_assigned[index(iceberg)];
    return active(iceberg) && (assigned < 0 || assigned == uav) && affordable(uav, iceberg);
}

bool Simulation::hasSomethingToSearch(int uav) const
{
    return m_observer.search != SearchPattern::None &&
           std::ranges::any_of(m_state.givenUp, [this, uav](const Search& search) {
               return maySearch(uav, search.iceberg);
           });
}

/**
 * With a new target: what has been given up is searched for again where that gains more, because
 * the rest is fresh by now. A new pattern, begun at the datum; what has been seen to be empty stays
 * so.
 */
void Simulation::searchAgain(int uav)
{
    UavState& me = m_state.uavs[index(uav)];
    std::optional<Search> best;
    double best_m2ps = 0;
    for (const Search& old : m_state.givenUp) {
        if (!maySearch(uav, old.iceberg))
            continue;
        const LostSearch pattern(m_observer, m_crafts[index(uav)].sensor, old.way.spread_m(),
                                 me.pose.psi_rad);
        Search search{.iceberg = old.iceberg,
                      .way = LostSearch::restored(pattern.corners_m(), 0, old.way.spread_m(),
                                                  old.way.chances())};
        const double gain_m2ps = searchGain_m2ps(uav, search);
        if (gain_m2ps > best_m2ps && isWorthSearching(uav, search)) {
            best_m2ps = gain_m2ps;
            best = std::move(search);
        }
    }
    if (!best)
        return;
    endSearchFor(best->iceberg);
    m_state.tracks[index(best->iceberg)].status = TrackStatus::Lost;
    me.search = std::move(best);
}

/**
 * Whether the search gains more per second than flying to the target: chance of finding it times
 * its sigma, against the sigma that the target's sighting takes away, over the time until then.
 */
bool Simulation::isWorthSearching(int uav, const Search& search) const
{
    const UavState& me = m_state.uavs[index(uav)];
    const Craft& craft = m_crafts[index(uav)];
    if (!search.way.hasCorner())
        return false;
    if (me.target < 0)
        return true;
    const double speed_mps = craft.motion.airspeed_mps;
    const Point leg_m = estimate_m(me.target) - me.pose.position_m;
    const double leg_s =
        std::max(craft.command_s, (leg_m.norm() - surelySeen_m(craft.sensor)) / speed_mps);
    return searchGain_m2ps(uav, search) > priority(me.target) * track(me.target).sigma_m2 / leg_s;
}

/** Chance per second of finding it, times what that takes away. */
double Simulation::searchGain_m2ps(int uav, const Search& search) const
{
    const UavState& me = m_state.uavs[index(uav)];
    const Craft& craft = m_crafts[index(uav)];
    const double variance_m2 = std::max(track(search.iceberg).sigma_m2, search.way.variance_m2());
    return priority(search.iceberg) * variance_m2 *
           search.way.chancePerSecond(me.pose.position_m - estimate_m(search.iceberg),
                                      craft.motion.airspeed_mps, surelySeen_m(craft.sensor),
                                      m_observer.detection);
}

/** With a new target: searched for first, or no longer. */
void Simulation::beginOrEndSearch(int uav)
{
    UavState& me = m_state.uavs[index(uav)];
    if (!me.search)
        searchAgain(uav);
    if (!me.search)
        return;
    if (isWorthSearching(uav, *me.search))
        me.mode = FlightMode::Search;
    else
        giveUpSearch(uav);
}

double Simulation::steerSearch(int uav)
{
    UavState& me = m_state.uavs[index(uav)];
    const Craft& craft = m_crafts[index(uav)];
    if (!me.search)
        return 0; // ended; a plan follows
    LostSearch& way = me.search->way;
    const Point corner_m = estimate_m(me.search->iceberg) + way.corner_m();
    const bool fencedOff = isFencedOff(craft.fence.get(), me.guidance.start_m, corner_m);
    if (!fencedOff)
        if (const std::optional<double> u_radps = steerRoundFence(uav, corner_m))
            return *u_radps;
    const LosGuidance::Command command =
        me.guidance.steer(me.pose, corner_m, craft.motion, craft.command_s);
    me.crossTrack_m = command.crossTrack_m;
    if (!command.passedEnd && !fencedOff)
        return command.u_radps;
    way.nextCorner();
    me.guidance.startLeg(me.pose.position_m);
    if (!isWorthSearching(uav, *me.search))
        giveUpSearch(uav);
    return command.u_radps;
}

/** Icebergs farther outside the area than their own radius are no longer monitored, until their
 * estimate is inside again. */
void Simulation::watchArea()
{
    for (int i = 0; i < icebergCount(); ++i) {
        if (!appeared(i))
            continue;
        Track& track = m_state.tracks[index(i)];
        const bool isInside = insidePolygon(m_area_m, estimate_m(i));
        if (track.left && isInside) {
            track.left = false;
            m_newlyAppeared.push_back(i);
        } else if (!track.left && !isInside &&
                   distanceToEdges(m_area_m, estimate_m(i)) > m_bodies[index(i)].radius_m) {
            track.left = true;
            m_events.push_back({.kind = EventKind::Left, .iceberg = i});
            triggerPlans(PlanReason::Left);
            endSearchFor(i);
        }
    }
}

} // namespace berg
