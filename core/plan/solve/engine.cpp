#include "core/plan/solve/engine.h"

#include "core/plan/proof/certified.h"
#include "core/plan/proof/layered_bound.h"
#include "core/plan/proof/multiplier_ascent.h"
#include "core/plan/solve/names.h"
#include "core/plan/solve/order_search.h"
#include "core/plan/solve/solve_watch.h"
#include "core/plan/solve/subset_solver.h"

#include <algorithm>
#include <limits>

namespace berg {

namespace {

/** Largest problems that dynamic programming solves faster; measured by bench_solvers. */
constexpr int kMostBySubsets = 14;
constexpr int kMostLatencyBySubsets = 16;
/** Work of one restart of the local search, per iceberg squared; measured. */
constexpr std::int64_t kWorkOfRestart = 11;
/**
 * Fraction (1 / this) of all work that goes into more local search while the proof is in progress.
 */
constexpr std::int64_t kSearchShare = 10;
/** That fraction for a re-plan in flight, before the bound: the order at hand is a good one. */
constexpr std::int64_t kSearchShareInFlight = 3;
/** Steps of the first relaxation in flight, with multipliers of the last plan; measured. */
constexpr std::int64_t kStepsInFlight = 80;
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

/** Runs one solve, in which local search and bound alternate. */
template <class Costs>
class Engine
{
public:
    Engine(const TvpProblem& problem, const SolveOptions& options,
           std::optional<std::int64_t> effort)
        : m_problem(problem)
        , m_options(options)
        , m_account(options, objectiveShift(problem), problem.icebergCount())
        , m_costs(problem)
        , m_backendLimit(effort.value_or(std::numeric_limits<std::int64_t>::max()))
        , m_search(m_costs, m_effort)
    {
        m_effort.isStopped = [this] { return m_account.isStopped(); };
        m_effort.limit = mostWork();
        m_search.onImproved = [this](const VisitOrder& order) {
            m_account.acceptPlan({order}, objective(m_problem, order));
        };
    }

    SolveOutcome run()
    {
        if (m_options.hint.empty())
            m_search.startGreedily();
        else
            m_search.accept(m_options.hint.front());
        m_search.descend();
        if (m_options.inFlight && !m_options.hint.empty())
            searchFromHint();

        LayeredBoundOptions options;
        options.gap = m_options.gap;
        if (static_cast<int>(m_options.multipliers.size()) == m_costs.icebergs + 1) {
            options.lambda = firstMultipliers(m_costs, m_search.best());
            *options.lambda += Eigen::Map<const Eigen::VectorXd>(m_options.multipliers.data(),
                                                                 m_costs.icebergs + 1);
            options.warmSteps = kStepsInFlight;
        }
        if constexpr (Costs::kWeighted)
            options.manyArcs = kManyLatencyArcs;
        options.workLimit = mostWork() - m_effort.work;
        options.memoryLimit_bytes =
            m_options.memoryLimit_bytes.value_or(std::numeric_limits<std::int64_t>::max() / 4);
        options.isStopped = m_effort.isStopped;
        options.onImproved = [this](const VisitOrder& order, double bound) {
            m_search.accept(order);
            m_account.acceptBound(bound);
        };
        options.suggest = [this](std::int64_t work, std::int64_t most) {
            return suggest(work, most);
        };
        const std::int64_t before = m_effort.work;
        const BoundResult result = improveBound(m_costs, m_search.best(), options);
        m_search.accept(result.order);
        m_account.acceptBound(result.bound);
        return outcome(result, before + result.work);
    }

private:
    [[nodiscard]] std::int64_t mostWork() const
    {
        return std::min(m_backendLimit, m_options.workLimit.value_or(m_backendLimit));
    }

    /** Replaces the first search of `suggest`. */
    void searchFromHint()
    {
        const std::int64_t n = m_costs.icebergs;
        const std::int64_t share = (mostWork() - m_effort.work) / kSearchShareInFlight;
        m_search.disturb(std::min(firstRestarts(n), share / (kWorkOfRestart * n * n)));
        m_searched = m_effort.work;
    }

    OrderSuggestion suggest(std::int64_t work, std::int64_t most)
    {
        const std::int64_t before = m_effort.work;
        m_effort.limit = before + most;
        const std::int64_t n = m_costs.icebergs;
        if (!m_searched) {
            m_search.descendFromGreedyOrders();
            m_search.disturb(firstRestarts(n));
            m_searched = m_effort.work;
        } else {
            const std::int64_t due = work / kSearchShare - (before - *m_searched);
            if (const std::int64_t restarts = due / (kWorkOfRestart * n * n);
                restarts >= kLeastRestarts)
                m_search.disturb(restarts);
        }
        return {.order = m_search.best(), .work = m_effort.work - before};
    }

    SolveOutcome outcome(const BoundResult& result, std::int64_t work)
    {
        SolveOutcome outcome{.status = SolveStatus::Feasible,
                             .plan = {m_search.best()},
                             .bound = m_account.bound(),
                             .work = work,
                             .hintUsed = !m_options.hint.empty()};
        const Eigen::VectorXd learnt = result.lambda - firstMultipliers(m_costs, outcome.order());
        outcome.multipliers.assign(learnt.begin(), learnt.end());
        const double cost = m_costs.total(outcome.order());
        if (result.reached && isProven(cost, result.bound))
            outcome.status = SolveStatus::Optimal;
        else if (result.reached)
            outcome.reason = StopReason::GapReached;
        else if (m_account.reason())
            outcome.reason = *m_account.reason();
        else if (result.memoryOut)
            outcome.reason = StopReason::MemoryLimit;
        else if (m_options.workLimit && *m_options.workLimit <= m_backendLimit &&
                 (m_costs.icebergs <= kMostProvenByEngine || work >= *m_options.workLimit))
            outcome.reason = StopReason::WorkLimit;
        return outcome;
    }

    const TvpProblem& m_problem;
    const SolveOptions& m_options;
    SolveAccount m_account;
    Costs m_costs;
    std::int64_t m_backendLimit; ///< work limit of the back end itself
    SearchEffort m_effort;
    OrderSearch<Costs> m_search;
    std::optional<std::int64_t> m_searched; ///< work of the first local search, once it is done
};

} // namespace

SolveOutcome solveByEngine(const TvpProblem& problem, const SolveOptions& options,
                           std::optional<std::int64_t> effort)
{
    if (problem.mu > 0)
        return problem.criterion == Criterion::Latency
                   ? Engine<LatencyCosts>(problem, options, effort).run()
                   : Engine<VisitCosts>(problem, options, effort).run();

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
