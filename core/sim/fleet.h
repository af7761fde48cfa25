#pragma once

#include "core/sim/autopilot.h"
#include "core/sim/separation.h"

namespace berg {

/**
 * The UAVs and what they know: flies them a step, sends them to icebergs, to searches and home, and
 * knows who may visit what. Says nothing about when that is to be planned.
 */
class Fleet
{
public:
    Fleet(const Scenario& scenario, std::span<const DriftNoise> noise);

    [[nodiscard]] const Observer& observer() const { return m_observer; }
    [[nodiscard]] Observer& observer() { return m_observer; }
    [[nodiscard]] StepReport& report() { return m_report; }
    [[nodiscard]] int count() const { return static_cast<int>(m_autopilots.size()); }
    [[nodiscard]] const Autopilot& autopilot(int uav) const { return m_autopilots[toIndex(uav)]; }
    [[nodiscard]] const std::vector<Autopilot>& autopilots() const { return m_autopilots; }
    [[nodiscard]] const std::optional<double>& closest_m() const { return m_closest_m; }
    [[nodiscard]] const std::vector<int>& unclustered() const { return m_unclustered; }

    /** As `available`, whether or not the endurance allows it. */
    [[nodiscard]] bool visitable(int uav, int iceberg) const;
    /** Whether it may be planned for the UAV: active, not lost, in no field of view, not within
     * reach, not kept for another one, and within its endurance. */
    [[nodiscard]] bool available(int uav, int iceberg) const;
    /** By its estimate; the first one among equals, -1: none is available. */
    [[nodiscard]] int nearestAvailable(int uav) const;
    /** Whether the scenario asks for clusters. */
    [[nodiscard]] bool plansClusters() const { return m_clusters; }
    /** Whether it may be planned for the UAV as one of a cluster. */
    [[nodiscard]] bool clusterable(int uav, int iceberg) const;

    /** Whether it may be sent to search for it at all. */
    [[nodiscard]] bool maySearch(int uav, int iceberg) const;
    /** Whether it has no search and may begin one: no plan searches for what is given up. */
    [[nodiscard]] bool mayBeginSearch(int uav) const
    {
        return !m_observer.searches().of(uav) && !m_observer.isLeftToPlan() &&
               hasSomethingToSearch(uav);
    }
    /** Whether plans with aim points have the places of lost icebergs among those they order; else
     * searches are begun and ended between plan and UAV. Where looks tell less than all. */
    [[nodiscard]] bool searchesByPlan() const
    {
        const ObserverSpec& spec = m_observer.world().observer();
        return spec.model == ObserverModel::Kalman && spec.search != SearchPattern::None;
    }

    /** One step: `poses` as for `Simulation::advanceStep`. */
    void advance(std::span<const DubinsState> poses);
    /** `mayGoOn`: a UAV that is on a leg to it already flies on. `keepsSearch`: what is
     * searched for by plan stays so, although this target has no aim. */
    void setTarget(int uav, Errand errand, bool mayGoOn, bool keepsSearch);
    void setReached(int uav);
    /** After the turn-around, as soon as there is something to fly to. */
    [[nodiscard]] bool takeOffWhenDue(int uav);
    /** Whether its cluster has been flown over, or should have been by now, with members that did
     * not come into view: those are not where they should be, and flown to one by one. */
    [[nodiscard]] bool endOverdueCluster(int uav);
    void setWind(const Point& wind_mps);
    void setAsset(const Asset& asset);
    void order(int uav, FlightOrder order);

private:
    [[nodiscard]] bool affordable(int uav, int iceberg) const;
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
    void keepApart(int uav);
    void watchSeparation();

    bool m_clusters;
    double m_separation_m;
    /** Of the scenario what `fenceOf` asks for; shared by the copies that are put on record. */
    std::shared_ptr<const Scenario> m_bounds;
    Observer m_observer;
    std::vector<Autopilot> m_autopilots;
    std::vector<std::vector<int>> m_padMates; ///< by UAV
    Separation m_separation;
    StepReport m_report;
    std::vector<int> m_unclustered; ///< in no cluster until seen: one was passed without them
    std::optional<double> m_closest_m;
};

} // namespace berg
