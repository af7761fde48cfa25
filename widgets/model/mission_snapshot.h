#pragma once

#include "core/coverage/aimed_path.h"
#include "core/sim/mission.h"

namespace berg {

enum class RunPhase
{
    Planning, ///< a plan from the start is being made
    Ready,    ///< planned, at time 0
    Flying,
    Paused,
    Finished,
    Failed ///< the scenario cannot be planned or flown: `error`
};

/** A stretch of what a mission has on record, or all of it. */
struct MissionHistory
{
    std::vector<Sample> samples;
    std::vector<std::vector<IcebergSample>> rows; ///< icebergs at each sample, by index
    std::vector<PlanEvent> plans;
    std::vector<MissionEvent> events;
    std::uint64_t rewrites = 0; ///< how often an end that was known was given up
};

/** What is new in the record since the snapshot before. */
struct HistoryUpdate
{
    std::size_t firstSample = 0; ///< places of the first of each in the whole record
    std::size_t firstPlan = 0;
    std::size_t firstEvent = 0;
    MissionHistory part;
};

/** Joins news to what is known up to them; what is known of them already is not doubled. */
void append(MissionHistory& history, HistoryUpdate news);

/** What the mission looks like at one instant, for drawing. Immutable once published. */
struct MissionSnapshot
{
    std::uint64_t generation = 0; ///< of the scenario it belongs to
    RunPhase phase = RunPhase::Planning;
    double time_s = 0;
    WorldState world;
    std::vector<Iceberg> icebergs; ///< those added in flight at the end
    std::vector<Point> truth_m;
    std::vector<bool> active;
    std::optional<PlanEvent> plan;              ///< the last one made, of the first UAV it tells
    std::vector<PlanEvent> plans;               ///< in force, one for each UAV, by UAV
    std::shared_ptr<const PlanRequest> request; ///< what `plan` answers; null without a plan
    std::size_t planCount = 0;                  ///< made until then, `plan` the last of them
    PlannerSettings planner;                    ///< in force, interventions applied
    std::vector<Motion> motions;                ///< by UAV, in the wind in force
    std::optional<Asset> asset;                 ///< in force; its position is that at time 0
    /** By UAV, what it stays inside; null: nothing. */
    std::vector<std::shared_ptr<const Geofence>> fences;
    /** By UAV, `Autopilot::homeMargin_s`. */
    std::vector<std::optional<double>> homeMargins_s;
    std::vector<int>
        assigned; ///< by iceberg: the UAV that alone is to visit it, -1: any, as the only one
    /** Until then, of the world: wind, asset and icebergs, without what else came with them. */
    std::vector<Intervention> worldChanges;
    Metrics metrics;
    HistoryUpdate news;
    std::optional<Error> error;
};

/** The instant of the snapshot as one to forecast from; the snapshot must outlive it. */
[[nodiscard]] ForecastStart forecastStart(const MissionSnapshot& snapshot);

/**
 * How a plan with aim points is flown by a UAV that is there at that time, until all of its order
 * are seen; none of other plans.
 */
[[nodiscard]] std::vector<AimedPath> pathsOf(const PlanEvent& plan, const DubinsState& uav,
                                             double time_s, const Motion& motion);
/** The same of the plan in force of the UAV, from the instant of the snapshot on. */
[[nodiscard]] std::vector<AimedPath> pathsAhead(const MissionSnapshot& snapshot, int uav);

/** In force for the UAV; null: none yet. */
[[nodiscard]] const PlanEvent* planOf(const MissionSnapshot& snapshot, int uav);

/** Orders of the plans in force, by UAV. */
[[nodiscard]] OrdersByUav ordersOf(const MissionSnapshot& snapshot);

/** The mission as it is now, without generation, phase and news. */
[[nodiscard]] MissionSnapshot snapshotOf(const Mission& mission);

/** The mission as it was at `time_s` (`instantAt`). */
[[nodiscard]] MissionSnapshot snapshotAt(const Mission& mission, double time_s);

} // namespace berg
