#pragma once

#include "core/sim/fleet.h"

namespace berg {

/** Why a plan is needed, by UAV, and for whom it is made. */
class PlanTrigger
{
public:
    PlanTrigger(std::size_t uavs, PolicyKind policy);

    /** Of the first UAV that has a reason of its own; None: fly on. */
    [[nodiscard]] PlanReason reason() const;
    /** Of this UAV; `Fleet`: because another one needs one. */
    [[nodiscard]] PlanReason reason(int uav) const { return m_reasons[toIndex(uav)]; }
    /** Planned by itself until all are planned again. */
    [[nodiscard]] bool isAlone(int uav) const { return m_isAlone[toIndex(uav)]; }
    /** UAVs that plans are made for now: not on the way home or on the ground; of those, when one
     * without a target is to be planned alone, that one. */
    [[nodiscard]] std::vector<int> plannedUavs(const Fleet& fleet) const;
    /** Target of a UAV that is not planned now. */
    [[nodiscard]] bool isTargetOfUnplanned(int iceberg, const Fleet& fleet) const;

    /** From now on plans are this policy's: routes that are repeated are planned for all at once.
     */
    void setPolicy(PolicyKind policy);
    /** All that are not homeward need a plan. */
    void needAll(PlanReason reason, const Fleet& fleet);
    /** The UAV has its plan, or is sent home. */
    void answer(int uav) { m_reasons[toIndex(uav)] = PlanReason::None; }
    /** At the end of a step; UAVs may take off. */
    void update(Fleet& fleet);

private:
    [[nodiscard]] PlanReason reasonOf(int uav, Fleet& fleet) const;
    [[nodiscard]] PlanReason reasonOfAim(int uav, Fleet& fleet) const;
    [[nodiscard]] bool somethingForIdle(int uav, const Fleet& fleet) const;

    bool m_plansIdleAlone = false; ///< as the policy allows
    std::vector<PlanReason> m_reasons;
    std::vector<bool> m_isAlone;
};

} // namespace berg
