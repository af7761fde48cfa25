#pragma once

#include "core/scenario/priority.h"
#include "core/world/cameras.h"
#include "core/world/searches.h"
#include "core/world/step_report.h"
#include "core/world/world.h"

#include <functional>

namespace berg {

/**
 * Knowledge of the world and how it is gained: cameras sample the true positions, tracks are
 * updated, and an iceberg that is not found where it should be is lost, searched for and found.
 * This class alone reads the true positions.
 */
class Observer
{
public:
    /**
     * Observes once at the start without reporting sightings as events. `noise` is empty or the
     * result of `drawNoise` for these icebergs; throws `std::logic_error` for other noise.
     */
    Observer(const Scenario& scenario, std::span<const DriftNoise> noise);

    [[nodiscard]] const World& world() const { return m_world; }
    [[nodiscard]] World& world() { return m_world; }
    [[nodiscard]] const Cameras& cameras() const { return m_cameras; }
    [[nodiscard]] Cameras& cameras() { return m_cameras; }
    [[nodiscard]] const Searches& searches() const { return m_searches; }
    [[nodiscard]] Searches& searches() { return m_searches; }

    [[nodiscard]] const std::vector<Track>& tracks() const { return m_tracks; }
    [[nodiscard]] const Track& track(IcebergIndex iceberg) const
    {
        return m_tracks[toIndex(iceberg)];
    }
    [[nodiscard]] Point estimate_m(IcebergIndex iceberg) const
    {
        return track(iceberg).estimate_m(m_world.time_s());
    }
    /** Returns true if the iceberg is monitored: it has appeared and has not left the area. */
    [[nodiscard]] bool active(IcebergIndex iceberg) const
    {
        return m_world.age(iceberg) >= 0 && !track(iceberg).left;
    }
    /** Returns the sum of sigma over the active icebergs after the last step, m^2. */
    [[nodiscard]] double sigmaSum_m2() const { return m_sigmaSum_m2; }

    /** Returns the icebergs that came into view in the last step, ascending by index. */
    [[nodiscard]] std::span<const SeenIceberg> newlySeen() const { return m_newlySeen; }
    /** Returns the icebergs that appeared, or came back into the area, in the last step. */
    [[nodiscard]] std::span<const IcebergIndex> newlyAppeared() const { return m_newlyAppeared; }

    /**
     * Updates all tracks after the UAVs have moved for `dt_s` seconds, and reports what happened.
     */
    void observe(double dt_s, StepReport& report);
    /** Sets the wind from now on; with a forecast it had been the strongest to come. */
    void setWind(const Point& wind_mps);

    /** Adds an iceberg that appears now with the next index. */
    void addIceberg(const Iceberg& iceberg);
    /** Stops monitoring the iceberg for good. */
    void removeIceberg(IcebergIndex iceberg);
    /**
     * Takes up a sighting by somebody else `age_s` seconds ago: the position is known as if it had
     * been in view then and the uncertainty had grown since. A better estimate stays. Throws
     * `std::logic_error` unless the iceberg is active and `age_s` is at least 0.
     */
    void reportSighting(IcebergIndex iceberg, double age_s, StepReport& report);

    /** Starts a search by the UAV for an iceberg, which becomes lost; its other searches end. */
    void beginSearch(int uav, Search search);
    /**
     * Leaves all searches to the plans: ends the UAV's own search and marks icebergs given up as
     * lost again.
     */
    void leaveToPlan(int uav);
    /** Returns true while plans search for lost icebergs. */
    [[nodiscard]] bool isLeftToPlan() const { return m_isLeftToPlan; }
    /**
     * Ends the search by plans: icebergs left to them are given up, which is reported as events of
     * UAV `uav`. Does nothing if plans do not search.
     */
    void takeFromPlan(int uav, StepReport& report);
    /** Gives up a search for now, reported as an event of `uav`. Each new plan considers it again.
     */
    void giveUp(Search search, int uav, StepReport& report);

private:
    IcebergIndex insert(const Iceberg& iceberg, DriftNoise noise, double start_s,
                        std::int64_t appearsStep);
    void sampleAllInReach(StepReport& report);
    void sampleIceberg(IcebergIndex iceberg, StepReport& report);
    /** Variance of a measured position along one axis, m^2. */
    [[nodiscard]] double measurementVariance_m2() const;
    void sampleMeasurements(double dt_s, StepReport& report);
    void measure(IcebergIndex iceberg, const Point& measured_m, double variance_m2,
                 std::optional<int> seenBy, StepReport& report);
    void miss(IcebergIndex iceberg, std::span<const FieldOfView> views,
              std::span<const FieldOfView> middles, StepReport& report);
    void watchEstimates(StepReport& report);
    void lose(IcebergIndex iceberg, int uav, std::span<const FieldOfView> views,
              StepReport& report);
    void noteGivenUp(IcebergIndex iceberg, int uav, StepReport& report);
    void found(IcebergIndex iceberg, std::optional<int> seenBy, StepReport& report);
    void watchArea(StepReport& report);
    void followForcing();

    World m_world;
    Cameras m_cameras;
    Searches m_searches;
    bool m_isLeftToPlan = false; ///< true while plans search for lost icebergs
    std::vector<Point> m_area_m; ///< empty if the area is unbounded
    std::int64_t m_sampleSteps;  ///< steps between two camera samples, with measurements
    std::vector<Track> m_tracks;
    /** By iceberg: step before which it cannot come into view. */
    std::vector<std::int64_t> m_checkStep;
    std::int64_t m_nextCheckStep = 0; ///< least element of the list above
    double m_sigmaSum_m2 = 0;
    std::int64_t m_forcingStep = 0; ///< step of `DriftForcing` whose mean velocities are in force
    std::vector<SeenIceberg> m_newlySeen;
    IcebergList m_newlyAppeared;
};

/**
 * Returns the iceberg with the nearest estimate among those for which `counts` returns true, the
 * first among equals, or nullopt if there is none.
 */
[[nodiscard]] std::optional<IcebergIndex> nearest(const Observer& observer, const Point& from_m,
                                                  const std::function<bool(IcebergIndex)>& counts);
/** Returns the centre of the smallest circle around the estimates, m. */
[[nodiscard]] Point middle_m(const Observer& observer, std::span<const IcebergIndex> icebergs);

/** Returns the planning weight of the iceberg's sigma: 1 without an asset, above 1 near one. */
[[nodiscard]] double priority(const Observer& observer, IcebergIndex iceberg);
/** Returns the estimated motion relative to the asset, or nullopt if there is no asset. */
[[nodiscard]] std::optional<RelativeMotion> relativeToAsset(const Observer& observer,
                                                            IcebergIndex iceberg);

/** Returns true if the iceberg is in view of this UAV. */
[[nodiscard]] bool isInOwnView(const Observer& observer, int uav, IcebergIndex iceberg);
/**
 * Returns true if the UAV has reached the iceberg: it is in its view or, with a reach radius,
 * within that radius. The simple model compares the true position; otherwise the estimate counts,
 * for an iceberg that the last sample has shown.
 */
[[nodiscard]] bool isReached(const Observer& observer, int uav, IcebergIndex iceberg);
/**
 * Returns true if the iceberg is within the reach radius of any UAV. Simple model only, where this
 * can hold for an iceberg out of view.
 */
[[nodiscard]] bool isReachedUnseen(const Observer& observer, IcebergIndex iceberg);
/** Returns true if a UAV other than `uav` has reached the iceberg. */
[[nodiscard]] bool isReachedByOther(const Observer& observer, int uav, IcebergIndex iceberg);

} // namespace berg
