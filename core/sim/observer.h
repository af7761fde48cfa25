#pragma once

#include "core/scenario/priority.h"
#include "core/sim/cameras.h"
#include "core/sim/searches.h"
#include "core/sim/step_report.h"
#include "core/sim/world.h"

#include <functional>

namespace berg {

/**
 * What is known of the world, and how that comes about: the cameras look at the truth, the tracks
 * take it up, what is not where it should be is lost, searched for and found. The only one that
 * sees the truth.
 */
class Observer
{
public:
    /** `noise` is empty or what `drawNoise` gave. Looks at once; what it sees then is no news. */
    Observer(const Scenario& scenario, std::span<const DriftNoise> noise);

    [[nodiscard]] const World& world() const { return m_world; }
    [[nodiscard]] World& world() { return m_world; }
    [[nodiscard]] const Cameras& cameras() const { return m_cameras; }
    [[nodiscard]] Cameras& cameras() { return m_cameras; }
    [[nodiscard]] const Searches& searches() const { return m_searches; }
    [[nodiscard]] Searches& searches() { return m_searches; }

    [[nodiscard]] const std::vector<Track>& tracks() const { return m_tracks; }
    [[nodiscard]] const Track& track(int iceberg) const { return m_tracks[toIndex(iceberg)]; }
    [[nodiscard]] Point estimate_m(int iceberg) const
    {
        return track(iceberg).estimate_m(m_world.time_s());
    }
    /** Whether the iceberg is monitored: it has appeared and has not left the area. */
    [[nodiscard]] bool active(int iceberg) const
    {
        return m_world.age(iceberg) >= 0 && !track(iceberg).left;
    }
    [[nodiscard]] double sigmaSum_m2() const { return m_sigmaSum_m2; }

    /** Icebergs that came into view in the last step, by index, ascending. */
    [[nodiscard]] std::span<const SeenIceberg> newlySeen() const { return m_newlySeen; }
    /** Icebergs that appeared in the last step. */
    [[nodiscard]] std::span<const int> newlyAppeared() const { return m_newlyAppeared; }

    /** After the UAVs have moved for `dt_s`. */
    void observe(double dt_s, StepReport& report);
    /** From now on. */
    void setWind(const Point& wind_mps);

    /** Appears now; its index is the new last one. */
    void addIceberg(const Iceberg& iceberg);
    /** It has left, for good: nothing is seen or learnt of it any more. */
    void removeIceberg(int iceberg);
    /**
     * Somebody else saw it `age_s` ago: its position is known as if it had been in view then and
     * the uncertainty had grown since; what is known better already stays.
     */
    void reportSighting(int iceberg, double age_s, StepReport& report);

    /** Of an iceberg that is lost or given up. */
    void beginSearch(int uav, Search search);
    /** What it searches for, and what has been given up, is lost, and looked for where the plan
     * leads. */
    void leaveToPlan(int uav);
    [[nodiscard]] bool isLeftToPlan() const { return m_isLeftToPlan; }
    /** No plan searches any more: what was left to it is given up. */
    void takeFromPlan(int uav, StepReport& report);
    /** For now: every new plan compares again. */
    void giveUp(Search search, int uav, StepReport& report);

private:
    void insert(const Iceberg& iceberg, DriftNoise noise, double start_s, std::int64_t appearsStep);
    void lookAround(StepReport& report);
    void look(int iceberg, StepReport& report);
    /** Of a position seen by a camera, along one axis. */
    [[nodiscard]] double lookVariance_m2() const;
    void lookForMeasurements(double dt_s, StepReport& report);
    void measure(int iceberg, const Point& measured_m, double variance_m2, int seenBy,
                 StepReport& report);
    void miss(int iceberg, std::span<const FieldOfView> views, std::span<const FieldOfView> middles,
              StepReport& report);
    void watchEstimates(StepReport& report);
    void lose(int iceberg, int uav, std::span<const FieldOfView> views, StepReport& report);
    void noteGivenUp(int iceberg, int uav, StepReport& report);
    void found(int iceberg, int seenBy, StepReport& report);
    void watchArea(StepReport& report);

    World m_world;
    Cameras m_cameras;
    Searches m_searches;
    bool m_isLeftToPlan = false; ///< what is lost is looked for where plans lead
    std::vector<Point> m_area_m; ///< empty: unbounded
    std::int64_t m_lookSteps;    ///< between two looks of the camera, with measurements
    std::vector<Track> m_tracks;
    std::vector<std::int64_t> m_lookStep; ///< before this step it is surely out of view
    std::int64_t m_nextLookStep = 0;      ///< first of them
    double m_sigmaSum_m2 = 0;
    std::vector<SeenIceberg> m_newlySeen;
    std::vector<int> m_newlyAppeared;
};

/** Of those that count the one with the nearest estimate, the first among equals; -1: none. */
[[nodiscard]] int nearest(const Observer& observer, const Point& from_m,
                          const std::function<bool(int)>& counts);
/** Of the smallest circle round their estimates. */
[[nodiscard]] Point middle_m(const Observer& observer, std::span<const int> icebergs);

/** What multiplies its sigma in planning: above 1 where an asset is near. */
[[nodiscard]] double priority(const Observer& observer, int iceberg);
/** Seen from the asset, by the estimate; none without an asset. */
[[nodiscard]] std::optional<RelativeMotion> relativeToAsset(const Observer& observer, int iceberg);

/** In view of this UAV: of several, others may have it in view. */
[[nodiscard]] bool isInOwnView(const Observer& observer, int uav, int iceberg);
/** In its own view; with a reach radius, within that: by the truth in the simple model, else by the
 * estimate of what the last look has shown. */
[[nodiscard]] bool isReached(const Observer& observer, int uav, int iceberg);
/** The same of any UAV, for one that is in no view. */
[[nodiscard]] bool isReachedUnseen(const Observer& observer, int iceberg);
[[nodiscard]] bool isReachedByOther(const Observer& observer, int uav, int iceberg);

} // namespace berg
