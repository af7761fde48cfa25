#pragma once

#include "core/sim/autopilot.h"
#include "core/sim/pose_tracks.h"
#include "core/sim/separation.h"

namespace berg {

/**
 * All UAVs with their shared observer. Advances them by a step, sends them to targets, searches and
 * home, and decides who may visit what. When to plan is decided elsewhere (`PlanTrigger`).
 */
class Fleet
{
public:
    /**
     * The scenario must have no errors (`validate`). `noise` is empty or the result of `drawNoise`
     * for these icebergs. Throws `std::logic_error` for noise of another scenario or without UAVs.
     */
    Fleet(const Scenario& scenario, std::span<const DriftNoise> noise);

    [[nodiscard]] const Observer& observer() const { return m_observer; }
    [[nodiscard]] Observer& observer() { return m_observer; }
    /** Returns the events since the log took them, and the plan reason of the last step. */
    [[nodiscard]] StepReport& report() { return m_report; }
    [[nodiscard]] int count() const { return static_cast<int>(m_autopilots.size()); }
    [[nodiscard]] const Autopilot& autopilot(int uav) const { return m_autopilots[toIndex(uav)]; }
    [[nodiscard]] const std::vector<Autopilot>& autopilots() const { return m_autopilots; }
    /**
     * Returns the least horizontal distance so far of two UAVs aloft in one altitude layer, m, or
     * nullopt if there was no such pair.
     */
    [[nodiscard]] const std::optional<double>& closest_m() const { return m_closest_m; }
    /**
     * Returns the icebergs that are in no cluster until they are seen, because a pass over their
     * cluster missed them.
     */
    [[nodiscard]] const IcebergList& unclustered() const { return m_unclustered; }

    /** Returns true if the iceberg would be `available` with unlimited endurance. */
    [[nodiscard]] bool visitable(int uav, IcebergIndex iceberg) const;
    /**
     * Returns true if the iceberg may be planned for the UAV: it is active, tracked, out of every
     * field of view, not assigned to another UAV, not shut off by the fence, and can be visited
     * within the endurance. With the simple observer it must also be outside the acceptance radius
     * of every UAV.
     */
    [[nodiscard]] bool available(int uav, IcebergIndex iceberg) const;
    /**
     * Returns the available iceberg with the nearest estimate, the first among equals, or nullopt
     * if none is available.
     */
    [[nodiscard]] std::optional<IcebergIndex> nearestAvailable(int uav) const;
    /** Returns true if the scenario groups nearby icebergs into clusters. */
    [[nodiscard]] bool plansClusters() const { return m_clusters; }
    /** Returns true if the iceberg is available to the UAV and may be a member of a cluster. */
    [[nodiscard]] bool clusterable(int uav, IcebergIndex iceberg) const;

    /**
     * Returns true if the UAV may search for the iceberg: it is active, not assigned to another
     * UAV, and within the endurance.
     */
    [[nodiscard]] bool maySearch(int uav, IcebergIndex iceberg) const;
    /**
     * Returns true if the UAV has no search, may begin one that was given up, and plans do not
     * search for lost icebergs now.
     */
    [[nodiscard]] bool mayBeginSearch(int uav) const
    {
        return !m_observer.searches().of(uav) && !m_observer.isLeftToPlan() &&
               hasSomethingToSearch(uav);
    }
    /**
     * Returns true if aimed plans include the likely places of lost icebergs (Kalman observer with
     * searches). Otherwise searches start and end outside the plans.
     */
    [[nodiscard]] bool searchesByPlan() const
    {
        const ObserverSpec& spec = m_observer.world().observer();
        return spec.model == ObserverModel::Kalman && spec.search != SearchPattern::None;
    }

    /** Advances one step; `poses` as for `Simulation::advanceStep`. */
    void advance(std::span<const std::optional<ExternalPose>> poses);
    /**
     * Sends the UAV to a target. With `mayContinueLeg` a UAV already on a straight leg to it
     * continues that leg. With `keepsSearch` plans continue to search for lost icebergs although
     * this target has no aim. Unless plans search, the UAV may begin, resume or give up a search.
     * Without a target and a search, a UAV of limited endurance flies home if icebergs can be
     * visited, but none in this sortie.
     */
    void setTarget(int uav, FlightTarget flightTarget, bool mayContinueLeg, bool keepsSearch);
    /** Records that the UAV has reached its target, which must exist. */
    void setReached(int uav);
    /**
     * Starts the next sortie at a whole second when the turn-around is over, no order is in force,
     * something can be visited or searched for, the pad is clear and a safe return exists. Returns
     * true if the UAV took off.
     */
    [[nodiscard]] bool takeOffWhenDue(int uav);
    /**
     * Returns true if the UAV has flown over its target cluster, or is overdue there, without
     * having all members in view. Members not reached are not where they should be, so this call
     * makes them unclustered, and they are visited one by one.
     */
    [[nodiscard]] bool endOverdueCluster(int uav);
    /**
     * Sets the wind from now on, in place of a forecast; UAVs that can no longer be home in time
     * turn home.
     */
    void setWind(const Point& wind_mps);
    /** Returns true if the crew has reported a wind, which replaces that of a forecast. */
    [[nodiscard]] bool isWindReported() const { return m_isWindReported; }
    /** Returns the wind of the flight from now on. */
    [[nodiscard]] WindAhead windAhead() const;
    /** Returns the gusts of now, or nullopt if they are unknown. */
    [[nodiscard]] std::optional<double> gust_mps() const;
    /**
     * Replaces the protected asset. A changed stand-off ring changes the fences; UAVs that can no
     * longer be home in time turn home.
     */
    void setAsset(const Asset& asset);
    /** Moves the home of the UAV; it turns home if it could no longer be there in time. */
    void setHome(int uav, const Point& home_m);
    /** Gives the UAV an operator's order. */
    void order(int uav, FlightOrder order);

private:
    [[nodiscard]] bool affordable(int uav, IcebergIndex iceberg) const;
    [[nodiscard]] bool hasSomethingToSearch(int uav) const;
    [[nodiscard]] bool isSearchedByPlan() const;
    void beginOrEndSearch(int uav);
    void searchAgain(int uav);
    void leaveSearch(int uav);
    void sendHome(int uav);
    void noteHomeward(int uav);
    void sendHomeWhenLate(int uav);
    void enterLayer(int uav);
    void takeSlot(int uav);
    void enforceSeparation(int uav);
    void watchSeparation();
    void followWind(double time_s);

    bool m_clusters;
    double m_separation_m;
    /** Fence data of the scenario, as `fenceOf` needs it. Recorded copies of the fleet share it. */
    std::shared_ptr<const Scenario> m_bounds;
    Observer m_observer;
    bool m_isWindReported = false; ///< true if the crew's wind replaces the forecast
    std::int64_t m_windStep = 0;   ///< step of `FlightWeather` whose wind blows
    std::vector<Autopilot> m_autopilots;
    std::vector<std::vector<int>> m_padMates; ///< by UAV: others that use the same pad
    Separation m_separation;
    StepReport m_report;
    /** Icebergs that a pass over their cluster missed; in no cluster until seen. */
    IcebergList m_unclustered;
    std::optional<double> m_closest_m;
};

} // namespace berg
