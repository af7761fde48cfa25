#include "core/plan/solve/exact_solver.h"

#include "core/plan/solve/engine.h"
#include "core/plan/solve/subset_solver.h"

namespace berg {

std::string ExactSolver::whyNot(const TvpProblem& problem) const
{
    if (problem.icebergCount() <= kMostProvenByEngine || problem.mu == 0)
        return {};
    return "Proofs are limited to " + std::to_string(kMostProvenByEngine) +
           " icebergs; the back end auto gives an order and a bound.";
}

SolveOutcome ExactSolver::doSolve(const TvpProblem& problem, const SolveOptions& options) const
{
    if (subsetsPay(problem, options)) {
        SolveOutcome outcome = SubsetSolver().solve(problem, options);
        outcome.source = source();
        return outcome;
    }
    return solveByEngine(problem, options, std::nullopt);
}

} // namespace berg
