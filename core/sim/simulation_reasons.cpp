// When a plan is needed, and why: the part of `Simulation` that asks for plans.

#include "core/base/angles.h"
#include "core/sim/simulation.h"

#include <algorithm>

namespace berg {

namespace {

/** A sighting later than predicted by this is overdue. */
constexpr double kOverdue_s = 2;

} // namespace

void Simulation::needPlan(int uav, PlanReason reason)
{
    if (!m_state.uavs[index(uav)].homeward())
        m_planReasons[index(uav)] = reason;
}

void Simulation::needPlans(PlanReason reason)
{
    for (int uav = 0; uav < uavCount(); ++uav) {
        m_state.uavs[index(uav)].isAlone = false;
        needPlan(uav, reason);
    }
}

/** At the end of this step every UAV aloft needs a plan. */
void Simulation::triggerPlans(PlanReason reason)
{
    if (m_trigger == PlanReason::None)
        m_trigger = reason;
}

PlanReason Simulation::planReason() const
{
    PlanReason reason = PlanReason::None;
    for (const PlanReason own : m_planReasons) {
        if (own != PlanReason::None && own != PlanReason::Fleet)
            return own;
        if (own == PlanReason::Fleet)
            reason = own;
    }
    return reason;
}

std::vector<int> Simulation::plannedUavs() const
{
    std::vector<int> uavs;
    std::vector<int> needing;
    for (int uav = 0; uav < uavCount(); ++uav) {
        if (this->uav(uav).homeward())
            continue;
        uavs.push_back(uav);
        if (planReason(uav) != PlanReason::None)
            needing.push_back(uav);
    }
    return needing.empty() ? uavs : needing;
}

bool Simulation::othersFly() const
{
    return std::ranges::any_of(m_state.uavs,
                               [](const UavState& other) { return other.target >= 0; });
}

bool Simulation::isTargetOfUnplanned(int iceberg) const
{
    if (planReason() == PlanReason::None)
        return false; // asked about in between, all of them are planned
    for (int uav = 0; uav < uavCount(); ++uav)
        if (this->uav(uav).target == iceberg && planReason(uav) == PlanReason::None)
            return true;
    return false;
}

/**
 * All UAVs are planned together: where one needs a plan the others get one too. But for one without
 * a target: whenever it finds something, a new plan for all would turn the others round too.
 */
void Simulation::updatePlanReasons()
{
    bool needed = false;
    const bool mayBeAlone = m_plansIdleAlone && othersFly();
    for (int uav = 0; uav < uavCount(); ++uav) {
        const PlanReason reason = reasonOf(uav);
        m_planReasons[index(uav)] = reason;
        UavState& me = m_state.uavs[index(uav)];
        const bool ofOneAlone = reason == PlanReason::OutOfView ||
                                (me.isAlone && (reason == PlanReason::TargetReached ||
                                                reason == PlanReason::SeenByOther));
        if (mayBeAlone && ofOneAlone)
            me.isAlone = true;
        else
            needed = needed || reason != PlanReason::None;
    }
    for (int uav = 0; needed && uav < uavCount(); ++uav) {
        m_state.uavs[index(uav)].isAlone = false;
        if (planReason(uav) == PlanReason::None)
            needPlan(uav, PlanReason::Fleet);
    }
}

PlanReason Simulation::reasonOf(int uav)
{
    UavState& me = m_state.uavs[index(uav)];
    if (me.homeward())
        return takeOffWhenDue(uav);
    if (m_trigger != PlanReason::None)
        return m_trigger;
    if (me.target >= 0 && me.aim && me.mode != FlightMode::Search)
        return reasonOfAim(uav);
    if (me.target >= 0 && targetReached(uav)) {
        me.lastReached = me.target;
        return PlanReason::TargetReached;
    }
    if (!m_newlyAppeared.empty())
        return PlanReason::Appeared;
    if (me.target >= 0)
        return isReachedByOther(uav, me.target) ? PlanReason::SeenByOther : PlanReason::None;
    return somethingForIdle(uav) ? PlanReason::OutOfView : PlanReason::None;
}

PlanReason Simulation::reasonOfAim(int uav)
{
    UavState& me = m_state.uavs[index(uav)];
    const bool sees = std::ranges::any_of(
        m_newlySeen, [uav](const SeenIceberg& sighting) { return sighting.uav == uav; });
    const bool targetSeen = inOwnView(uav, me.target);
    if ((sees || uavCount() > 1) && targetSeen) {
        me.lastReached = me.target;
        return PlanReason::TargetReached;
    }
    if (sees)
        return PlanReason::Sighted;
    if (track(me.target).inView && !targetSeen)
        return PlanReason::SeenByOther;
    if (!m_newlyAppeared.empty())
        return PlanReason::Appeared;
    return time_s() > me.aim->sighting_s + kOverdue_s ? PlanReason::Overdue : PlanReason::None;
}

/**
 * Whether a UAV without a target should be planned again. While others of the fleet fly to targets
 * it has what none of them flies to and it has not seen on the last round of its circle; where
 * routes are repeated, only what is kept for it.
 */
bool Simulation::somethingForIdle(int uav) const
{
    const bool isOneOfFleet = othersFly();
    if (isOneOfFleet && m_state.step % m_stepsPerSecond != 0)
        return false; // a planner that leaves it out is not asked at each step
    // What is beside its circle comes into view again.
    const double round_s = 2 * kPi * circleRadius_m(uav) / motion(uav).airspeed_mps;
    const auto isForIt = [&](int i) {
        if (!isOneOfFleet)
            return visitable(uav, i);
        const bool isForAny = m_plansIdleAlone && time_s() - track(i).anchor_s > round_s;
        return (isForAny || assignedTo(i) == uav) &&
               std::ranges::find(m_state.uavs, i, &UavState::target) == m_state.uavs.end() &&
               available(uav, i);
    };
    for (int i = 0; i < icebergCount(); ++i)
        if (isForIt(i))
            return true;
    return false;
}

} // namespace berg
