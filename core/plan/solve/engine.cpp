#include "core/plan/solve/engine.h"

#include "core/plan/proof/layered_bound.h"
#include "core/plan/proof/multiplier_ascent.h"
#include "core/plan/solve/engine_loop.h"
#include "core/plan/solve/names.h"
#include "core/plan/solve/order_search.h"
#include "core/plan/solve/subset_solver.h"

#include <algorithm>

namespace berg {

namespace {

/** Largest problems that dynamic programming solves faster; measured by bench_solvers. */
constexpr int kMostBySubsets = 14;
constexpr int kMostLatencyBySubsets = 16;
/** Work of one restart of the local search, per iceberg squared; measured. */
constexpr std::int64_t kWorkOfRestart = 11;
constexpr std::int64_t kSearchShare = 10; ///< see `EngineLoop`
/** Share for a re-plan in flight, whose present order is good already. */
constexpr std::int64_t kSearchShareInFlight = 3;
/** Steps of the first relaxation in flight, with multipliers of the last plan; measured. */
constexpr int kStepsInFlight = 80;
/** Fewer additional restarts than this are not worthwhile. */
constexpr std::int64_t kLeastRestarts = 50;

/** `LayeredBoundOptions::manyArcs` for latency, whose graphs are larger, and shrink sooner. */
constexpr std::int64_t kManyLatencyArcs = 6'000'000;

/**
 * Returns the number of first restarts from a disturbed order: they find the optimum in nine cases
 * of ten at 40 icebergs.
 */
std::int64_t firstRestarts(std::int64_t icebergs)
{
    return std::max<std::int64_t>(10, std::min(icebergs * icebergs / 8, 150'000 / icebergs));
}

template <class Costs>
class Engine final : EngineLoop
{
public:
    Engine(const TvpProblem& problem, const SolveOptions& options,
           std::optional<std::int64_t> effort)
        : EngineLoop(options, problem.icebergCount(), objectiveShift(problem), effort, kSearchShare)
        , m_costs(problem)
        , m_search(m_costs, m_effort)
    {
        m_search.onImproved = [this, &problem](const VisitOrder& order) {
            storePlan({order}, objective(problem, order));
        };
    }

    SolveOutcome solve()
    {
        SolveOutcome outcome = run();
        const Eigen::VectorXd learnt = m_lambda - firstMultipliers(m_costs, outcome.order());
        outcome.multipliers.assign(learnt.begin(), learnt.end());
        return outcome;
    }

private:
    void start() override
    {
        if (m_options.hint.empty())
            m_search.startGreedily();
        else
            m_search.accept(m_options.hint.front());
        m_search.descend();
        if (m_options.inFlight && !m_options.hint.empty()) { // replaces the first search
            const std::int64_t share = (m_limit - m_effort.work) / kSearchShareInFlight;
            m_search.disturb(std::min(firstRestarts(m_icebergs), share / workOfRestart()));
            m_searched = m_effort.work;
        }
    }
    void searchFirst() override
    {
        m_search.descendFromGreedyOrders();
        m_search.disturb(firstRestarts(m_icebergs));
    }
    void searchMore(std::int64_t work) override
    {
        if (const std::int64_t restarts = work / workOfRestart(); restarts >= kLeastRestarts)
            m_search.disturb(restarts);
    }
    [[nodiscard]] std::int64_t workOfRestart() const
    {
        return kWorkOfRestart * m_icebergs * m_icebergs;
    }
    void accept(const FleetPlan& plan) override { m_search.accept(plan.front()); }
    [[nodiscard]] double costOf(const FleetPlan& plan) const override
    {
        return m_costs.total(plan.front());
    }

    [[nodiscard]] BoundResult improve(const BoundOptions& options) override
    {
        LayeredBoundOptions layered;
        if (static_cast<std::int64_t>(m_options.multipliers.size()) == m_icebergs + 1) {
            layered.lambda = firstMultipliers(m_costs, m_search.best());
            *layered.lambda +=
                Eigen::Map<const Eigen::VectorXd>(m_options.multipliers.data(), m_icebergs + 1);
            layered.warmSteps = kStepsInFlight;
        }
        if constexpr (Costs::kWeighted)
            layered.manyArcs = kManyLatencyArcs;
        BoundResult result = improveBound(m_costs, m_search.best(), options, layered);
        m_lambda = result.step.lambda;
        return result;
    }

    Costs m_costs;
    OrderSearch<Costs> m_search;
    Eigen::VectorXd m_lambda; ///< multipliers of the bound
};

} // namespace

SolveOutcome solveByEngine(const TvpProblem& problem, const SolveOptions& options,
                           std::optional<std::int64_t> effort)
{
    if (problem.mu > 0)
        return problem.criterion == Criterion::Latency
                   ? Engine<LatencyCosts>(problem, options, effort).solve()
                   : Engine<VisitCosts>(problem, options, effort).solve();

    SolveOutcome outcome{.status = SolveStatus::Optimal, .plan = {sigmaOrder(problem)}};
    const double value = objective(problem, outcome.order());
    SolveWatch(options).report(outcome.plan, value, value);
    return outcome;
}

std::int64_t responsiveEffort(int icebergs, bool inFlight)
{
    constexpr std::int64_t kShareInFlight = 15;
    // With many icebergs the plain relaxation takes longer to pay.
    const std::int64_t effort = icebergs <= kMostProvenByEngine ? 900'000'000 : 2'000'000'000;
    return inFlight ? effort / kShareInFlight : effort;
}

bool subsetsAreFaster(const TvpProblem& problem, const SolveOptions& options)
{
    const int n = problem.icebergCount();
    const int most =
        problem.criterion == Criterion::Latency ? kMostLatencyBySubsets : kMostBySubsets;
    return n <= most && problem.mu > 0 &&
           SubsetSolver::workFor(n) <= options.workLimit.value_or(SubsetSolver::workFor(n)) &&
           SubsetSolver::bytesFor(n) <=
               options.memoryLimit_bytes.value_or(SubsetSolver::bytesFor(n));
}

std::optional<IssueReason> ExactSolver::unsupportedReason(const TvpProblem& problem) const
{
    if (problem.icebergCount() <= kMostProvenByEngine || problem.mu == 0)
        return std::nullopt;
    return IssueReason{IssueId::ProofTooLarge,
                       {nameOf(kBackendNames, Backend::Exact), std::int64_t{kMostProvenByEngine}}};
}

SolveOutcome ExactSolver::doSolve(const TvpProblem& problem, const SolveOptions& options) const
{
    if (subsetsAreFaster(problem, options)) {
        SolveOutcome outcome = SubsetSolver().solve(problem, options);
        outcome.source = source();
        return outcome;
    }
    return solveByEngine(problem, options, std::nullopt);
}

SolveOutcome LocalSearch::doSolve(const TvpProblem& problem, const SolveOptions& options) const
{
    return solveByEngine(problem, options,
                         responsiveEffort(problem.icebergCount(), options.inFlight));
}

} // namespace berg
