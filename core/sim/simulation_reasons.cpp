// When a plan is needed, and why: the part of `Simulation` that asks for plans.

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
    for (int uav = 0; uav < uavCount(); ++uav)
        needPlan(uav, reason);
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
    for (int uav = 0; uav < uavCount(); ++uav)
        if (!this->uav(uav).homeward())
            uavs.push_back(uav);
    return uavs;
}

/** All UAVs are planned together: where one needs a plan the others get one too. */
void Simulation::updatePlanReasons()
{
    bool needed = false;
    for (int uav = 0; uav < uavCount(); ++uav) {
        m_planReasons[index(uav)] = reasonOf(uav);
        needed = needed || m_planReasons[index(uav)] != PlanReason::None;
    }
    if (needed)
        for (int uav = 0; uav < uavCount(); ++uav)
            if (planReason(uav) == PlanReason::None)
                needPlan(uav, PlanReason::Fleet);
}

PlanReason Simulation::reasonOf(int uav)
{
    UavState& me = m_state.uavs[index(uav)];
    if (me.homeward())
        return takeOffWhenDue(uav);
    if (const PlanReason reason = reasonOfNews(); reason != PlanReason::None)
        return reason;
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
 * it waits for the plan that follows their next visit, unless an iceberg is kept for it.
 */
bool Simulation::somethingForIdle(int uav) const
{
    const bool othersFly =
        std::ranges::any_of(m_state.uavs, [](const UavState& other) { return other.target >= 0; });
    if (othersFly && m_state.step % m_stepsPerSecond != 0)
        return false; // a planner that leaves it out is not asked at each step
    for (int i = 0; i < icebergCount(); ++i)
        if (othersFly ? assignedTo(i) == uav && available(uav, i) : visitable(uav, i))
            return true;
    return false;
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
        case EventKind::HomeBound: // what it was to visit is left to the others
            if (uavCount() > 1)
                return PlanReason::Fleet;
            break;
        default:
            break;
        }
    return PlanReason::None;
}

} // namespace berg
