#pragma once

#include "core/coverage/coverage_model.h"
#include "core/plan/policy/policy.h"

#include <span>
#include <vector>

namespace berg {

/** A plan in the words of the autopilot and of those who watch. */
struct DescribedPlan
{
    std::vector<AimedLeg> legs;
    /**
     * Available nodes of the request in the order of their first predicted sighting; those that
     * the plan does not see come last. The first one is what the first leg is flown until.
     */
    std::vector<int> nodes;
    AimedOutlook outlook;      ///< flown to the horizon of the model
    std::vector<int> searched; ///< places of the model, one for each of `outlook.searches`
};

/** `request` is what the model was made of, of icebergs with these ids; its picture must be there.
 */
[[nodiscard]] DescribedPlan describe(const CoverageModel& model, const UavRequest& request,
                                     std::span<const int> ids, const CoveragePlan& plan);

/**
 * Plans of several UAVs in the words of those who fly and watch, one for each of the
 * request's. An iceberg is in the order of the UAV whose first leg is to it, else of the one that
 * is first to see it, else of the nearest, always of one that may be sent there. A place of a lost
 * iceberg is in the outlook of the first UAV that has it in view. The outlooks are without zeta.
 * `models`: of the request's pictures, without views of others.
 */
[[nodiscard]] std::vector<UavAnswer> describeFleet(std::span<const CoverageModel> models,
                                                   const PlanRequest& request,
                                                   std::span<const CoveragePlan> plans);

/** Whether any UAV of the fleet may be sent there: one entry per id. */
[[nodiscard]] std::vector<bool> availableToAny(const PlanRequest& request);

} // namespace berg
