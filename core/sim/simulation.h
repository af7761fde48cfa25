#pragma once

#include "core/sim/plan_trigger.h"

namespace berg {

/**
 * One deterministic world: icebergs, estimates, UAVs and autopilots advance with a fixed time step.
 * It contains no planner: `planReason` reports when a plan is needed, and `setTarget` sets the next
 * target of each UAV. The order of one step is guidance, Dubins step, true drift, field of view and
 * sigma (22)-(23), zeta (24). UAVs are numbered as in the scenario; an iceberg is in view if it is
 * in the view of any UAV. Not thread-safe. Copyable, so any instant can be stored and continued.
 *
 * Composed of `Fleet` (with its `Observer`, which alone reads the `World`, and an `Autopilot` for
 * each UAV) and `PlanTrigger`.
 */
class Simulation
{
public:
    /**
     * The scenario must have no errors (`validate`). At time 0 the field of view is tested and a
     * plan is needed. `noise` is empty or the result of `drawNoise` for these icebergs and only
     * saves time. Throws `std::logic_error` as `Fleet` does.
     */
    explicit Simulation(const Scenario& scenario, std::span<const DriftNoise> noise = {});

    [[nodiscard]] const Fleet& fleet() const { return m_fleet; }
    [[nodiscard]] const Observer& observer() const { return m_fleet.observer(); }
    [[nodiscard]] const World& world() const { return observer().world(); }
    [[nodiscard]] const PlanTrigger& trigger() const { return m_trigger; }

    [[nodiscard]] double time_s() const { return world().time_s(); }
    [[nodiscard]] std::int64_t step() const { return world().step(); }
    [[nodiscard]] bool finished() const { return step() >= world().lastStep(); }
    /** Returns the recorded state, built at each call. */
    [[nodiscard]] WorldState state() const;
    /** Returns the uncertainty summed over time so far, Eq. (24), m^2 s. */
    [[nodiscard]] double zeta_m2s() const { return m_zeta_m2s; }

    [[nodiscard]] int icebergCount() const { return world().icebergCount(); }
    /** Returns all icebergs, with those that have yet to appear or have left. */
    [[nodiscard]] IcebergRange icebergs() const { return world().icebergs(); }
    /** Returns true if the iceberg is monitored: it has appeared and has not left the area. */
    [[nodiscard]] bool active(IcebergIndex iceberg) const { return observer().active(iceberg); }
    /** Returns true if the iceberg may be planned for the UAV: `Fleet::available`. */
    [[nodiscard]] bool available(int uav, IcebergIndex iceberg) const
    {
        return m_fleet.available(uav, iceberg);
    }
    /** Returns the true position now, or at its start before the iceberg has appeared, m. */
    [[nodiscard]] Point truth_m(IcebergIndex iceberg) const { return world().truth_m(iceberg); }
    [[nodiscard]] const Track& track(IcebergIndex iceberg) const
    {
        return observer().track(iceberg);
    }

    [[nodiscard]] int uavCount() const { return m_fleet.count(); }
    /** Returns the recorded state of one UAV, as `state` does. */
    [[nodiscard]] UavState uav(int uav) const;
    [[nodiscard]] const Motion& motion(int uav) const { return m_fleet.autopilot(uav).motion(); }

    /**
     * Returns why a plan is needed now: the reason of the first UAV with a reason of its own,
     * `Fleet` if others only follow, or None if no plan is needed.
     */
    [[nodiscard]] PlanReason planReason() const { return m_trigger.reason(); }
    /** Returns why this UAV needs a plan; `Fleet` means that another UAV does. */
    [[nodiscard]] PlanReason planReason(int uav) const { return m_trigger.reason(uav); }
    /**
     * Sends the UAV to an iceberg from its present position; nullopt makes it circle the last
     * iceberg reached. With `aim` it flies that leg until something comes into view. With `members`
     * of a cluster, which contains the iceberg, it flies to the middle of the circle around their
     * estimates and has reached it when all of them are reached at once. For `keepsSearch` see
     * `startFlying`.
     */
    void setTarget(int uav, std::optional<IcebergIndex> iceberg,
                   const std::optional<AimedLeg>& aim = std::nullopt,
                   std::span<const IcebergIndex> members = {}, bool keepsSearch = false);

    /**
     * Advances one time step. Must not be called while a plan is needed or after the end. `poses`
     * is empty or has an entry for each UAV: its pose at the end of the step, as telemetry reports
     * it, or nullopt for the Dubins model; a UAV on the ground stays where it is. Throws
     * `std::logic_error` if one of these conditions is violated.
     */
    void advanceStep(std::span<const std::optional<ExternalPose>> poses = {});

    /** Sets the wind from now on, in place of a forecast, and requests a plan. */
    void setWind(const Point& wind_mps);
    /** Returns the wind of the flight from now on. */
    [[nodiscard]] WindAhead windAhead() const { return m_fleet.windAhead(); }
    /** Sets the protected asset from now on and requests a plan. */
    void setAsset(const Asset& asset);
    /**
     * Moves the home of the UAV. The present plan stays in force: the next one counts with the new
     * home, and the UAV turns home as soon as the return needs it. Throws `std::logic_error` if
     * there is no such UAV.
     */
    void setHome(int uav, const Point& home_m);
    /** Requests a plan now, after a change from outside (tau, policy). */
    void requestPlan() { m_trigger.needAll(PlanReason::Intervention, m_fleet); }
    /** Sets the policy of plans from now on. */
    void setPolicy(PolicyKind policy) { m_trigger.setPolicy(policy); }
    /**
     * Assigns the iceberg to this UAV alone, or to every UAV if `uav` is nullopt, and requests a
     * plan.
     * Throws `std::logic_error` if an index does not exist.
     */
    void assign(IcebergIndex iceberg, std::optional<int> uav);
    /**
     * Gives the UAV an operator's order and requests a plan. `FlightOrder::None` returns it to its
     * plan. Throws `std::logic_error` if there is no such UAV.
     */
    void order(int uav, FlightOrder order);
    /**
     * Takes up a sighting of the iceberg by somebody else `age_s` seconds ago and requests a plan:
     * the position is known as if it had been in view then. Throws `std::logic_error` unless the
     * iceberg is active and `age_s` is at least 0.
     */
    void reportSighting(IcebergIndex iceberg, double age_s = 0);
    /** Adds an iceberg that appears now; its index is the new last one. */
    void addIceberg(const Iceberg& iceberg);
    /** Stops monitoring the iceberg and requests a plan. */
    void removeIceberg(IcebergIndex iceberg);

    /**
     * Returns and clears the events since the last call, without times. Does not affect the flight.
     */
    [[nodiscard]] std::vector<MissionEvent> drainEvents()
    {
        return std::exchange(m_fleet.report().events, {});
    }

private:
    Fleet m_fleet;
    PlanTrigger m_trigger;
    double m_zeta_m2s = 0; ///< Eq. (24)
};

} // namespace berg
