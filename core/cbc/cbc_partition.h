#pragma once

#include "core/plan/solve/cbc_wire.h"

namespace berg {

/**
 * Solves a set partitioning problem by CBC's branch and cut. Throws `Error{SolverFailed}` if CBC
 * fails.
 */
[[nodiscard]] CbcChoice bestPartition(const CbcPartition& partition);

} // namespace berg
