#pragma once

#include "core/coverage/coverage_model.h"
#include "core/plan/policy/policy.h"

#include <span>
#include <vector>

namespace berg {

/** A plan in the terms of the autopilot and of the display. */
struct DescribedPlan
{
    std::vector<AimedLeg> legs;
    /**
     * Available nodes of the request in the order of their first predicted sighting; nodes that the
     * plan does not see come last. The first leg is flown until the first node is seen.
     */
    VisitOrder nodes;
    AimedOutlook outlook; ///< Prediction for the plan, flown to the horizon of the model.
    std::vector<ModelPlace> searched; ///< One for each of `outlook.searches`.
};

/**
 * Returns a plan of the model in the terms of the autopilot and the display. The model must have
 * been made from `request`, which must have a input, and from these icebergs of the mission.
 */
[[nodiscard]] DescribedPlan describe(const CoverageModel& model, const UavRequest& request,
                                     std::span<const IcebergIndex> ids, const CoveragePlan& plan);

/**
 * Returns the plans of several UAVs in the terms of the autopilots and the display, one answer for
 * each UAV of the request. An iceberg is in the order of the UAV whose first leg goes to it, else
 * of the one that sees it first, else of the nearest; the UAV must always be allowed to fly there.
 * A place of a lost iceberg is in the outlook of the first UAV that has it in view. The outlooks
 * are without zeta. `models` must be made from the request's inputs, without views of other UAVs.
 */
[[nodiscard]] std::vector<UavPlan> describeFleet(std::span<const CoverageModel> models,
                                                 const PlanRequest& request,
                                                 std::span<const CoveragePlan> plans);

/**
 * Returns the visits of a UAV's patrol after its plan, in mission time. The model must have a tail,
 * and `patrol` has its visits as planned.
 */
[[nodiscard]] std::vector<PlannedVisit> laterVisits(const CoverageModel& model,
                                                    const PlanRequest& request,
                                                    const CoveragePlan& plan,
                                                    std::span<const PatrolVisit> patrol);

/** Returns, for each id, whether any UAV of the fleet may be sent there. */
[[nodiscard]] std::vector<bool> availableToAny(const PlanRequest& request);

} // namespace berg
