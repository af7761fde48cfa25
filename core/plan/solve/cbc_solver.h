#pragma once

#include "core/plan/solve/solver.h"

namespace berg {

/**
 * Branch and cut by COIN-OR CBC on one of the MILPs of `formulation.h`, in the program
 * `bergwatch-cbc`, so that a crash there becomes an outcome of the solve. The hint becomes CBC's
 * starting incumbent. The position-indexed and the printed MILP use nothing of our own engines; the
 * reduced one takes incumbent and columns from them (`reducedModel`), and CBC proves which of the
 * remaining orders is the best. It supports Eq. (1) up to 40 icebergs by the position-indexed MILP
 * and up to 60 by the others. Work unit: branch-and-bound nodes. Throws `Error{SolverFailed}` if
 * COIN or that program fails without an order; if there is an order, the outcome has the reason
 * `Unable`. If memory ran out, the reason is `MemoryLimit`, with or without an order. Throws
 * `Error{Unsupported}` if the program is missing.
 */
class CbcSolver final : public TvpSolver
{
public:
    explicit CbcSolver(Formulation formulation);
    [[nodiscard]] AnswerSource source() const override { return AnswerSource::Cbc; }
    [[nodiscard]] std::optional<IssueReason>
    unsupportedReason(const TvpProblem& problem) const override;

protected:
    [[nodiscard]] SolveOutcome doSolve(const TvpProblem& problem,
                                       const SolveOptions& options) const override;

private:
    Formulation m_formulation;
};

} // namespace berg
