#pragma once

#include "core/plan/solve/solver.h"

namespace berg {

/**
 * Branch and cut by COIN-OR CBC on one of the MILPs of `formulation.h`, in the program
 * `bergwatch-cbc`, so that its end is an outcome here. The hint becomes CBC's starting incumbent.
 * The position-indexed and the printed MILP use nothing of our own engines; the reduced one takes
 * incumbent and columns from them (`reducedModel`), and CBC proves which of the orders left is the
 * best. Work unit: branch-and-bound nodes. Throws `Error{SolverFailed}` when COIN or that program
 * gives up without an order; with one the reason is `Unable`.
 */
class CbcSolver final : public TvpSolver
{
public:
    explicit CbcSolver(Formulation formulation);
    [[nodiscard]] AnswerSource source() const override { return AnswerSource::Cbc; }
    [[nodiscard]] std::optional<IssueReason> whyNot(const TvpProblem& problem) const override;

protected:
    [[nodiscard]] SolveOutcome doSolve(const TvpProblem& problem,
                                       const SolveOptions& options) const override;

private:
    Formulation m_formulation;
};

} // namespace berg
