#pragma once

#include "core/sim/plan_trigger.h"

namespace berg {

/**
 * One deterministic world: icebergs, estimates, UAVs and autopilots advanced with a fixed time
 * step. It holds no planner: it says when a plan is needed (`planReason`) and is told the next
 * target of each UAV. One step, in this order: guidance, Dubins step, true drift, field of view and
 * sigma (22)-(23), zeta (24). UAVs are numbered as in the scenario; an iceberg is in view when it
 * is in that of one of them. Not thread-safe; copyable, so that any instant can be kept and
 * continued.
 *
 * Put together of `Fleet` (with its `Observer`, the only one to see the `World`, and an `Autopilot`
 * for each UAV) and `PlanTrigger`.
 */
class Simulation
{
public:
    /**
     * The scenario must have no errors (`validate`). Time 0: field of view tested, plan needed.
     * `noise` is empty or what `drawNoise` gave; it only saves time.
     */
    explicit Simulation(const Scenario& scenario, std::span<const DriftNoise> noise = {});

    [[nodiscard]] const Fleet& fleet() const { return m_fleet; }
    [[nodiscard]] const Observer& observer() const { return m_fleet.observer(); }
    [[nodiscard]] const World& world() const { return observer().world(); }
    [[nodiscard]] const PlanTrigger& trigger() const { return m_trigger; }

    [[nodiscard]] double time_s() const { return world().time_s(); }
    [[nodiscard]] std::int64_t step() const { return world().step(); }
    [[nodiscard]] bool finished() const { return step() >= world().lastStep(); }
    /** To be put on record, made anew at each call. */
    [[nodiscard]] WorldState state() const;
    [[nodiscard]] double zeta_m2s() const { return m_zeta_m2s; }

    [[nodiscard]] int icebergCount() const { return world().icebergCount(); }
    /** Whether the iceberg is monitored: it has appeared and has not left the area. */
    [[nodiscard]] bool active(int iceberg) const { return observer().active(iceberg); }
    /** Whether it may be planned for the UAV: `Fleet::available`. */
    [[nodiscard]] bool available(int uav, int iceberg) const
    {
        return m_fleet.available(uav, iceberg);
    }
    /** True position; before it has appeared, that at its start. */
    [[nodiscard]] Point truth_m(int iceberg) const { return world().truth_m(iceberg); }
    [[nodiscard]] const Track& track(int iceberg) const { return observer().track(iceberg); }

    [[nodiscard]] int uavCount() const { return m_fleet.count(); }
    /** As `state` has it. */
    [[nodiscard]] UavState uav(int uav) const;
    [[nodiscard]] const Motion& motion(int uav) const { return m_fleet.autopilot(uav).motion(); }

    /** Why a plan is needed now, of the first UAV that has a reason of its own; None: fly on. */
    [[nodiscard]] PlanReason planReason() const { return m_trigger.reason(); }
    /** Why the UAV needs one; `Fleet`: because another one does. */
    [[nodiscard]] PlanReason planReason(int uav) const { return m_trigger.reason(uav); }
    /**
     * The UAV is to fly to this iceberg from here; -1: none available, circle the last one reached.
     * With an aim: along it until something comes into view. With members of a cluster, the iceberg
     * one of them: to the middle of the circle round their estimates, reached when all of them are
     * at once. `keepsSearch`: see `keepsSearch(PlanEvent)`.
     */
    void setTarget(int uav, int iceberg, const std::optional<AimedLeg>& aim = std::nullopt,
                   std::span<const int> members = {}, bool keepsSearch = false);

    /**
     * Advances one dt. Must not be called while a plan is needed or when finished. `poses`: where
     * the UAVs are at its end, by UAV, as telemetry has it; none: where the Dubins model takes
     * them.
     */
    void advanceStep(std::span<const DubinsState> poses = {});

    /** The wind is this from now on, and a new plan is needed. */
    void setWind(const Point& wind_mps);
    /** What is to be protected from now on; a new plan is needed. */
    void setAsset(const Asset& asset);
    /** Something changed from outside (tau, policy): a new plan is needed now. */
    void requestPlan() { m_trigger.needAll(PlanReason::Intervention, m_fleet); }
    /** From now on plans are this policy's. */
    void setPolicy(PolicyKind policy) { m_trigger.setPolicy(policy); }
    /** The iceberg is to be visited by this UAV alone, -1: by any; a new plan is needed. */
    void assign(int iceberg, int uav);
    /** The UAV does so, and the others get a new plan; `FlightOrder::None`: as planned again. */
    void order(int uav, FlightOrder order);
    /**
     * An iceberg that has appeared was seen by somebody else `age_s` ago: its position is known as
     * if it had been in view then, and a new plan is needed.
     */
    void reportSighting(int iceberg, double age_s = 0);
    /** Adds an iceberg that appears now; its index is the new last one. */
    void addIceberg(const Iceberg& iceberg);
    /** It is monitored no more; a new plan is needed. */
    void removeIceberg(int iceberg);

    /** What else happened since this was asked last, without times; asking changes nothing about
     * the flight. */
    [[nodiscard]] std::vector<MissionEvent> acceptEvents()
    {
        return std::exchange(m_fleet.report().events, {});
    }

private:
    Fleet m_fleet;
    PlanTrigger m_trigger;
    double m_zeta_m2s = 0; ///< Eq. (24)
};

} // namespace berg
