#include "core/plan/solve/exact_solver.h"

#include "core/plan/solve/engine.h"
#include "core/plan/solve/names.h"
#include "core/plan/solve/subset_solver.h"

namespace berg {

std::optional<IssueReason> ExactSolver::whyNot(const TvpProblem& problem) const
{
    if (problem.icebergCount() <= kMostProvenByEngine || problem.mu == 0)
        return std::nullopt;
    return IssueReason{IssueId::ProofTooLarge,
                       {nameOf(kBackendNames, Backend::Exact), std::int64_t{kMostProvenByEngine}}};
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
