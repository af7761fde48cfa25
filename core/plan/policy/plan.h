#pragma once

#include "core/plan/fleet/fleet_problem.h"
#include "core/plan/policy/plan_reason.h"
#include "core/plan/solve/solver.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace berg {

/** One visit of a patrol, which comes back to icebergs. */
struct PlannedVisit
{
    IcebergIndex iceberg;
    double time_s = 0; ///< predicted, since the start of the mission
    bool operator==(const PlannedVisit&) const = default;
};

/** Replacement of the rest of one order by another. */
struct PlanChange
{
    IcebergList before;    ///< rest of the previous order
    double distance_m = 0; ///< length of the new order minus that of the previous one
    /** Predicted zeta of the new orders minus that of the previous ones, all UAVs. */
    double zeta_m2s = 0;
    bool operator==(const PlanChange&) const = default;
};

/** The part of a plan that one UAV flies. */
struct UavPlan
{
    int uav = 0;            ///< the caller's number of the UAV, `UavRequest::uav`
    IcebergList order = {}; ///< in visiting order; the first one is available
    /**
     * Groups of two or more icebergs of the order that are visited as one point; their members
     * follow one another.
     */
    std::vector<IcebergList> clusters = {};
    std::vector<AimedLeg> legs = {}; ///< aimed legs; empty means straight to the first iceberg
    std::optional<AimedOutlook> outlook = {}; ///< prediction for `legs`
    /**
     * Visits that the UAV plans after `legs`, or after the first iceberg if there are no legs,
     * ascending in time; an iceberg may appear several times. Empty unless `coverage` plans a
     * patrol.
     */
    std::vector<PlannedVisit> laterVisits = {};
    PlanReason reason = PlanReason::None; ///< why this UAV needed the plan; set by missions
    /**
     * Number of icebergs visited before the UAV turns home; nullopt if the endurance is unlimited.
     * Set by missions.
     */
    std::optional<int> thisSortie = {};
    /**
     * Comparison with the rest of the previous plan, to the end of the run; set by missions with a
     * record.
     */
    std::optional<PlanChange> change = {};

    /** Returns the iceberg to fly to; nullopt to circle. */
    [[nodiscard]] std::optional<IcebergIndex> target() const
    {
        return order.empty() ? std::nullopt : std::optional(order.front());
    }
    bool operator==(const UavPlan&) const = default;
};

/**
 * A plan for one or several UAVs: made by a policy, kept by the mission, written to run files, and
 * read by everything that shows or exports it.
 */
struct Plan
{
    double time_s = 0;    ///< instant from which it is flown; set by missions, as the next two
    double zeta_m2s = 0;  ///< Eq. (24) up to that instant
    bool interim = false; ///< rest of the previous plan, flown while the next one is being made
    /**
     * Whether `Metrics::replans` counts it: not if it is interim, nor if its first UAV was no
     * longer planned when it came into force.
     */
    bool isCounted = true;
    /** One entry for each UAV planned; no two orders begin with the same iceberg. */
    std::vector<UavPlan> uavs = {};
    SolveOutcome outcome = {}; ///< result of the solver; its nodes are those of `problem`
    /**
     * Problem that was solved (`visitationTask`); empty if no solve was needed. Missions keep its
     * criterion and mu alone.
     */
    FleetProblem problem = {};
    IcebergList solvedIds = {}; ///< iceberg of node k+1 of `problem`
    /**
     * Whether the policy gave no order, so that each UAV flies the rest of its last order, or to
     * the nearest iceberg if there is no rest.
     */
    bool fellBack = false;
    std::string failure = {}; ///< reason, in English, if the policy threw an error
    std::optional<double> predictedZeta_m2s = {}; ///< predicted zeta, by which legs were chosen
    std::optional<double> gap = {};               ///< relative gap of `outcome`
    /**
     * Distance of the plan in the unit of `UavRequest::distance_m`, with the return legs of closed
     * routes.
     */
    double distance_m = 0;

    /** Returns the part of the UAV with this number, or null if the plan has none. */
    [[nodiscard]] const UavPlan* of(int uav) const
    {
        const auto own = std::ranges::find(uavs, uav, &UavPlan::uav);
        return own == uavs.end() ? nullptr : &*own;
    }
};

/** A plan as missions, snapshots and run files share it. */
using PlanPointer = std::shared_ptr<const Plan>;

} // namespace berg
