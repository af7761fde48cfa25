#pragma once

#include "core/bound/zeta_bound.h"
#include "widgets/model/mission_snapshot.h"
#include "widgets/theme/mission_clock.h"

#include <QString>

#include <memory>

namespace berg {

struct PlanReadout; // widgets/words

/** The last plan that was made before take-off. */
struct StartPlan
{
    Scenario scenario;
    std::vector<PlanEvent> plans; ///< by UAV, as are the others
    /** The last of the orders, since only the planner is changed, and what they took the place of.
     */
    std::vector<std::optional<PlanChange>> changes;
    std::vector<PlanEvent> former;
};

/** What the plan shown took the place of. */
struct ShownChange
{
    PlanChange change;
    double time_s = 0;            ///< when
    std::optional<Point> from_m;  ///< where the UAV was then; none: where it is
    std::vector<AimedPath> paths; ///< how the plan before would have gone on; empty: straight
};

/** What is known of the number that zeta of no flight of a scenario is below. */
struct KnownBound
{
    double zeta_m2s = 0;                    ///< at the end of the run, the best so far; 0: nothing
    double share = 0;                       ///< of the work that is done
    std::shared_ptr<const ZetaBound> whole; ///< when it is finished; else null
};

/**
 * What map, charts and panels show of one mission: its scenario, how it stands, what it was like
 * at the instant the user looks at, and the history so far. Made from a finished mission, or grown
 * from the snapshots of one that is being flown.
 */
struct FlightRecord
{
    Scenario scenario;
    MissionSnapshot now;                    ///< newest; its news are in the history
    std::optional<MissionSnapshot> instant; ///< looked back at; none: the newest is shown
    MissionHistory history;
    std::optional<StartPlan> startPlan;
    KnownBound bound; ///< of the scenario as it takes off

    /** What is to be drawn. */
    [[nodiscard]] const MissionSnapshot& shown() const { return instant ? *instant : now; }

    /** Forgets everything: another scenario, or the same one from its start. */
    void begin(const Scenario& flown);
    /** Takes the snapshot over; one of a new generation starts the history anew. */
    void take(MissionSnapshot snapshot);

    /** Under way, paused or at its end: the scenario is not to be edited. */
    [[nodiscard]] bool inFlight() const;
    /** What is shown is the end of the run: nothing is left to fly. */
    [[nodiscard]] bool isOver() const;
    /** Of this flight: nothing when an iceberg was reported seen or removed, or the wind changed in
     * flight. */
    [[nodiscard]] KnownBound boundOfFlight() const;
    /** At the time shown. */
    [[nodiscard]] Point estimate_m(std::size_t iceberg) const;
    /**
     * What was changed for the UAV. In flight that of the last plan at the time shown, or of one
     * before it when all that came after were changes of the planner that left the order as it was.
     * Before take-off that of the last other order in this world. None: no order was changed, or
     * all of the old one are seen.
     */
    [[nodiscard]] std::optional<ShownChange> changeShown(int uav = 0) const;
    /** So many events had come by the time shown. */
    [[nodiscard]] std::size_t eventsShown() const;

private:
    void noteStartPlan();
};

[[nodiscard]] FlightRecord recordOf(const Mission& mission);

/** Writes instants that are counted from the one shown. */
[[nodiscard]] TimesAhead timesOf(const FlightRecord& record);

/** Of the instant shown, with the plans of the last solve. */
[[nodiscard]] PlanReadout readoutOf(const FlightRecord& record, const QString& fault);

/**
 * How a flight to be watched is recorded: a sample each second, on long flights of many icebergs
 * fewer, but one in 5 s at least, so that a day with a hundred icebergs stays small and is drawn
 * as fast as a short one. How the mission is flown does not depend on it.
 */
[[nodiscard]] MissionOptions recordingOf(const Scenario& scenario);

} // namespace berg
