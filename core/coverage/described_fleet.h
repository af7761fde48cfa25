#pragma once

#include "core/coverage/coverage_model.h"
#include "core/plan/policy/policy.h"

#include <span>
#include <vector>

namespace berg {

/**
 * Plans of several UAVs in the words of those who fly and watch, one for each of the
 * request's. An iceberg is in the order of the UAV whose first leg is to it, else of the one that
 * is first to see it, else of the nearest, always of one that may be sent there. The outlooks are
 * without zeta. `models`: of the request's pictures, without views of others.
 */
[[nodiscard]] std::vector<UavAnswer> describeFleet(std::span<const CoverageModel> models,
                                                   const PlanRequest& request,
                                                   std::span<const CoveragePlan> plans);

/** Whether any UAV of the fleet may be sent there: one entry per id. */
[[nodiscard]] std::vector<bool> availableToAny(const PlanRequest& request);

} // namespace berg
