#pragma once

#include "core/coverage/coverage_model.h"
#include "core/plan/policy/policy.h"

#include <vector>

namespace berg {

/** One plan for each UAV of a request. */
using CoveragePlans = std::vector<CoveragePlan>;

/**
 * Returns the sets of plans from which the first plans of several UAVs are improved: empty plans,
 * the orders at tau = 1, and round tours over the icebergs that these assign to each UAV. Each set
 * has one plan per UAV; `limits` bounds the work of the orders.
 */
[[nodiscard]] std::vector<CoveragePlans> firstPlans(const PlanRequest& request,
                                                    const SolveOptions& limits);

/**
 * Returns the sets of plans from which the first plan of a UAV that is alone is improved: an empty
 * plan, the order at tau = 1, the order of least latency, and a round tour over all icebergs in
 * both directions. Each set has one plan; `limits` bounds the work of each order.
 */
[[nodiscard]] std::vector<CoveragePlans> firstPlansAlone(const PlanRequest& request,
                                                         const SolveOptions& limits);

} // namespace berg
