#include "core/sim/plan_trigger.h"

#include "core/base/angles.h"

#include <algorithm>

namespace berg {

namespace {

/** Delay of a predicted sighting after which it is overdue. */
constexpr double kOverdue_s = 2;

bool targetReached(int uav, const FlightTarget& flightTarget, const Fleet& fleet)
{
    if (flightTarget.members.empty())
        return isReached(fleet.observer(), uav, *flightTarget.target);
    return std::ranges::all_of(flightTarget.members, [&](IcebergIndex member) {
        return isReached(fleet.observer(), uav, member);
    });
}

/** Returns true if another UAV has reached one of the target's icebergs. */
bool isSeenByOther(int uav, const FlightTarget& flightTarget, const Fleet& fleet)
{
    const auto isSeen = [&](IcebergIndex iceberg) {
        return isReachedByOther(fleet.observer(), uav, iceberg);
    };
    return isSeen(*flightTarget.target) || std::ranges::any_of(flightTarget.members, isSeen);
}

/** Returns true if any UAV flies to the iceberg. */
bool isTarget(IcebergIndex iceberg, const Fleet& fleet)
{
    return std::ranges::any_of(fleet.autopilots(),
                               [iceberg](const Autopilot& uav) { return uav.fliesTo(iceberg); });
}

bool hasTargets(const Fleet& fleet)
{
    return std::ranges::any_of(fleet.autopilots(),
                               [](const Autopilot& uav) { return uav.target().has_value(); });
}

} // namespace

PlanTrigger::PlanTrigger(std::size_t uavs, PolicyKind policy)
    : m_reasons(uavs, PlanReason::Start), m_isAlone(uavs)
{
    setPolicy(policy);
}

void PlanTrigger::setPolicy(PolicyKind policy)
{
    m_plansIdleAlone = !traitsOf(policy).keepsRoute();
}

void PlanTrigger::needAll(PlanReason reason, const Fleet& fleet)
{
    m_isAlone.assign(m_isAlone.size(), false);
    for (int uav = 0; uav < fleet.count(); ++uav)
        m_reasons[toIndex(uav)] = fleet.autopilot(uav).isPlanned() ? reason : PlanReason::None;
}

PlanReason PlanTrigger::reason() const
{
    PlanReason reason = PlanReason::None;
    for (const PlanReason own : m_reasons) {
        if (own != PlanReason::None && own != PlanReason::Fleet)
            return own;
        if (own == PlanReason::Fleet)
            reason = own;
    }
    return reason;
}

std::vector<int> PlanTrigger::plannedUavs(const Fleet& fleet) const
{
    std::vector<int> uavs;
    std::vector<int> needing;
    for (int uav = 0; uav < fleet.count(); ++uav) {
        if (!fleet.autopilot(uav).isPlanned())
            continue;
        uavs.push_back(uav);
        if (reason(uav) != PlanReason::None)
            needing.push_back(uav);
    }
    return needing.empty() ? uavs : needing;
}

bool PlanTrigger::isTargetOfUnplanned(IcebergIndex iceberg, const Fleet& fleet) const
{
    if (reason() == PlanReason::None)
        return false; // between replanning all UAVs are planned
    for (int uav = 0; uav < fleet.count(); ++uav)
        if (fleet.autopilot(uav).fliesTo(iceberg) && reason(uav) == PlanReason::None)
            return true;
    return false;
}

/**
 * UAVs are planned together: when one needs a plan, the others get one too. A UAV without a target
 * is the exception, because a plan for all whenever it finds something would turn the others round.
 */
void PlanTrigger::update(Fleet& fleet)
{
    bool needed = false;
    for (int uav = 0; uav < fleet.count(); ++uav) {
        const PlanReason reason = reasonOf(uav, fleet);
        m_reasons[toIndex(uav)] = reason;
        if (reason == PlanReason::None)
            continue; // the usual case
        const bool ofOneAlone = reason == PlanReason::OutOfView ||
                                (isAlone(uav) && (reason == PlanReason::TargetReached ||
                                                  reason == PlanReason::SeenByOther));
        if (ofOneAlone && m_plansIdleAlone && hasTargets(fleet))
            m_isAlone[toIndex(uav)] = true;
        else
            needed = true;
    }
    for (int uav = 0; needed && uav < fleet.count(); ++uav) {
        m_isAlone[toIndex(uav)] = false;
        if (reason(uav) == PlanReason::None && fleet.autopilot(uav).isPlanned())
            m_reasons[toIndex(uav)] = PlanReason::Fleet;
    }
    for (int uav = 0; fleet.plansClusters() && uav < fleet.count(); ++uav)
        if (reason(uav) == PlanReason::None && fleet.endOverdueCluster(uav))
            m_reasons[toIndex(uav)] = PlanReason::Overdue;
}

PlanReason PlanTrigger::reasonOf(int uav, Fleet& fleet) const
{
    const Autopilot& me = fleet.autopilot(uav);
    if (!me.isPlanned())
        return fleet.takeOffWhenDue(uav) ? PlanReason::TakeOff : PlanReason::None;
    if (const PlanReason trigger = fleet.report().trigger; trigger != PlanReason::None)
        return trigger;
    const FlightTarget* flightTarget = me.flightTarget();
    if (flightTarget == nullptr || !flightTarget->target) {
        if (!fleet.observer().newlyAppeared().empty())
            return PlanReason::Appeared;
        return somethingForIdle(uav, fleet) ? PlanReason::OutOfView : PlanReason::None;
    }
    if (flightTarget->aim && me.mode() != FlightMode::Search)
        return reasonOfAim(uav, fleet);
    if (targetReached(uav, *flightTarget, fleet)) {
        fleet.setReached(uav);
        return PlanReason::TargetReached;
    }
    if (!fleet.observer().newlyAppeared().empty())
        return PlanReason::Appeared;
    return isSeenByOther(uav, *flightTarget, fleet) ? PlanReason::SeenByOther : PlanReason::None;
}

PlanReason PlanTrigger::reasonOfAim(int uav, Fleet& fleet) const
{
    const FlightTarget& flightTarget = *fleet.autopilot(uav).flightTarget();
    const Observer& observer = fleet.observer();
    const bool sees = std::ranges::find(observer.newlySeen(), uav, &SeenIceberg::uav) !=
                      observer.newlySeen().end();
    const bool targetSeen = isInOwnView(observer, uav, *flightTarget.target);
    const bool isByRadius = observer.cameras().reachRadius_m().has_value();
    if ((sees || isByRadius || fleet.count() > 1) &&
        isReached(observer, uav, *flightTarget.target)) {
        fleet.setReached(uav);
        return PlanReason::TargetReached;
    }
    if (sees && !targetSeen) // otherwise it continues until the target is within the reach radius
        return PlanReason::Sighted;
    if (observer.track(*flightTarget.target).inView && !targetSeen)
        return PlanReason::SeenByOther;
    if (!observer.newlyAppeared().empty())
        return PlanReason::Appeared;
    const World& world = observer.world();
    if (flightTarget.aim->end_s) // compares to the nearest step
        return world.time_s() > *flightTarget.aim->end_s - world.dt_s() / 2 ? PlanReason::HoldFlown
                                                                            : PlanReason::None;
    return world.time_s() > flightTarget.aim->sighting_s + kOverdue_s ? PlanReason::Overdue
                                                                      : PlanReason::None;
}

/**
 * Returns true if a UAV without a target should be planned again. While other UAVs have targets, it
 * gets icebergs that none of them flies to and that have not been seen during its last circle; if
 * routes are repeated, only those assigned to it. It may always take up a search that nobody flies.
 */
bool PlanTrigger::somethingForIdle(int uav, const Fleet& fleet) const
{
    const World& world = fleet.observer().world();
    const bool isOneOfFleet = hasTargets(fleet);
    if (isOneOfFleet && !world.isWholeSecond())
        return false; // saves a planner call at each step if the planner leaves the UAV out
    if (fleet.mayBeginSearch(uav) && world.isWholeSecond())
        return true;
    // Icebergs beside its circle come into view again by themselves.
    const Autopilot& me = fleet.autopilot(uav);
    const double round_s = 2 * kPi * circleRadius_m(me.motion()) / me.motion().airspeed_mps;
    const auto isForIt = [&](IcebergIndex i) {
        if (!isOneOfFleet)
            return fleet.visitable(uav, i);
        const bool isForAny =
            m_plansIdleAlone && world.time_s() - fleet.observer().track(i).seen_s > round_s;
        return (isForAny || world.parameters(i).assignedUav == uav) && !isTarget(i, fleet) &&
               fleet.available(uav, i);
    };
    for (const IcebergIndex i : world.icebergs())
        if (isForIt(i))
            return true;
    return false;
}

} // namespace berg
