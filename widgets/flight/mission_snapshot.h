#pragma once

#include "core/coverage/aimed_path.h"
#include "core/mission/mission.h"

namespace berg {

enum class RunPhase
{
    Planning, ///< the plan from the start is being solved
    Ready,    ///< planned, at time 0
    Flying,
    Paused,
    Finished,
    Failed ///< the scenario cannot be planned or flown; see `error`
};

/** The record of a mission, or a part of it. */
struct MissionHistory
{
    std::vector<Sample> samples;
    std::vector<std::vector<IcebergSample>> rows; ///< icebergs at each sample, by iceberg index
    std::vector<PlanPointer> plans;
    std::vector<MissionEvent> events;
    std::uint64_t rewrites = 0; ///< number of times a known end was discarded
};

/** The records added since the previous snapshot. */
struct HistoryUpdate
{
    std::size_t firstSample = 0; ///< index of the first new sample in the whole record
    std::size_t firstPlan = 0;   ///< index of the first new plan
    std::size_t firstEvent = 0;  ///< index of the first new event
    MissionHistory part;
};

/** Appends an update to a history; records that the update repeats are replaced. */
void append(MissionHistory& history, HistoryUpdate news);

/** State of the mission at one instant, for drawing. Immutable once published. */
struct MissionSnapshot
{
    std::uint64_t generation = 0; ///< generation of its scenario
    RunPhase phase = RunPhase::Planning;
    bool isLive = false; ///< UAVs fly along the poses of real aircraft, at their pace
    double time_s = 0;
    WorldState world;
    std::vector<Iceberg> icebergs; ///< all icebergs; those added in flight come last
    std::vector<Point> truth_m;
    std::vector<bool> active;
    PlanPointer plan;               ///< newest plan; null if there is none
    std::vector<PlanPointer> plans; ///< plan in force of each UAV; null if it has none
    /** Request that `plan` answers; null without a plan. */
    std::shared_ptr<const PlanRequest> request;
    std::size_t planCount = 0;   ///< number of plans made so far
    PlannerSettings planner;     ///< settings in force, with interventions applied
    std::vector<Motion> motions; ///< by UAV, in the present wind
    WindAhead wind;              ///< from this instant on
    /** By iceberg: its changing mean velocity, or null; empty if none changes. */
    std::vector<std::shared_ptr<const DriftForcing>> forcings;
    std::optional<Asset> asset; ///< present asset; its position is that at time 0
    /** Geofence of each UAV; null if it is not limited. */
    std::vector<std::shared_ptr<const Geofence>> fences;
    std::vector<Point> homes_m; ///< landing place of each UAV
    /** By UAV, `Autopilot::homeMargin_s`. */
    std::vector<std::optional<double>> homeMargins_s;
    /**
     * By iceberg, index of the only UAV that may visit it; nullopt if every UAV may, or if there is
     * only one.
     */
    std::vector<std::optional<int>> assigned;
    /**
     * Changes of the world so far: wind, asset, homes and icebergs, without other changes made with
     * them.
     */
    std::vector<Intervention> worldChanges;
    /** The change that Undo reverts; nullopt in snapshots of an earlier instant. */
    std::optional<LastChange> lastChange;
    Metrics metrics;
    HistoryUpdate news;
    std::optional<Error> error;
};

/** Returns the snapshot's instant as the start of a forecast. The snapshot must outlive it. */
[[nodiscard]] ForecastStart forecastStart(const MissionSnapshot& snapshot);

/**
 * Returns the paths on which the UAV flies a plan with aim points from its position at `time_s`,
 * until all icebergs of the order are seen. Returns no paths for other plans.
 */
[[nodiscard]] std::vector<AimedPath> pathsOf(const UavPlan& plan, const DubinsState& uav,
                                             double time_s, const Motion& motion);
/** Returns the paths of the UAV's plan in force from the snapshot's instant on. */
[[nodiscard]] std::vector<AimedPath> pathsAhead(const MissionSnapshot& snapshot, int uav);

/** Returns the UAV's part of its plan in force, or null if there is none. */
[[nodiscard]] const UavPlan* planOf(const MissionSnapshot& snapshot, int uav);

/**
 * Returns the ids of the icebergs that the UAV visits before it turns home, in the order of its
 * plan in force; none without a plan.
 */
[[nodiscard]] std::vector<std::string> sortieIcebergs(const MissionSnapshot& snapshot, int uav);

/** Returns the orders of the plans in force, by UAV. */
[[nodiscard]] OrdersByUav ordersOf(const MissionSnapshot& snapshot);

/** Returns the present state of the mission, without generation, phase and news. */
[[nodiscard]] MissionSnapshot snapshotOf(const Mission& mission);

/**
 * Returns the state of the mission at `time_s` (`instantAt`), without `worldChanges`, `lastChange`,
 * generation, phase and news.
 */
[[nodiscard]] MissionSnapshot snapshotAt(const Mission& mission, double time_s);

} // namespace berg
