#pragma once

#include "core/plan/solver.h"

namespace berg {

/**
 * Iterated local search (2-opt, swap, or-opt of up to three, both directions; every move valued in
 * O(1) by prefix sums, asymmetric distances included), followed by a lower bound from Lagrangian
 * relaxation of "each iceberg once" on the position-layered graph of Picard and Queyranne.
 * Deterministic. Work unit: restarts of the descent from a disturbed order.
 */
class LocalSearch final : public TvpSolver
{
public:
    [[nodiscard]] std::string name() const override { return "heuristic"; }
    [[nodiscard]] std::string whyNot(const TvpProblem& problem) const override;

protected:
    [[nodiscard]] SolveOutcome doSolve(const TvpProblem& problem,
                                       const SolveOptions& options) const override;
};

} // namespace berg
