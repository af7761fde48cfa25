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

/**
 * Proven optimum: dynamic programming over subsets where that is faster (14 icebergs; latency 16),
 * the engine with local search and bound above, without a limit of its own: it goes on until the
 * proof or a limit of the options. Until then it reports an order and a bound that get better; the
 * time to the proof grows from milliseconds at 20 icebergs to a minute or more at 100. Up to 127
 * icebergs, at mu = 0 any number. Work unit: about 2 ns (an arc of a graph looked at, a move
 * valued, an entry of the table).
 */
class ExactSolver final : public TvpSolver
{
public:
    [[nodiscard]] AnswerSource source() const override { return AnswerSource::Exact; }
    [[nodiscard]] std::optional<IssueReason> whyNot(const TvpProblem& problem) const override;

protected:
    [[nodiscard]] SolveOutcome doSolve(const TvpProblem& problem,
                                       const SolveOptions& options) const override;
};

/**
 * The engine of `ExactSolver` with about a second's work: a good order of any number of icebergs
 * and a lower bound, mostly the proof up to 60 icebergs. Deterministic. Work unit: as there.
 */
class LocalSearch final : public TvpSolver
{
public:
    [[nodiscard]] AnswerSource source() const override { return AnswerSource::Heuristic; }

protected:
    [[nodiscard]] SolveOutcome doSolve(const TvpProblem& problem,
                                       const SolveOptions& options) const override;
};

} // namespace berg
