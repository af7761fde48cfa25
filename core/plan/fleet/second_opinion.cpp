#include "core/plan/fleet/second_opinion.h"

#include "core/plan/fleet/fleet_solver.h"

#include <cmath>

namespace berg {

namespace {

constexpr int kLargestByPosition = 16;

/** Returns the MILP to use; nullopt for several UAVs, for which there is none. */
std::optional<Formulation> formulationFor(const FleetProblem& problem)
{
    if (problem.uavCount() > 1)
        return std::nullopt;
    return problem.icebergCount() <= kLargestByPosition ? Formulation::Position
                                                        : Formulation::Reduced;
}

} // namespace

Verdict verdictOn(const FleetProblem& problem, const SolveOutcome& first,
                  const SolveOutcome& second)
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

SecondOpinion secondOpinion(const FleetProblem& problem, const SolveOutcome& first,
                            const SolveOptions& options, std::optional<Formulation> formulation)
{
    const SolveOptions proof{.timeLimit_s = options.timeLimit_s, .stop = options.stop};
    const auto solvedBy = [&](Backend backend, Formulation milp) {
        return solve(problem, backend, *makeSolver(backend, milp), proof);
    };
    SecondOpinion second;
    if (first.source == AnswerSource::Cbc) {
        second.outcome = solvedBy(Backend::Exact, {});
        if (second.outcome.reason == StopReason::Unable)
            second.outcome = solvedBy(Backend::Auto, {});
    } else {
        second.formulation = formulationFor(problem);
        if (second.formulation)
            second.formulation = formulation.value_or(*second.formulation);
        second.outcome = solvedBy(Backend::Cbc, second.formulation.value_or(Formulation::Position));
    }
    second.verdict = verdictOn(problem, first, second.outcome);
    return second;
}

} // namespace berg
