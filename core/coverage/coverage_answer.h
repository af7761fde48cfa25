#pragma once

#include "core/coverage/coverage_starts.h"
#include "core/coverage/fleet_coverage_search.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace berg {

/** Plans that a search has found, with the models and the horizon that they were judged by. */
struct FoundPlans
{
    CoverageHorizon horizon;
    std::vector<CoverageModel> models;
    FleetCoverage found;
    std::optional<PatrolTails> tails; ///< Patrol that follows the plans; nullopt if there is none.
    CoveragePlans patrols;            ///< Visits of the tails as legs.
    bool isStraight = false; ///< The plans are flown without aims, straight to the icebergs.
    std::int64_t work = 0;
    bool wasWarm = false;
};

/**
 * Returns the answer to a request, without the outcome of the search, for the plans that were
 * found. `inputs` must have one entry for each UAV. Plans that are flown without aims have
 * neither legs nor a prediction.
 */
[[nodiscard]] Plan answerOf(const PlanRequest& request, const std::vector<PredictionInput>& inputs,
                            const FoundPlans& plans);

/**
 * Adds the value of the order by Eq. (1), and the length of its legs, to the answer if the request
 * has a single UAV.
 */
void judgeAlone(Plan& answer, const PlanRequest& request);

} // namespace berg
