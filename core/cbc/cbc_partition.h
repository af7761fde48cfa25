#pragma once

#include "core/plan/solve/cbc_wire.h"

namespace berg {

/** Set partitioning by CBC's branch and cut. Throws `Error{SolverFailed}` when CBC fails. */
[[nodiscard]] CbcChoice bestPartition(const CbcPartition& partition);

} // namespace berg
