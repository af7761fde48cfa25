#include "core/plan/solve/cbc_solver.h"

#include "core/plan/solve/cbc_helper.h"
#include "core/plan/solve/names.h"
#include "core/plan/solve/solve_watch.h"

#include <stdexcept>

namespace berg {

namespace {

/** What is known of a solve by the helper, until it has answered. */
class CbcSolve
{
public:
    explicit CbcSolve(const CbcProblem& asked)
        : m_asked(asked), m_watch(asked.options), m_known{.status = SolveStatus::None, .plan = {}}
    {
        takePlan(asked.options.hint);
        m_known.hintUsed = !asked.options.hint.empty();
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
        const CbcCut cut = [this] { return m_asked.options.stop.stop_requested() || isOverdue(); };
        CbcHelper helper;
        if (!helper.ask(cbcFrame(m_asked), cut))
            return stopped();
        while (const std::optional<CbcFrame> frame = helper.answer(cut)) {
            if (frame->kind == CbcFrameKind::Failure) {
                const CbcFailure failure = cbcFailureOf(*frame);
                return unable(failure.words,
                              failure.isOutOfMemory ? StopReason::MemoryLimit : StopReason::Unable);
            }
            if (frame->kind != CbcFrameKind::Progress)
                return cbcOutcomeOf(*frame, m_asked.problem);
            const SolveProgress progress = cbcProgressOf(*frame, m_asked.problem);
            takePlan(progress.plan);
            m_known.bound = progress.bound;
            if (!progress.plan.empty())
                m_watch.report(progress.plan, progress.objective, progress.bound);
        }
        return stopped();
    }

    /** It ends at the time limit by itself, unless it is stuck. */
    [[nodiscard]] bool isOverdue() const
    {
        constexpr double kGrace_s = 1;
        const std::optional<double> limit_s = m_asked.options.timeLimit_s;
        return limit_s && m_clock.elapsed_s() > *limit_s + kGrace_s;
    }

    [[nodiscard]] SolveOutcome stopped()
    {
        const bool isCancelled = m_asked.options.stop.stop_requested();
        return ended(isCancelled ? StopReason::Cancelled : StopReason::TimeLimit, "CBC: stopped");
    }

    void takePlan(const FleetPlan& plan)
    {
        if (plan.empty())
            return;
        m_known.plan = plan;
        m_known.status = SolveStatus::Feasible;
    }

    [[nodiscard]] SolveOutcome ended(StopReason reason, const std::string& detail)
    {
        m_known.reason = reason;
        m_known.detail = detail;
        return m_known;
    }

    /** It ended without an answer: what it told until then, if that is an order. */
    [[nodiscard]] SolveOutcome unable(const std::string& why,
                                      StopReason reason = StopReason::Unable)
    {
        if (m_known.plan.empty() && reason == StopReason::Unable)
            throw Error(ErrorCode::SolverFailed, "cbc", why);
        return ended(reason, why);
    }

    const CbcProblem& m_asked;
    Stopwatch m_clock;
    SolveWatch m_watch;
    SolveOutcome m_known;
};

/** Icebergs that it is offered for. */
int largestOf(Formulation formulation)
{
    switch (formulation) {
    case Formulation::Position: // 80 MB and about ten seconds for the first relaxation
        return 40;
    case Formulation::Printed: // small (n^2 columns), but beyond 8 its search takes for ever
    case Formulation::Reduced: // as far as our bound leaves few columns
        return 60;
    }
    throw std::logic_error("CbcSolver: no such formulation");
}

} // namespace

CbcSolver::CbcSolver(Formulation formulation) : m_formulation(formulation) {}

std::optional<IssueReason> CbcSolver::whyNot(const TvpProblem& problem) const
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
    const CbcProblem asked{.formulation = m_formulation, .problem = problem, .options = options};
    return CbcSolve(asked).outcome();
}

} // namespace berg
