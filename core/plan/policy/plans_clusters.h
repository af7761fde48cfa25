#pragma once

#include "core/plan/policy/policy.h"

#include <stdexcept>

namespace berg {

/**
 * Whether the policy plans `PlanRequest::clusters`: it orders nodes anew at each plan. Fixed routes
 * are routes over single icebergs, and `coverage` sees several at once by itself.
 */
[[nodiscard]] constexpr bool plansClusters(PolicyKind policy)
{
    switch (policy) {
    case PolicyKind::Visitation:
    case PolicyKind::Nearest:
    case PolicyKind::Uncertainty:
    case PolicyKind::Latency:
        return true;
    case PolicyKind::Path:
    case PolicyKind::Tour:
    case PolicyKind::Coverage:
        return false;
    }
    throw std::logic_error("plansClusters: unknown policy");
}

} // namespace berg
