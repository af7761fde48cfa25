#pragma once

#include "core/plan/solve/solver.h"

namespace berg {

/**
 * The engine of `ExactSolver` with about a second's work: a good order of any number of icebergs
 * and a lower bound, mostly the proof up to 60 icebergs. Deterministic. Work unit: as there.
 */
class LocalSearch final : public TvpSolver
{
public:
    [[nodiscard]] AnswerSource source() const override { return AnswerSource::Heuristic; }
    [[nodiscard]] std::optional<IssueReason> whyNot(const TvpProblem& problem) const override;

protected:
    [[nodiscard]] SolveOutcome doSolve(const TvpProblem& problem,
                                       const SolveOptions& options) const override;
};

} // namespace berg
