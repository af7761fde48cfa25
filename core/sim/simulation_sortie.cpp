// Endurance and home: the part of `Simulation` that flies in sorties.

#include "core/sim/simulation.h"
#include "core/vehicle/geofence.h"

#include <algorithm>

namespace berg {

void Simulation::needPlan(PlanReason reason)
{
    if (!homeward())
        m_planReason = reason;
}

bool Simulation::available(int iceberg) const
{
    return visitable(iceberg) && affordable(iceberg);
}

/** Of this sortie; on the ground, of the next. */
double Simulation::enduranceLeft_s() const
{
    return m_sortie->endurance_s - (m_state.mode == FlightMode::Ground ? 0 : m_state.aloft_s);
}

std::optional<Way> Simulation::wayTo(const DubinsState& from, const Point& place_m,
                                     const Point& drift_mps) const
{
    const MovingPlace place{.place_m = place_m, .drift_mps = drift_mps};
    return m_fence ? m_fence->wayTo(from, place, m_command_s)
                   : berg::wayTo(from, place, m_motion, m_command_s);
}

std::optional<double> Simulation::timeHome_s(const DubinsState& from) const
{
    const std::optional<Way> way = wayTo(from, m_sortie->home_m, Point::Zero());
    if (!way)
        return std::nullopt;
    // The fence may turn it aside once, and round a circle, where the way leads close by.
    return way->time_s + (m_fence ? m_fence->circle_s() : 0);
}

bool Simulation::affordable(int iceberg) const
{
    if (!m_sortie)
        return true;
    return thisSortie(std::span(&iceberg, 1)) == 1;
}

std::optional<int> Simulation::thisSortie(std::span<const int> order) const
{
    if (!m_sortie)
        return std::nullopt;
    const double left_s = enduranceLeft_s() - kHomeReserve_s - kVisitReserve_s;
    DubinsState uav = m_state.uav;
    double flown_s = 0;
    int visits = 0;
    for (const int iceberg : order) {
        const Point& drift_mps = track(iceberg).velocity_mps;
        const std::optional<Way> way =
            wayTo(uav, estimate_m(iceberg) + drift_mps * flown_s, drift_mps);
        if (!way)
            break;
        flown_s += way->time_s;
        uav = way->end;
        const std::optional<double> home_s = timeHome_s(uav);
        if (!home_s || flown_s + *home_s > left_s)
            break;
        ++visits;
    }
    return visits;
}

/** There is something to be visited, but not in this sortie. */
bool Simulation::nothingAffordable() const
{
    return m_sortie && nearest(&Simulation::visitable) >= 0 && nearestAvailable() < 0;
}

DubinsState Simulation::heldFor(double u_radps, std::int64_t steps) const
{
    DubinsState uav = m_state.uav;
    for (std::int64_t i = 0; i < steps; ++i)
        uav = berg::step(uav, m_motion.airspeed_mps, u_radps, m_dt_s, m_motion.wind_mps);
    return uav;
}

/** Whether home can still be reached in time after one more command. */
bool Simulation::homeInTimeAfter(double u_radps) const
{
    const DubinsState after = heldFor(u_radps, m_autopilotSteps);
    const double left_s = enduranceLeft_s() - m_command_s - kHomeReserve_s;
    const Point& home_m = m_sortie->home_m;
    const double longest_s = m_fence ? m_fence->longestWay_s(after, home_m, m_command_s)
                                     : longestWay_s(after, home_m, m_motion, m_command_s);
    if (longest_s <= left_s)
        return true;
    const std::optional<double> home_s = timeHome_s(after);
    return home_s && *home_s <= left_s;
}

std::optional<double> Simulation::homeMargin_s() const
{
    if (!m_sortie || m_state.mode == FlightMode::Ground)
        return std::nullopt;
    const std::int64_t held =
        (m_autopilotSteps - m_state.step % m_autopilotSteps) % m_autopilotSteps;
    const std::optional<double> home_s = timeHome_s(heldFor(m_state.u_radps, held));
    return home_s ? enduranceLeft_s() - static_cast<double>(held) * m_dt_s - *home_s
                  : -m_sortie->endurance_s;
}

void Simulation::goHome()
{
    m_state.mode = FlightMode::Home;
    m_state.target = -1;
    m_state.aim.reset();
    m_state.members.clear();
    m_state.via_m.reset();
    m_planReason = PlanReason::None;
    m_news.push_back({.kind = EventKind::HomeBound});
}

double Simulation::steerHome()
{
    m_state.crossTrack_m = 0;
    const std::optional<Way> way = wayTo(m_state.uav, m_sortie->home_m, Point::Zero());
    return way ? turnRateOf(*way, m_motion, m_command_s) : 0;
}

/** One step of the clocks; lands where home has been passed on the way from `from_m`. */
void Simulation::advanceSortie(const Point& from_m)
{
    if (m_state.mode == FlightMode::Ground) {
        m_state.ground_s = std::max(0.0, m_state.ground_s - m_dt_s);
        return;
    }
    m_state.aloft_s += m_dt_s;
    if (m_state.aloft_s > m_sortie->endurance_s &&
        m_state.aloft_s - m_dt_s <= m_sortie->endurance_s)
        m_news.push_back({.kind = EventKind::LateHome});
    if (m_state.mode != FlightMode::Home ||
        distanceToSegment(from_m, m_state.uav.position_m, m_sortie->home_m) > kLandingRadius_m)
        return;
    m_state.mode = FlightMode::Ground;
    m_state.u_radps = 0;
    m_state.crossTrack_m = 0;
    m_state.ground_s = m_sortie->turnaround_s;
    m_news.push_back({.kind = EventKind::Landed});
}

/** After the turn-around, as soon as there is an iceberg that can be visited. */
void Simulation::takeOffWhenDue()
{
    const bool due = m_state.mode == FlightMode::Ground && m_state.ground_s < m_dt_s / 2 &&
                     m_state.step % m_stepsPerSecond == 0;
    if (!due || nearestAvailable() < 0)
        return;
    m_state.aloft_s = 0;
    m_state.mode = FlightMode::Idle;
    m_planReason = PlanReason::TakeOff;
    m_news.push_back({.kind = EventKind::TookOff});
}

} // namespace berg
