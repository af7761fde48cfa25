#pragma once

#include "core/coverage/coverage_effort.h"
#include "core/plan/policy/policy.h"

#include <map>

namespace berg {

/** The policy `coverage` for several UAVs. One object serves one mission. */
class CoverageFleet
{
public:
    /** As `Policy::plan`; each of the UAVs must have a picture. */
    [[nodiscard]] PlanAnswer plan(const PlanRequest& request, const SolveOptions& options);

private:
    std::map<int, KeptPlan> m_last; ///< what each UAV flies, by its number
};

} // namespace berg
