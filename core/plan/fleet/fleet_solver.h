#pragma once

#include "core/plan/fleet/fleet_problem.h"
#include "core/plan/solve/solver.h"

namespace berg {

/**
 * Solves the problem by the counterpart of the back end for fleets, with the guarantees of
 * `TvpSolver::solve` about status, limits and determinism. Up to 14 icebergs `Exact` and `Auto` use
 * dynamic programming over subsets; otherwise a local search and a bound alternate: `Exact` until
 * the proof, `Auto` and `Heuristic` for about a second's work. Latency has no bound: beyond 14
 * icebergs `Exact` is unable, and the other two search for some tenths of a second. `Cbc` is
 * `Exact` without dynamic programming, and CBC combines the orders that the bound leaves: a proof
 * relies on our bound for the orders left out. It is unable for latency. `Exact` and `Cbc` are
 * unable with more than 127 icebergs. At mu = 0 and up to 127 icebergs an assignment is the proof
 * (`bestRanks`) for every back end and without limits of work and memory. If the costs alone exceed
 * the memory limit, the plan is the hint or `roundRobinPlan`. Throws `Error{InvalidInput}` for a
 * problem in which `validate` finds faults, `Error{Unsupported}` if CBC is needed and missing, and
 * `std::logic_error` inside a `NoBlockingScope`.
 */
[[nodiscard]] SolveOutcome solveFleet(const FleetProblem& problem, Backend backend,
                                      const SolveOptions& options);

/**
 * Solves a problem of any number of UAVs by the fastest method: one UAV by `alone`, the back end
 * for a single UAV, several by `solveFleet`; a problem without UAVs needs no work. Icebergs that
 * the hint of a single UAV lacks are appended to it. Throws as `solveFleet` and `TvpSolver::solve`
 * do.
 */
[[nodiscard]] SolveOutcome solve(const FleetProblem& problem, Backend backend,
                                 const TvpSolver& alone, const SolveOptions& options);

} // namespace berg
