#include "core/sim/plan_trigger.h"

#include "core/base/angles.h"

#include <algorithm>

namespace berg {

namespace {

/** A sighting later than predicted by this is overdue. */
constexpr double kOverdue_s = 2;

bool targetReached(int uav, const Errand& errand, const Fleet& fleet)
{
    if (errand.members.empty())
        return isReached(fleet.observer(), uav, errand.target);
    return std::ranges::all_of(
        errand.members, [&](int member) { return isReached(fleet.observer(), uav, member); });
}

/** Whether another UAV has come to one of those it is sent to. */
bool isSeenByOther(int uav, const Errand& errand, const Fleet& fleet)
{
    const auto isSeen = [&](int iceberg) {
        return isReachedByOther(fleet.observer(), uav, iceberg);
    };
    return isSeen(errand.target) || std::ranges::any_of(errand.members, isSeen);
}

/** Whether one of the UAVs is sent to it. */
bool isTarget(int iceberg, const Fleet& fleet)
{
    return std::ranges::any_of(fleet.autopilots(),
                               [iceberg](const Autopilot& uav) { return uav.fliesTo(iceberg); });
}

bool hasTargets(const Fleet& fleet)
{
    return std::ranges::any_of(fleet.autopilots(),
                               [](const Autopilot& uav) { return uav.target() >= 0; });
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

bool PlanTrigger::isTargetOfUnplanned(int iceberg, const Fleet& fleet) const
{
    if (reason() == PlanReason::None)
        return false; // asked about in between, all of them are planned
    for (int uav = 0; uav < fleet.count(); ++uav)
        if (fleet.autopilot(uav).fliesTo(iceberg) && reason(uav) == PlanReason::None)
            return true;
    return false;
}

/**
 * All UAVs are planned together: where one needs a plan the others get one too. But for one without
 * a target: whenever it finds something, a new plan for all would turn the others round too.
 */
void PlanTrigger::update(Fleet& fleet)
{
    bool needed = false;
    for (int uav = 0; uav < fleet.count(); ++uav) {
        const PlanReason reason = reasonOf(uav, fleet);
        m_reasons[toIndex(uav)] = reason;
        if (reason == PlanReason::None)
            continue; // as in nearly every step
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
    const Errand* errand = me.errand();
    if (errand == nullptr || errand->target < 0) {
        if (!fleet.observer().newlyAppeared().empty())
            return PlanReason::Appeared;
        return somethingForIdle(uav, fleet) ? PlanReason::OutOfView : PlanReason::None;
    }
    if (errand->aim && me.mode() != FlightMode::Search)
        return reasonOfAim(uav, fleet);
    if (targetReached(uav, *errand, fleet)) {
        fleet.setReached(uav);
        return PlanReason::TargetReached;
    }
    if (!fleet.observer().newlyAppeared().empty())
        return PlanReason::Appeared;
    return isSeenByOther(uav, *errand, fleet) ? PlanReason::SeenByOther : PlanReason::None;
}

PlanReason PlanTrigger::reasonOfAim(int uav, Fleet& fleet) const
{
    const Errand& errand = *fleet.autopilot(uav).errand();
    const Observer& observer = fleet.observer();
    const bool sees = std::ranges::find(observer.newlySeen(), uav, &SeenIceberg::uav) !=
                      observer.newlySeen().end();
    const bool targetSeen = isInOwnView(observer, uav, errand.target);
    const bool isByRadius = observer.cameras().reachRadius_m().has_value();
    if ((sees || isByRadius || fleet.count() > 1) && isReached(observer, uav, errand.target)) {
        fleet.setReached(uav);
        return PlanReason::TargetReached;
    }
    if (sees && !targetSeen) // else it flies on until that is within the reach radius
        return PlanReason::Sighted;
    if (observer.track(errand.target).inView && !targetSeen)
        return PlanReason::SeenByOther;
    if (!observer.newlyAppeared().empty())
        return PlanReason::Appeared;
    const World& world = observer.world();
    if (errand.aim->end_s) // at the step next to it
        return world.time_s() > *errand.aim->end_s - world.dt_s() / 2 ? PlanReason::HoldFlown
                                                                      : PlanReason::None;
    return world.time_s() > errand.aim->sighting_s + kOverdue_s ? PlanReason::Overdue
                                                                : PlanReason::None;
}

/**
 * Whether a UAV without a target should be planned again. While others of the fleet fly to targets
 * it has what none of them flies to and it has not seen on the last round of its circle; where
 * routes are repeated, only what is kept for it. Either way it may search for what nobody does.
 */
bool PlanTrigger::somethingForIdle(int uav, const Fleet& fleet) const
{
    const World& world = fleet.observer().world();
    const bool isOneOfFleet = hasTargets(fleet);
    if (isOneOfFleet && !world.isWholeSecond())
        return false; // a planner that leaves it out is not asked at each step
    if (fleet.mayBeginSearch(uav) && world.isWholeSecond())
        return true;
    // What is beside its circle comes into view again.
    const Autopilot& me = fleet.autopilot(uav);
    const double round_s = 2 * kPi * circleRadius_m(me.motion()) / me.motion().airspeed_mps;
    const auto isForIt = [&](int i) {
        if (!isOneOfFleet)
            return fleet.visitable(uav, i);
        const bool isForAny =
            m_plansIdleAlone && world.time_s() - fleet.observer().track(i).seen_s > round_s;
        return (isForAny || world.body(i).assignedUav == uav) && !isTarget(i, fleet) &&
               fleet.available(uav, i);
    };
    for (int i = 0; i < world.icebergCount(); ++i)
        if (isForIt(i))
            return true;
    return false;
}

} // namespace berg
