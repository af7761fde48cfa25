#pragma once

#include "core/plan/solve/solver.h"
#include "tests/support/plan/brute_force.h"

#include <functional>
#include <utility>
#include <vector>

namespace berg::test {

/** Answers of a `ScriptedSolver`, and the problems it was given. */
struct SolverScript
{
    /** Returns an answer; the default is the order of the node numbers. */
    std::function<SolveOutcome(const TvpProblem&)> answer;
    std::vector<TvpProblem> problems;
    std::vector<SolveOptions> options;
};

/** Answers by a script that belongs to the test. */
class ScriptedSolver final : public TvpSolver
{
public:
    explicit ScriptedSolver(SolverScript& script) : m_script(script) {}
    [[nodiscard]] AnswerSource source() const override { return AnswerSource::Exact; }
    [[nodiscard]] std::optional<IssueReason> unsupportedReason(const TvpProblem&) const override
    {
        return std::nullopt;
    }

protected:
    [[nodiscard]] SolveOutcome doSolve(const TvpProblem& problem,
                                       const SolveOptions& options) const override
    {
        m_script.problems.push_back(problem);
        m_script.options.push_back(options);
        if (m_script.answer)
            return m_script.answer(problem);
        SolveOutcome outcome{.status = SolveStatus::Feasible, .plan = FleetPlan(1)};
        outcome.plan.front() = ascendingOrder(problem.icebergCount());
        return outcome;
    }

private:
    SolverScript& m_script;
};

/** Returns an optimum found by trying every order, for at most 7 icebergs. */
inline SolveOutcome triedAll(const TvpProblem& problem)
{
    return {.status = SolveStatus::Optimal, .plan = {bruteForce(problem).order}};
}

/** Returns no order, because of a limit or a cancellation. */
inline SolveOutcome noOrder(StopReason reason)
{
    return {.status = SolveStatus::None, .reason = reason};
}

} // namespace berg::test
