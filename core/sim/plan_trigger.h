#pragma once

#include "core/sim/fleet.h"

namespace berg {

/** Records for each UAV why it needs a plan, and decides which UAVs are planned together. */
class PlanTrigger
{
public:
    /** At the start every UAV needs a plan. */
    PlanTrigger(std::size_t uavs, PolicyKind policy);

    /**
     * Returns the reason of the first UAV with a reason of its own, `Fleet` if others only follow,
     * or None if no plan is needed.
     */
    [[nodiscard]] PlanReason reason() const;
    /** Returns the reason of this UAV; `Fleet` means that another UAV needs a plan. */
    [[nodiscard]] PlanReason reason(int uav) const { return m_reasons[toIndex(uav)]; }
    /**
     * Returns true while the UAV is planned separately, which lasts until the next plan for all.
     */
    [[nodiscard]] bool isAlone(int uav) const { return m_isAlone[toIndex(uav)]; }
    /**
     * Returns the UAVs to plan now: those that need a plan, or every one for which plans are made
     * if none needs one. UAVs that fly home, hold or are on the ground are never among them.
     */
    [[nodiscard]] std::vector<int> plannedUavs(const Fleet& fleet) const;
    /** Returns true if the iceberg is the target of a UAV that the plan now due leaves out. */
    [[nodiscard]] bool isTargetOfUnplanned(IcebergIndex iceberg, const Fleet& fleet) const;

    /**
     * Sets the policy of plans from now on. Policies that repeat a fixed route are planned for all
     * UAVs at once.
     */
    void setPolicy(PolicyKind policy);
    /** Requests a plan for every UAV for which plans are made. */
    void needAll(PlanReason reason, const Fleet& fleet);
    /** Marks the UAV's request as answered. */
    void answer(int uav) { m_reasons[toIndex(uav)] = PlanReason::None; }
    /** Finds the reasons for plans at the end of a step. UAVs may take off. */
    void update(Fleet& fleet);

private:
    [[nodiscard]] PlanReason reasonOf(int uav, Fleet& fleet) const;
    [[nodiscard]] PlanReason reasonOfAim(int uav, Fleet& fleet) const;
    [[nodiscard]] bool somethingForIdle(int uav, const Fleet& fleet) const;

    /** Whether the policy allows a UAV without a target to be planned separately. */
    bool m_plansIdleAlone = false;
    std::vector<PlanReason> m_reasons;
    std::vector<bool> m_isAlone;
};

} // namespace berg
