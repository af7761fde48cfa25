#pragma once

#include "core/coverage/coverage_model.h"
#include "core/plan/policy/policy.h"

#include <span>
#include <vector>

namespace berg {

/**
 * Returns the input of each UAV of the request, in which only the icebergs in its own view are
 * marked as in view; the tracks of a request mark icebergs in view of any UAV. Throws
 * `std::logic_error` if a UAV has none.
 */
[[nodiscard]] std::vector<PredictionInput> ownInputs(const PlanRequest& request);

/**
 * Returns one model for each input. All models predict to the horizon, but no UAV flies beyond
 * the end of its own run or sortie.
 */
[[nodiscard]] std::vector<CoverageModel> modelsOf(std::span<const PredictionInput> inputs,
                                                  CoverageHorizon horizon);

} // namespace berg
