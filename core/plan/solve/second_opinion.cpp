#include "core/plan/solve/second_opinion.h"

#include <cmath>

namespace berg {

namespace {

constexpr int kLargestByPosition = 16;

Formulation formulationFor(const TvpProblem& problem)
{
    return problem.icebergCount() <= kLargestByPosition ? Formulation::Position
                                                        : Formulation::Reduced;
}

} // namespace

Verdict verdictOn(const TvpProblem& problem, const SolveOutcome& first, const SolveOutcome& second)
{
    if (first.status == SolveStatus::None || second.status == SolveStatus::None)
        return Verdict::NotVerified;
    constexpr double kTolerance = 1e-6;
    const double tolerance = kTolerance * (std::abs(first.objective) + objectiveShift(problem));
    const auto refutes = [tolerance](const SolveOutcome& order, const SolveOutcome& bound) {
        return bound.bound && *bound.bound > order.objective + tolerance;
    };
    if (refutes(first, second) || refutes(second, first))
        return Verdict::Disagrees;
    const bool proven = second.status == SolveStatus::Optimal;
    const bool equal = std::abs(first.objective - second.objective) <= tolerance;
    return proven && equal ? Verdict::Agrees : Verdict::NotVerified;
}

SecondOpinion secondOpinion(const TvpProblem& problem, const SolveOutcome& first,
                            const SolveOptions& options, std::optional<Formulation> formulation)
{
    SecondOpinion second;
    std::unique_ptr<TvpSolver> solver;
    if (first.backend == "cbc") {
        solver = makeSolver(Backend::Exact);
        if (!solver->whyNot(problem).empty())
            solver = makeSolver(Backend::Auto);
    } else {
        second.formulation = formulation.value_or(formulationFor(problem));
        solver = makeSolver(Backend::Cbc, *second.formulation);
    }
    second.outcome =
        solver->solve(problem, {.timeLimit_s = options.timeLimit_s, .stop = options.stop});
    second.verdict = verdictOn(problem, first, second.outcome);
    return second;
}

} // namespace berg
