#pragma once

#include "core/plan/solve/solver.h"

namespace berg {

/**
 * The engine behind the back ends `exact`, `auto` and `heuristic`: a local optimum, a first bound,
 * an iterated local search (`OrderSearch`), then rounds of the layered relaxation (`improveBound`)
 * with more local search between them, until the optimum is proven or a limit comes. Keeps to all
 * of `SolveOptions`. At mu = 0 the optimum is a sort (for latency any order). Deterministic unless
 * cut by time or stop.
 *
 * `effort` is a limit of the back end's own, in the unit of `SolveOptions::workLimit`; it ends
 * the solve with `StopReason::Finished`. `problem` is valid and has at least one iceberg; a hint
 * is valid or empty. With more than `kMostProvenByEngine` icebergs and mu > 0 nothing is proven,
 * only bounded.
 */
[[nodiscard]] SolveOutcome solveByEngine(const TvpProblem& problem, const SolveOptions& options,
                                         std::optional<std::int64_t> effort);

inline constexpr int kMostProvenByEngine = 127;

/** `effort` of the back ends that must answer while someone waits: about a second, and a fifteenth
 * of it `inFlight`. */
[[nodiscard]] std::int64_t responsiveEffort(int icebergs, bool inFlight);

/**
 * True when dynamic programming over subsets is faster than the engine and keeps to the options'
 * limits: up to 14 icebergs, for latency 16.
 */
[[nodiscard]] bool subsetsPay(const TvpProblem& problem, const SolveOptions& options);

} // namespace berg
