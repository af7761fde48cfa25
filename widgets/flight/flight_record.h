#pragma once

#include "core/bound/zeta_bound.h"
#include "widgets/flight/mission_snapshot.h"
#include "widgets/flight/weather_course.h"
#include "widgets/theme/mission_clock.h"

#include <QString>

#include <memory>
#include <optional>

namespace berg {

struct PlanReadout; // widgets/words

/** The last plan made before take-off. */
struct StartPlan
{
    Scenario scenario;
    /** Its changes are the last ones of each order since only the planner has changed. */
    PlanPointer plan;
    PlanPointer former; ///< plan before those changes; null without any
};

/** The change of plan that is shown. */
struct ShownChange
{
    PlanChange change;
    double time_s = 0; ///< time of the change, s
    /** Position of the UAV at the change; nullopt if it has not moved since. */
    std::optional<Point> from_m;
    /** Continuation of the former plan; empty for straight legs. */
    std::vector<AimedPath> paths;
};

/** The lower bound on zeta of any flight of a scenario, as far as it is known. */
struct KnownBound
{
    std::optional<double> zeta_m2s;         ///< best bound so far at the end of the run, > 0
    double share = 0;                       ///< share of the work that is done, 0 to 1
    std::shared_ptr<const ZetaBound> whole; ///< the complete bound; null until it is finished
};

/**
 * Data that map, charts and panels show of one mission: its scenario, its present state, the state
 * at the instant the user looks back at, and the history so far. Made from a finished mission, or
 * grown from snapshots of one in flight.
 */
struct FlightRecord
{
    Scenario scenario;
    MissionSnapshot now; ///< newest snapshot; its news are moved to the history
    /** Instant the user looks back at; nullopt shows the newest. */
    std::optional<MissionSnapshot> instant;
    MissionHistory history;
    std::optional<StartPlan> startPlan;
    KnownBound bound; ///< bound for the scenario as at take-off
    /** Weather over the run; null until `noteWeather`. */
    std::shared_ptr<const WeatherCourse> weather;

    /** Returns the snapshot to draw. */
    [[nodiscard]] const MissionSnapshot& shown() const { return instant ? *instant : now; }

    /** Clears everything but the bound, for another scenario or a new start of the same one. */
    void begin(const Scenario& flown);
    /** Adds a snapshot; one of a new generation restarts the history. */
    void accept(MissionSnapshot snapshot);
    /** Sets `weather` for the scenario and the winds reported so far. */
    void noteWeather();

    /** Returns whether the flight is flying, paused or finished, so that the scenario is locked. */
    [[nodiscard]] bool inFlight() const;
    /** Returns whether the end of the run is shown. */
    [[nodiscard]] bool isOver() const;
    /**
     * Returns the bound that holds for this flight; it is unknown once an iceberg was reported seen
     * or removed, the wind was changed in flight, or a UAV could not be home in time.
     */
    [[nodiscard]] KnownBound boundOfFlight() const;
    /** Returns the estimated position of an iceberg at the time shown. */
    [[nodiscard]] Point estimate_m(IcebergIndex iceberg) const;
    /**
     * Returns the change of the UAV's order. In flight that of the last plan at the time shown, or
     * of an earlier one if only changes of the planner that kept the order followed; before
     * take-off that of the last different order in this world. Returns nullopt if no order changed,
     * or if all icebergs of the old one have been seen.
     */
    [[nodiscard]] std::optional<ShownChange> changeShown(int uav = 0) const;
    /** Returns the number of events up to the time shown. */
    [[nodiscard]] std::size_t eventsShown() const;

private:
    void noteStartPlan();
};

/** Returns the complete record of a mission. */
[[nodiscard]] FlightRecord recordOf(const Mission& mission);

/** Returns the weather of the record, computed if it has none yet. */
[[nodiscard]] std::shared_ptr<const WeatherCourse> weatherOfRun(const FlightRecord& record);

/** Returns a formatter of times relative to the instant shown. */
[[nodiscard]] TimesAhead timesOf(const FlightRecord& record);

/** Returns the readout of the plan at the instant shown. */
[[nodiscard]] PlanReadout readoutOf(const FlightRecord& record, const QString& fault);

/**
 * Returns the recording options of a flight that is watched: a sample each second, fewer on long
 * flights of many icebergs but at least one in 5 s, so that a day with a hundred icebergs stays
 * small and draws as fast as a short one. The flight itself does not depend on them.
 */
[[nodiscard]] MissionOptions recordingOf(const Scenario& scenario);

} // namespace berg
