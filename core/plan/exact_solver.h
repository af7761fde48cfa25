#pragma once

#include "core/plan/solver.h"

namespace berg {

/**
 * Proven optimum by dynamic programming over subsets of icebergs (Held and Karp 1962, with the
 * position-dependent cost of Eq. (1)): 2^n n states, n <= 20 icebergs (168 MB). Ties go to the
 * smallest node numbers. At mu = 0 the optimum is a sort: largest sigma first, then nearest to
 * the UAV, then smallest number. Work unit: subsets treated.
 */
class ExactSolver final : public TvpSolver
{
public:
    [[nodiscard]] std::string name() const override { return "exact"; }
    [[nodiscard]] std::string whyNot(const TvpProblem& problem) const override;

protected:
    [[nodiscard]] SolveOutcome doSolve(const TvpProblem& problem,
                                       const SolveOptions& options) const override;
};

} // namespace berg
