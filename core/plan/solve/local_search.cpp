#include "core/plan/solve/local_search.h"

#include "core/plan/solve/engine.h"

namespace berg {

std::optional<IssueReason> LocalSearch::whyNot(const TvpProblem&) const
{
    return std::nullopt;
}

SolveOutcome LocalSearch::doSolve(const TvpProblem& problem, const SolveOptions& options) const
{
    return solveByEngine(problem, options,
                         responsiveEffort(problem.icebergCount(), options.inFlight));
}

} // namespace berg
