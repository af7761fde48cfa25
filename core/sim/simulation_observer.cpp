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
        if (m_state.search && index(m_state.search->iceberg) == i)
            m_state.search->way.grow(track.sigma_m2 - before_m2);
    }
    if (m_state.step % m_lookSteps == 0)
        lookForMeasurements(now_s);
}

void Simulation::lookForMeasurements(double now_s)
{
    const FieldOfView view = fieldOfView();
    const FieldOfView middle(middleOf(m_sensor), m_state.uav.position_m, m_state.uav.psi_rad);
    const std::int64_t look = m_state.step / m_lookSteps;
    for (std::size_t i = 0; i < m_state.tracks.size(); ++i) {
        if (!appeared(static_cast<int>(i)))
            continue;
        const Point truth_m = m_drift[i].position_m(now_s);
        if (!view.contains(truth_m)) {
            miss(i, view, middle);
            continue;
        }
        const LookDraw draw = m_noise ? lookDraw(m_seed, m_bodies[i].stream, look) : LookDraw{};
        if (draw.chance < m_observer.detection)
            measure(i, truth_m + m_observer.positionSd_m * draw.noise, now_s);
        else
            miss(i, view, middle);
    }
}

void Simulation::measure(std::size_t iceberg, const Point& measured_m, double now_s)
{
    Track& track = m_state.tracks[iceberg];
    const int i = static_cast<int>(iceberg);
    const double variance_m2 = m_observer.positionSd_m * m_observer.positionSd_m;
    if (!track.inView)
        m_newlySeen.push_back(i);
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
    if (m_state.search && m_state.search->iceberg == i)
        m_state.search.reset();
    m_news.push_back({EventKind::Found, i});
}

/** The look showed nothing of the iceberg. */
void Simulation::miss(std::size_t iceberg, const FieldOfView& view, const FieldOfView& middle)
{
    Track& track = m_state.tracks[iceberg];
    const Point estimate_m = track.estimate_m(time_s());
    if (track.status != TrackStatus::Tracked) {
        if (m_state.search && index(m_state.search->iceberg) == iceberg)
            m_state.search->way.miss(view, estimate_m, m_observer.detection);
        return;
    }
    if (!view.contains(estimate_m)) {
        track.inView = false;
        track.presence = 1;
    } else if (middle.contains(estimate_m)) {
        track.presence = afterMiss(std::min(track.presence, kBelieved), m_observer.detection);
        if (track.presence < kLostBelow)
            lose(iceberg, view);
    }
}

void Simulation::lose(std::size_t iceberg, const FieldOfView& view)
{
    Track& track = m_state.tracks[iceberg];
    const int i = static_cast<int>(iceberg);
    track.inView = false;
    track.status = TrackStatus::Lost;
    m_news.push_back({EventKind::Lost, i});
    LostSearch way(m_observer, m_sensor, std::sqrt(track.sigma_m2), m_state.uav.psi_rad);
    way.miss(view, track.estimate_m(time_s()), m_observer.detection);
    track.sigma_m2 = std::max(track.sigma_m2, way.variance_m2());
    if (!m_state.search && way.hasCorner()) {
        m_state.search = {.iceberg = i, .way = std::move(way)};
        return;
    }
    // One at a time: by the end of the search for another this one is far behind.
    track.status = TrackStatus::GivenUp;
    m_news.push_back({EventKind::GivenUp, i});
}

void Simulation::giveUpSearch()
{
    const int iceberg = m_state.search->iceberg;
    m_state.tracks[index(iceberg)].status = TrackStatus::GivenUp;
    m_state.search.reset();
    m_news.push_back({EventKind::GivenUp, iceberg});
}

/**
 * Whether the search gains more per second than flying to the target: chance of finding it times
 * its sigma, against the sigma that the target's sighting takes away, over the time until then.
 */
bool Simulation::isWorthSearching() const
{
    const Search& search = *m_state.search;
    if (!search.way.hasCorner())
        return false;
    if (m_state.target < 0)
        return true;
    const double speed_mps = m_motion.airspeed_mps;
    const double reach_m = m_sensor.fov_m.minCoeff() / 2;
    const Track& lost = track(search.iceberg);
    const double found_m2ps =
        priority(search.iceberg) * lost.sigma_m2 *
        search.way.chancePerSecond(m_state.uav.position_m - estimate_m(search.iceberg), speed_mps,
                                   reach_m, m_observer.detection);
    const Point leg_m = estimate_m(m_state.target) - m_state.uav.position_m;
    const double leg_s = std::max(m_command_s, (leg_m.norm() - reach_m) / speed_mps);
    return found_m2ps > priority(m_state.target) * track(m_state.target).sigma_m2 / leg_s;
}

/** With a new target: searched for first, or no longer. */
void Simulation::beginOrEndSearch()
{
    if (!m_state.search)
        return;
    if (isWorthSearching())
        m_state.mode = FlightMode::Search;
    else
        giveUpSearch();
}

double Simulation::steerSearch()
{
    if (!m_state.search)
        return 0; // ended; a plan follows
    LostSearch& way = m_state.search->way;
    const Point corner_m = estimate_m(m_state.search->iceberg) + way.corner_m();
    const bool fencedOff = isFencedOff(m_fence.get(), m_state.guidance.start_m, corner_m);
    if (!fencedOff)
        if (const std::optional<double> u_radps = steerRoundFence(corner_m))
            return *u_radps;
    const LosGuidance::Command command =
        m_state.guidance.steer(m_state.uav, corner_m, m_motion, m_command_s);
    m_state.crossTrack_m = command.crossTrack_m;
    if (!command.passedEnd && !fencedOff)
        return command.u_radps;
    way.nextCorner();
    m_state.guidance.startLeg(m_state.uav.position_m);
    if (!isWorthSearching())
        giveUpSearch();
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
            m_news.push_back({EventKind::Left, i});
            if (m_state.search && m_state.search->iceberg == i)
                m_state.search.reset();
        }
    }
}

/** Why what the log names asks for a plan; `None`: it does not. */
PlanReason Simulation::reasonOfNews() const
{
    for (const News& news : m_news)
        switch (news.kind) {
        case EventKind::Left:
            return PlanReason::Left;
        case EventKind::Lost:
            return PlanReason::Lost;
        case EventKind::Found:
            return PlanReason::Found;
        case EventKind::GivenUp:
            return PlanReason::GivenUp;
        default:
            break;
        }
    return PlanReason::None;
}

} // namespace berg
