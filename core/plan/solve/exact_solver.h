#pragma once

#include "core/plan/solve/solver.h"

namespace berg {

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

} // namespace berg
