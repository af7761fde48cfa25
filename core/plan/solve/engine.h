#pragma once

#include "core/plan/solve/solver.h"

namespace berg {

/**
 * Solves by the engine of the back ends `exact`, `auto` and `heuristic`: a local optimum, a first
 * bound, an iterated local search (`OrderSearch`), then rounds of the layered relaxation
 * (`improveBound`) with more local search between them, until the optimum is proven or a limit is
 * reached. Keeps all limits of `SolveOptions`. At mu = 0 the optimum is a sort (for latency any
 * order). Deterministic unless stopped by time or stop token.
 *
 * `effort` is a limit of the back end itself, in the unit of `SolveOptions::workLimit`; it ends the
 * solve with `StopReason::Finished`. `problem` must be valid and have at least one iceberg; a hint
 * must be valid or empty. With more than `kMostProvenByEngine` icebergs and mu > 0 the result has a
 * bound, but no proof.
 */
[[nodiscard]] SolveOutcome solveByEngine(const TvpProblem& problem, const SolveOptions& options,
                                         std::optional<std::int64_t> effort);

/** Largest number of icebergs for a proof. */
inline constexpr int kMostProvenByEngine = 127;

/**
 * Returns the `effort` of the back ends that must answer quickly: about a second, twice as much
 * with more than `kMostProvenByEngine` icebergs, and a fifteenth of it if `inFlight`.
 */
[[nodiscard]] std::int64_t responsiveEffort(int icebergs, bool inFlight);

/**
 * Returns whether dynamic programming over subsets is faster than the engine and keeps to the
 * options' limits: up to 14 icebergs, for latency 16. Returns false at mu = 0.
 */
[[nodiscard]] bool subsetsAreFaster(const TvpProblem& problem, const SolveOptions& options);

/**
 * Finds the proven optimum: by dynamic programming over subsets where that is faster (14 icebergs;
 * latency 16), else by the engine with local search and bound, without a limit of its own: it runs
 * until the proof or a limit of the options. Meanwhile it reports orders and bounds that improve;
 * the time to the proof grows from milliseconds at 20 icebergs to a minute or more at 100. Up to
 * 127 icebergs, at mu = 0 any number. Work unit: about 2 ns (an arc of a graph examined, a move
 * evaluated, an entry of the table).
 */
class ExactSolver final : public TvpSolver
{
public:
    [[nodiscard]] AnswerSource source() const override { return AnswerSource::Exact; }
    [[nodiscard]] std::optional<IssueReason>
    unsupportedReason(const TvpProblem& problem) const override;

protected:
    [[nodiscard]] SolveOutcome doSolve(const TvpProblem& problem,
                                       const SolveOptions& options) const override;
};

/**
 * Runs the engine of `ExactSolver` with about a second's work: a good order of any number of
 * icebergs and a lower bound, usually with a proof up to 60 icebergs. Deterministic. Same work
 * unit.
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
