#include "core/plan/solve/solver.h"

#include "core/base/solving_guard.h"
#include "core/plan/solve/engine.h"
#ifdef BERG_WITH_CBC
#include "core/plan/solve/cbc_helper.h"
#include "core/plan/solve/cbc_solver.h"
#endif

#include <algorithm>
#include <chrono>

namespace berg {

namespace {

std::int64_t now_ns()
{
    return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

/** Uses dynamic programming where that is faster, else the engine with about a second's work. */
class AutoSolver final : public TvpSolver
{
public:
    [[nodiscard]] AnswerSource source() const override { return AnswerSource::Auto; }

protected:
    [[nodiscard]] SolveOutcome doSolve(const TvpProblem& problem,
                                       const SolveOptions& options) const override
    {
        if (subsetsAreFaster(problem, options))
            return m_exact.solve(problem, options);
        return m_heuristic.solve(problem, options);
    }

private:
    ExactSolver m_exact;
    LocalSearch m_heuristic;
};

bool isPlan(const TvpProblem& problem, const FleetPlan& plan)
{
    return plan.size() == 1 && isVisitOrder(problem, plan.front());
}

/** Completes the answer of a back end as `SolveOutcome` promises. */
void completeOutcome(const TvpProblem& problem, SolveOutcome& outcome)
{
    if (outcome.status == SolveStatus::None) {
        outcome.plan.clear();
        outcome.objective = 0;
        return;
    }
    require(isPlan(problem, outcome.plan), "solver returned an invalid visiting order");
    outcome.objective = objective(problem, outcome.order());
    if (outcome.status == SolveStatus::Optimal)
        outcome.bound = outcome.objective;
    else if (outcome.bound)
        outcome.bound = std::min(*outcome.bound, outcome.objective);
}

} // namespace

const VisitOrder& SolveOutcome::order() const
{
    static const VisitOrder kNone;
    return plan.empty() ? kNone : plan.front();
}

Stopwatch::Stopwatch() : m_start_ns(now_ns()) {}

double Stopwatch::elapsed_s() const
{
    return static_cast<double>(now_ns() - m_start_ns) * 1e-9;
}

SolveOutcome unable(IssueReason reason)
{
    SolveOutcome outcome{.reason = StopReason::Unable, .plan = {}, .detail = englishText(reason)};
    outcome.whyUnable = std::move(reason);
    return outcome;
}

SolveOutcome TvpSolver::solve(const TvpProblem& problem, const SolveOptions& options) const
{
    requireSolvingAllowed();
    const Stopwatch watch;
    if (std::vector<Issue> issues = validate(problem); !issues.empty())
        throw Error(ErrorCode::InvalidInput, "problem", std::move(issues));

    SolveOutcome outcome;
    if (problem.icebergCount() == 0) {
        outcome = {.status = SolveStatus::Optimal, .plan = FleetPlan(1), .bound = 0.0};
    } else if (std::optional<IssueReason> reason = unsupportedReason(problem)) {
        outcome = unable(std::move(*reason));
    } else if (options.stop.stop_requested()) {
        outcome = {.reason = StopReason::Cancelled, .plan = {}};
    } else if (options.hint.empty() || isPlan(problem, options.hint)) {
        outcome = doSolve(problem, options);
    } else {
        SolveOptions withoutHint = options;
        withoutHint.hint.clear();
        outcome = doSolve(problem, withoutHint);
    }
    completeOutcome(problem, outcome);
    if (outcome.source == AnswerSource::None)
        outcome.source = source();
    outcome.elapsed_s = watch.elapsed_s();
    return outcome;
}

std::unique_ptr<TvpSolver> makeSolver(Backend backend, [[maybe_unused]] Formulation formulation)
{
    switch (backend) {
    case Backend::Auto:
        return std::make_unique<AutoSolver>();
    case Backend::Exact:
        return std::make_unique<ExactSolver>();
    case Backend::Heuristic:
        return std::make_unique<LocalSearch>();
    case Backend::Cbc:
#ifdef BERG_WITH_CBC
        static_cast<void>(cbcHelperPath()); // throws at once if the program is missing
        return std::make_unique<CbcSolver>(formulation);
#else
        throw Error(ErrorCode::Unsupported, "planner.backend", {IssueId::NoCbc});
#endif
    }
    throw std::logic_error("makeSolver: unknown back end");
}

} // namespace berg
