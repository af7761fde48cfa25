// What is in view: the part of `Simulation` that looks.

#include "core/sim/simulation.h"

#include <algorithm>
#include <limits>

namespace berg {

namespace {

/** Icebergs farther out of reach than this are out of view in spite of all rounding. */
constexpr double kReachMargin_m = 1;

} // namespace

FieldOfView Simulation::fieldOfView(int uav) const
{
    const UavState& me = m_state.uavs[index(uav)];
    SensorSpec sensor = m_crafts[index(uav)].sensor;
    if (me.mode == FlightMode::Ground) // switched off: nothing is within these extents
        sensor.fov_m.setConstant(std::numeric_limits<double>::quiet_NaN());
    return {sensor, me.pose.position_m, me.pose.psi_rad};
}

int Simulation::viewer(const Point& place_m, Views& views) const
{
    for (int uav = 0; uav < uavCount(); ++uav) {
        std::optional<FieldOfView>& view = views[index(uav)];
        if (!view)
            view = fieldOfView(uav);
        if (view->contains(place_m))
            return uav;
    }
    return -1;
}

void Simulation::observe(double dt_s)
{
    const double now_s = time_s();
    // Icebergs out of reach are left alone for long; so `truth_m` has at most a second to make up.
    if (m_state.step % m_stepsPerSecond == 0)
        for (std::size_t i = 0; i < m_drift.size(); ++i)
            if (m_appearsStep[i] <= m_state.step)
                m_drift[i].advanceTo(now_s);
    const bool isFiltered = m_observer.model == ObserverModel::Kalman;
    if (isFiltered)
        observeFiltered(now_s, dt_s);
    else if (m_nextLookStep <= m_state.step)
        lookAround(now_s);
    if (!isFiltered && m_state.step % m_stepsPerSecond == 0)
        watchEstimates();
    if (!m_area_m.empty() && m_state.step % m_stepsPerSecond == 0)
        watchArea();
    double sigmaSum_m2 = 0;
    for (std::size_t i = 0; i < m_state.tracks.size(); ++i) {
        const std::int64_t age = m_state.step - m_appearsStep[i];
        if (age < 0)
            continue;
        Track& track = m_state.tracks[i];
        if (!isFiltered && !track.inView)
            track.unseen(age == 0 ? 0 : dt_s);
        if (!track.left)
            sigmaSum_m2 += track.sigma_m2;
    }
    m_state.sigmaSum_m2 = sigmaSum_m2;
}

void Simulation::lookAround(double now_s)
{
    Views views(m_crafts.size());
    m_nextLookStep = m_lastStep + 1;
    for (std::size_t i = 0; i < m_lookStep.size(); ++i) {
        if (m_lookStep[i] <= m_state.step)
            look(i, now_s, views);
        m_nextLookStep = std::min(m_nextLookStep, m_lookStep[i]);
    }
}

/** Whether the iceberg is in view now. */
void Simulation::look(std::size_t iceberg, double now_s, Views& views)
{
    if (m_appearsStep[iceberg] == m_state.step)
        m_newlyAppeared.push_back(static_cast<int>(iceberg));
    Track& track = m_state.tracks[iceberg];
    const Point truth_m = m_drift[iceberg].position_m(now_s);
    if (const std::int64_t steps = stepsOutOfReach(iceberg, truth_m); steps > 0) {
        m_lookStep[iceberg] = m_state.step + steps;
        track.inView = false;
        return;
    }
    m_lookStep[iceberg] = m_state.step + 1;
    const int uav = viewer(truth_m, views);
    if (uav < 0) {
        track.inView = false;
        return;
    }
    if (!track.inView)
        m_newlySeen.push_back({.iceberg = static_cast<int>(iceberg), .uav = uav});
    track.seen(truth_m, now_s);
    if (track.status != TrackStatus::Tracked) {
        track.status = TrackStatus::Tracked;
        endSearchFor(static_cast<int>(iceberg));
        m_events.push_back(
            {.kind = EventKind::Found, .iceberg = static_cast<int>(iceberg), .uav = uav});
        triggerPlans(PlanReason::Found);
    }
}

/**
 * 0: near enough to a UAV to be in view. Else the steps before it may be, UAVs and iceberg being as
 * fast as they can.
 */
std::int64_t Simulation::stepsOutOfReach(std::size_t iceberg, const Point& truth_m) const
{
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (std::size_t u = 0; u < m_crafts.size(); ++u) {
        const Craft& craft = m_crafts[u];
        const double away_m =
            (truth_m - m_state.uavs[u].pose.position_m).norm() - craft.reach_m - kReachMargin_m;
        if (away_m <= 0)
            return 0;
        const double closing_mps = craft.motion.airspeed_mps + craft.motion.wind_mps.norm() +
                                   m_drift[iceberg].speedLimit_mps();
        least = std::min(least, static_cast<std::int64_t>(away_m / closing_mps / m_dt_s));
    }
    return std::max<std::int64_t>(1, least);
}

} // namespace berg
