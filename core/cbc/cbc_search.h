#pragma once

#include "core/plan/solve/solver.h"

namespace berg {

/**
 * Searches one of the MILPs of `formulation.h` by branch and cut of COIN-OR CBC, on behalf of
 * `CbcSolver`. The problem must be valid and have an iceberg; the hint is empty or one valid order.
 * Throws `Error{SolverFailed}` if COIN ends without an order.
 */
[[nodiscard]] SolveOutcome searchByCbc(const TvpProblem& problem, Formulation formulation,
                                       const SolveOptions& options);

} // namespace berg
