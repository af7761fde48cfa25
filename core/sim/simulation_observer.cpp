// What is seen, with measurements: the part of `Simulation` that filters, loses and finds icebergs.

#include "core/sim/simulation.h"
#include "core/vehicle/geofence.h"

#include <algorithm>
#include <cmath>

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
        for (UavState& uav : m_state.uavs)
            if (uav.search && index(uav.search->iceberg) == i)
                uav.search->way.grow(track.sigma_m2 - before_m2);
    }
    if (m_state.step % m_lookSteps == 0)
        lookForMeasurements(now_s);
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
    m_news.push_back({.kind = EventKind::Found, .iceberg = i, .uav = seenBy});
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
    m_news.push_back({.kind = EventKind::Lost, .iceberg = i, .uav = uav});
    LostSearch way(m_observer, m_crafts[index(uav)].sensor, std::sqrt(track.sigma_m2),
                   me.pose.psi_rad);
    for (const FieldOfView& view : views)
        way.miss(view, track.estimate_m(time_s()), m_observer.detection);
    track.sigma_m2 = std::max(track.sigma_m2, way.variance_m2());
    if (!me.search && way.hasCorner()) {
        me.search = {.iceberg = i, .way = std::move(way)};
        return;
    }
    // One at a time: by the end of the search for another this one is far behind.
    track.status = TrackStatus::GivenUp;
    m_news.push_back({.kind = EventKind::GivenUp, .iceberg = i, .uav = uav});
}

void Simulation::endSearchFor(int iceberg)
{
    for (UavState& uav : m_state.uavs)
        if (uav.search && uav.search->iceberg == iceberg)
            uav.search.reset();
}

void Simulation::giveUpSearch(int uav)
{
    UavState& me = m_state.uavs[index(uav)];
    const int iceberg = me.search->iceberg;
    m_state.tracks[index(iceberg)].status = TrackStatus::GivenUp;
    me.search.reset();
    m_news.push_back({.kind = EventKind::GivenUp, .iceberg = iceberg, .uav = uav});
}

/**
 * Whether the search gains more per second than flying to the target: chance of finding it times
 * its sigma, against the sigma that the target's sighting takes away, over the time until then.
 */
bool Simulation::isWorthSearching(int uav) const
{
    const UavState& me = m_state.uavs[index(uav)];
    const Craft& craft = m_crafts[index(uav)];
    const Search& search = *me.search;
    if (!search.way.hasCorner())
        return false;
    if (me.target < 0)
        return true;
    const double speed_mps = craft.motion.airspeed_mps;
    const double reach_m = craft.sensor.fov_m.minCoeff() / 2;
    const Track& lost = track(search.iceberg);
    const double found_m2ps =
        priority(search.iceberg) * lost.sigma_m2 *
        search.way.chancePerSecond(me.pose.position_m - estimate_m(search.iceberg), speed_mps,
                                   reach_m, m_observer.detection);
    const Point leg_m = estimate_m(me.target) - me.pose.position_m;
    const double leg_s = std::max(craft.command_s, (leg_m.norm() - reach_m) / speed_mps);
    return found_m2ps > priority(me.target) * track(me.target).sigma_m2 / leg_s;
}

/** With a new target: searched for first, or no longer. */
void Simulation::beginOrEndSearch(int uav)
{
    UavState& me = m_state.uavs[index(uav)];
    if (!me.search)
        return;
    if (isWorthSearching(uav))
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
    if (!isWorthSearching(uav))
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
            m_news.push_back({.kind = EventKind::Left, .iceberg = i});
            endSearchFor(i);
        }
    }
}

} // namespace berg
