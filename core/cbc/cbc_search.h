#pragma once

#include "core/plan/solve/solver.h"

namespace berg {

/**
 * Branch and cut by COIN-OR CBC on one of the MILPs of `formulation.h`; see `CbcSolver`, which asks
 * for it. The problem is valid and has an iceberg, the hint is empty or one valid order. Throws
 * `Error{SolverFailed}` when COIN gives up without an order.
 */
[[nodiscard]] SolveOutcome searchByCbc(const TvpProblem& problem, Formulation formulation,
                                       const SolveOptions& options);

} // namespace berg
