#pragma once

#include "core/plan/fleet/fleet_problem.h"
#include "core/plan/solve/solver.h"

namespace berg {

/**
 * Solves the problem by the fleet's counterpart of that back end, with the same promises about
 * status, limits and determinism as `TvpSolver::solve`. Up to 14 icebergs `Exact` and `Auto` use
 * dynamic programming over subsets; else a local search and a bound take turns: `Exact` until the
 * proof, `Auto` and `Heuristic` for about a second's work. Latency has no bound: beyond 14 icebergs
 * `Exact` is unable, and the other two search for some tenths of a second. `Cbc` is `Exact` without
 * dynamic programming, with the orders that the bound leaves put together by CBC: a proof relies on
 * our bound for what is left out. Unable for latency. At mu = 0
 * an assignment is the proof (`bestRanks`), whatever the back end, the work and the memory. A
 * problem that `validate` faults throws `Error{InvalidInput}`.
 */
[[nodiscard]] SolveOutcome solveFleet(const FleetProblem& problem, Backend backend,
                                      const SolveOptions& options);

/**
 * Solves a problem of any number of UAVs by the fastest way there is: one alone by `alone`, which
 * is the back end for one, several by `solveFleet`, and none without any work.
 */
[[nodiscard]] SolveOutcome solve(const FleetProblem& problem, Backend backend,
                                 const TvpSolver& alone, const SolveOptions& options);

} // namespace berg
