#include "core/plan/solve/cbc_solver.h"

#include "core/plan/solve/cbc_helper.h"
#include "core/plan/solve/names.h"
#include "core/plan/solve/solve_watch.h"

#include <stdexcept>

namespace berg {

namespace {

/** Runs a solve by the helper and keeps the best known plan and bound until it has answered. */
class CbcSolve
{
public:
    explicit CbcSolve(const CbcProblem& request)
        : m_request(request)
        , m_watch(request.options)
        , m_partial{.status = SolveStatus::None, .plan = {}}
    {
        acceptPlan(request.options.hint);
        m_partial.hintUsed = !request.options.hint.empty();
    }

    [[nodiscard]] SolveOutcome outcome()
    {
        try {
            return answered();
        } catch (const CbcWireFault& fault) {
            return unable(std::string("bergwatch-cbc: ") + fault.what());
        }
    }

private:
    [[nodiscard]] SolveOutcome answered()
    {
        const CbcStopCheck isStopped = [this] {
            return m_request.options.stop.stop_requested() || isOverdue();
        };
        CbcHelper helper;
        if (!helper.sendRequest(cbcFrame(m_request), isStopped))
            return stopped();
        while (const std::optional<CbcFrame> frame = helper.answer(isStopped)) {
            if (frame->kind == CbcFrameKind::Failure) {
                const CbcFailure failure = cbcFailureOf(*frame);
                return unable(failure.words,
                              failure.isOutOfMemory ? StopReason::MemoryLimit : StopReason::Unable);
            }
            if (frame->kind != CbcFrameKind::Progress)
                return cbcOutcomeOf(*frame, m_request.problem);
            const SolveProgress progress = cbcProgressOf(*frame, m_request.problem);
            acceptPlan(progress.plan);
            m_partial.bound = progress.bound;
            if (!progress.plan.empty())
                m_watch.report(progress.plan, progress.objective, progress.bound);
        }
        return stopped();
    }

    /** Returns whether the helper is stuck: normally it ends at the time limit by itself. */
    [[nodiscard]] bool isOverdue() const
    {
        constexpr double kGrace_s = 1;
        const std::optional<double> limit_s = m_request.options.timeLimit_s;
        return limit_s && m_clock.elapsed_s() > *limit_s + kGrace_s;
    }

    [[nodiscard]] SolveOutcome stopped()
    {
        const bool isCancelled = m_request.options.stop.stop_requested();
        return ended(isCancelled ? StopReason::Cancelled : StopReason::TimeLimit, "CBC: stopped");
    }

    void acceptPlan(const FleetPlan& plan)
    {
        if (plan.empty())
            return;
        m_partial.plan = plan;
        m_partial.status = SolveStatus::Feasible;
    }

    [[nodiscard]] SolveOutcome ended(StopReason reason, const std::string& detail)
    {
        m_partial.reason = reason;
        m_partial.detail = detail;
        return m_partial;
    }

    /**
     * Returns the best plan reported before the helper ended without an answer. Throws
     * `Error{SolverFailed}` if there is none.
     */
    [[nodiscard]] SolveOutcome unable(const std::string& why,
                                      StopReason reason = StopReason::Unable)
    {
        if (m_partial.plan.empty() && reason == StopReason::Unable)
            throw Error(ErrorCode::SolverFailed, "cbc", why);
        return ended(reason, why);
    }

    const CbcProblem& m_request;
    Stopwatch m_clock;
    SolveWatch m_watch;
    SolveOutcome m_partial;
};

/** Returns the largest number of icebergs for which the formulation is used. */
int largestOf(Formulation formulation)
{
    switch (formulation) {
    case Formulation::Position: // 80 MB and about ten seconds for the first relaxation
        return 40;
    case Formulation::Printed: // small (n^2 columns), but beyond 8 its search takes too long
    case Formulation::Reduced: // as long as our bound leaves few columns
        return 60;
    }
    throw std::logic_error("CbcSolver: unknown formulation");
}

} // namespace

CbcSolver::CbcSolver(Formulation formulation) : m_formulation(formulation) {}

std::optional<IssueReason> CbcSolver::unsupportedReason(const TvpProblem& problem) const
{
    if (problem.criterion != Criterion::Visitation)
        return IssueReason{IssueId::CbcLatency};
    const int largest = largestOf(m_formulation);
    if (problem.icebergCount() <= largest)
        return std::nullopt;
    return IssueReason{IssueId::MilpTooLarge,
                       {nameOf(kFormulationNames, m_formulation), std::int64_t{largest},
                        std::int64_t{problem.icebergCount()}}};
}

SolveOutcome CbcSolver::doSolve(const TvpProblem& problem, const SolveOptions& options) const
{
    const CbcProblem request{.formulation = m_formulation, .problem = problem, .options = options};
    return CbcSolve(request).outcome();
}

} // namespace berg
