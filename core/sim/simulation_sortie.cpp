// Endurance and home: the part of `Simulation` that flies in sorties.

#include "core/sim/simulation.h"
#include "core/vehicle/geofence.h"

#include <algorithm>

namespace berg {

namespace {

/** On the ground, while no heading is safe to take off with. */
constexpr double kNextTry_s = 60;

} // namespace

bool Simulation::available(int uav, int iceberg) const
{
    return visitable(uav, iceberg) && affordable(uav, iceberg);
}

/** Of this sortie; on the ground, of the next. */
double Simulation::enduranceLeft_s(int uav) const
{
    const UavState& me = m_state.uavs[index(uav)];
    const Craft& craft = m_crafts[index(uav)];
    return craft.sortie->endurance_s - (me.mode == FlightMode::Ground ? 0 : me.aloft_s);
}

SafetyGuard Simulation::guardOf(int uav) const
{
    const Craft& craft = m_crafts[index(uav)];
    return SafetyGuard({.motion = craft.motion,
                        .sortie = craft.sortie,
                        .fence = craft.fence.get(),
                        .clock = {.dt_s = m_dt_s, .steps = craft.autopilotSteps}});
}

bool Simulation::affordable(int uav, int iceberg) const
{
    const Craft& craft = m_crafts[index(uav)];
    if (!craft.sortie)
        return true;
    return thisSortie(uav, std::span(&iceberg, 1)) == 1;
}

std::optional<int> Simulation::thisSortie(int uav, std::span<const int> order) const
{
    const UavState& me = m_state.uavs[index(uav)];
    const Craft& craft = m_crafts[index(uav)];
    if (!craft.sortie)
        return std::nullopt;
    const double left_s = enduranceLeft_s(uav) - kHomeReserve_s - kVisitReserve_s;
    const SafetyGuard guard = guardOf(uav);
    DubinsState at = me.pose;
    double flown_s = 0;
    int visits = 0;
    for (const int iceberg : order) {
        const Point& drift_mps = track(iceberg).velocity_mps;
        const std::optional<Way> way = guard.wayTo(
            at, {.place_m = estimate_m(iceberg) + drift_mps * flown_s, .drift_mps = drift_mps});
        if (!way)
            break;
        flown_s += way->time_s;
        at = way->end;
        const std::optional<double> home_s = guard.timeHome_s(at);
        if (!home_s || flown_s + *home_s > left_s)
            break;
        ++visits;
    }
    return visits;
}

std::optional<double> Simulation::homeMargin_s(int uav) const
{
    const UavState& me = m_state.uavs[index(uav)];
    const Craft& craft = m_crafts[index(uav)];
    if (!craft.sortie || me.mode == FlightMode::Ground)
        return std::nullopt;
    const std::int64_t held = stepsHeld(uav);
    const SafetyGuard guard = guardOf(uav);
    const std::optional<double> home_s =
        me.returnPath ? guard.time_s(*me.returnPath)
                      : guard.timeHome_s(guard.heldFor(me.pose, me.u_radps, held));
    return home_s ? enduranceLeft_s(uav) - static_cast<double>(held) * m_dt_s - *home_s
                  : -craft.sortie->endurance_s;
}

/** Steps for which the command in force is held on. */
std::int64_t Simulation::stepsHeld(int uav) const
{
    const std::int64_t steps = m_crafts[index(uav)].autopilotSteps;
    return (steps - m_state.step % steps) % steps;
}

/** From the next command on, whatever there was before. */
void Simulation::proveReturn(int uav)
{
    UavState& me = m_state.uavs[index(uav)];
    const SafetyGuard guard = guardOf(uav);
    me.returnPath.reset();
    if (guard.provesReturn() && me.mode != FlightMode::Ground)
        me.returnPath = guard.returnPath(guard.heldFor(me.pose, me.u_radps, stepsHeld(uav)));
}

void Simulation::goHome(int uav)
{
    UavState& me = m_state.uavs[index(uav)];
    me.mode = FlightMode::Home;
    me.target = -1;
    me.aim.reset();
    me.members.clear();
    me.via_m.reset();
    if (me.search)
        handSearchOn(uav);
    m_planReasons[index(uav)] = PlanReason::None;
    m_events.push_back({.kind = EventKind::HomeBound, .uav = uav});
    if (uavCount() > 1) // what it was to visit is left to the others
        triggerPlans(PlanReason::Fleet);
}

double Simulation::steerHome(int uav)
{
    UavState& me = m_state.uavs[index(uav)];
    me.crossTrack_m = 0;
    return guardOf(uav).homeRate_radps(me.pose);
}

/** One step of the clocks; lands where home has been passed on the way from `from_m`. */
void Simulation::advanceSortie(int uav, const Point& from_m)
{
    UavState& me = m_state.uavs[index(uav)];
    const Craft& craft = m_crafts[index(uav)];
    if (me.mode == FlightMode::Ground) {
        me.ground_s = std::max(0.0, me.ground_s - m_dt_s);
        return;
    }
    me.aloft_s += m_dt_s;
    if (me.aloft_s > craft.sortie->endurance_s && me.aloft_s - m_dt_s <= craft.sortie->endurance_s)
        m_events.push_back({.kind = EventKind::LateHome, .uav = uav});
    if (me.mode != FlightMode::Home ||
        distanceToSegment(from_m, me.pose.position_m, craft.sortie->home_m) > kLandingRadius_m)
        return;
    me.mode = FlightMode::Ground;
    me.u_radps = 0;
    me.crossTrack_m = 0;
    me.ground_s = craft.sortie->turnaround_s;
    me.returnPath.reset();
    m_events.push_back({.kind = EventKind::Landed, .uav = uav});
}

/** After the turn-around, as soon as there is an iceberg that can be visited. */
PlanReason Simulation::takeOffWhenDue(int uav)
{
    UavState& me = m_state.uavs[index(uav)];
    const bool due = me.mode == FlightMode::Ground && me.ground_s < m_dt_s / 2 &&
                     m_state.step % m_stepsPerSecond == 0;
    if (!due || (nearestAvailable(uav) < 0 && !hasSomethingToSearch(uav)))
        return PlanReason::None;
    if (const SafetyGuard guard = guardOf(uav); guard.provesReturn()) {
        const std::optional<double> heading_rad =
            guard.safeHeading_rad(me.pose, sortie(uav)->endurance_s);
        if (!heading_rad) { // it would not come home: perhaps in another wind
            me.ground_s = kNextTry_s;
            return PlanReason::None;
        }
        me.pose.psi_rad = *heading_rad;
    }
    me.aloft_s = 0;
    me.mode = FlightMode::Idle;
    proveReturn(uav);
    m_events.push_back({.kind = EventKind::TookOff, .uav = uav});
    return PlanReason::TakeOff;
}

} // namespace berg
