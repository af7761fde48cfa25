#include "core/plan/fleet/fleet_solver.h"

#include "core/base/solving_guard.h"
#include "core/plan/fleet/fleet_bound.h"
#include "core/plan/fleet/fleet_costs.h"
#include "core/plan/fleet/fleet_ranks.h"
#include "core/plan/fleet/fleet_search.h"
#include "core/plan/fleet/fleet_subsets.h"
#include "core/plan/proof/certified.h"
#include "core/plan/solve/engine.h"
#include "core/plan/solve/names.h"
#include "core/plan/solve/solve_watch.h"
#ifdef BERG_WITH_CBC
#include "core/plan/fleet/cbc_cover.h"
#endif

#include <algorithm>
#include <limits>
#include <utility>

namespace berg {

namespace {

/**
 * Fraction (1 / this) of all work that goes into more local search while the proof is in progress.
 */
constexpr std::int64_t kSearchShare = 4;
/** Least length of an annealing. */
constexpr std::int64_t kLeastTimes = 2000;
/** Work of a removal and insertion, per iceberg. */
constexpr std::int64_t kWorkOfTime = 50;
/** Length of the first annealing, per iceberg, without a hint and with one; measured. */
constexpr std::int64_t kFirstTimes = 600;
constexpr std::int64_t kFirstTimesFromHint = 100;

constexpr std::int64_t kNoLimit = std::numeric_limits<std::int64_t>::max() / 4;

std::int64_t firstTimes(const SolveOptions& options)
{
    return options.hint.empty() ? kFirstTimes : kFirstTimesFromHint;
}

/** Runs one solve, in which local search and bound alternate. */
class FleetEngine
{
public:
    FleetEngine(const FleetProblem& problem, const SolveOptions& options,
                std::optional<std::int64_t> effort)
        : m_problem(problem)
        , m_options(options)
        , m_account(options, objectiveShift(problem), problem.icebergCount())
        , m_costs(problem)
        , m_backendLimit(effort.value_or(kNoLimit))
        , m_limit(std::min(m_backendLimit, options.workLimit.value_or(kNoLimit)))
        , m_search(m_costs, m_effort)
    {
        m_effort.isStopped = [this] { return m_account.isStopped(); };
        m_effort.limit = m_limit;
        m_search.onImproved = [this](const FleetPlan& plan) {
            m_account.acceptPlan(plan, fleetObjective(m_problem, plan));
        };
    }

    /** Returns whether dynamic programming is faster and keeps to the limits. */
    [[nodiscard]] bool subsetsSuffice() const
    {
        const int n = m_costs.icebergs();
        return n <= kMostFleetSubsets &&
               fleetSubsetWork(m_costs.uavs(), n) <= m_options.workLimit.value_or(kNoLimit) &&
               fleetSubsetBytes(m_costs.uavs(), n) + m_costs.bytes() <=
                   m_options.memoryLimit_bytes.value_or(kNoLimit);
    }

    SolveOutcome bySubsets()
    {
        const std::optional<FleetPlan> plan = bestFleetPlan(m_costs, m_effort.isStopped);
        if (!plan)
            return {.reason = *m_account.reason(), .plan = {}};
        m_search.accept(*plan);
        return {.status = SolveStatus::Optimal,
                .plan = *plan,
                .work = fleetSubsetWork(m_costs.uavs(), m_costs.icebergs()),
                .source = AnswerSource::Exact};
    }

    SolveOutcome byEngine(CoverFunction cover)
    {
        if (m_options.hint.empty())
            m_search.startGreedily();
        else
            m_search.complete(m_options.hint);
        m_search.descend();

        const std::int64_t before = m_effort.work;
        FleetBoundResult result;
        try {
            result = bound(cover, before);
            m_search.accept(result.plan);
            m_account.acceptBound(result.bound);
        } catch (const Error& error) { // the program of the cover failed: plan and bound stay
            if (error.code() != ErrorCode::SolverFailed)
                throw;
            m_failure = error.what();
        }
        return outcome(result, before + result.work);
    }

private:
    FleetBoundResult bound(CoverFunction cover, std::int64_t before)
    {
        return improveFleetBound(
            m_costs, m_search.best(),
            {.gap = m_options.gap,
             .workLimit = m_limit - before,
             .memoryLimit_bytes = m_options.memoryLimit_bytes.value_or(kNoLimit) - m_costs.bytes(),
             .cover = cover,
             .isStopped = m_effort.isStopped,
             .onImproved =
                 [this](const FleetPlan& plan, double bound) {
                     m_search.accept(plan);
                     m_account.acceptBound(bound);
                 },
             .suggest = [this](std::int64_t work,
                               std::int64_t most) { return suggest(work, most); }});
    }

    FleetSuggestion suggest(std::int64_t work, std::int64_t most)
    {
        const std::int64_t before = m_effort.work;
        m_effort.limit = before + most;
        const std::int64_t n = m_costs.icebergs();
        std::int64_t times = firstTimes(m_options) * n;
        if (m_searched) {
            times = (work / kSearchShare - (before - *m_searched)) / (kWorkOfTime * n);
            // Without a bound, only the search can improve the plan.
            if (!isBounded(m_costs))
                times = firstTimes(m_options) * n;
        } else if (m_options.inFlight) { // so that it has cooled down before the work is used up
            times = std::min(times, (m_limit - before) / 2 / (kWorkOfTime * n));
        }
        if (times >= kLeastTimes || !m_searched)
            m_search.disturb(times);
        if (!m_searched)
            m_searched = m_effort.work;
        return {.plan = m_search.best(), .work = m_effort.work - before};
    }

    SolveOutcome outcome(const FleetBoundResult& result, std::int64_t work)
    {
        SolveOutcome outcome{.status = SolveStatus::Feasible,
                             .plan = m_search.best(),
                             .bound = m_account.bound(),
                             .work = work,
                             .hintUsed = !m_options.hint.empty(),
                             .detail = m_failure};
        const double cost = m_costs.total(outcome.plan);
        if (result.reached && isProven(cost, result.bound))
            outcome.status = SolveStatus::Optimal;
        else if (result.reached)
            outcome.reason = StopReason::GapReached;
        else if (m_account.reason())
            outcome.reason = *m_account.reason();
        else if (!m_failure.empty())
            outcome.reason = StopReason::Unable;
        else if (result.memoryOut)
            outcome.reason = StopReason::MemoryLimit;
        else if (m_options.workLimit && *m_options.workLimit <= m_backendLimit)
            outcome.reason = StopReason::WorkLimit;
        return outcome;
    }

    const FleetProblem& m_problem;
    const SolveOptions& m_options;
    SolveAccount m_account;
    FleetCosts m_costs;
    std::int64_t m_backendLimit; ///< work limit of the back end itself
    std::int64_t m_limit;        ///< the smaller of that and the caller's limit
    SearchEffort m_effort;
    FleetSearch m_search;
    std::optional<std::int64_t> m_searched; ///< work of the first annealing, once it is done
    std::string m_failure;                  ///< message of a failed cover
};

/**
 * Returns the work limit of the back ends that must answer quickly; without a proof in prospect,
 * the work of a few annealings.
 */
std::int64_t ownEffort(const FleetProblem& problem, const SolveOptions& options)
{
    constexpr std::int64_t kAnnealings = 3;
    const std::int64_t n = problem.icebergCount();
    const std::int64_t responsive = responsiveEffort(problem.icebergCount(), options.inFlight);
    return problem.criterion == Criterion::Latency
               ? std::min(responsive, kAnnealings * firstTimes(options) * kWorkOfTime * n * n)
               : responsive;
}

/** Solves a problem in which distance has no weight. */
SolveOutcome byRanks(const FleetProblem& problem, const SolveOptions& options)
{
    const SolveWatch watch(options);
    const std::int64_t n = problem.icebergCount();
    FleetRanks ranks = bestRanks(problem, [&] { return watch.stopReason().has_value(); });
    SolveOutcome outcome{.status = ranks.isBest ? SolveStatus::Optimal : SolveStatus::Feasible,
                         .plan = std::move(ranks.plan),
                         .work = n * n * n * problem.uavCount(),
                         .source = AnswerSource::Assignment};
    if (!ranks.isBest)
        outcome.reason = watch.stopReason().value_or(StopReason::Finished);
    const double value = fleetObjective(problem, outcome.plan);
    watch.report(outcome.plan, value, ranks.isBest ? std::optional(value) : std::nullopt);
    return outcome;
}

/** The costs alone exceed the memory limit: the answer is the hint, or a quick plan. */
SolveOutcome withoutMemory(const FleetProblem& problem, const SolveOptions& options)
{
    const bool isPlan = isFleetPlan(problem, options.hint);
    return {.status = SolveStatus::Feasible,
            .reason = StopReason::MemoryLimit,
            .plan = isPlan ? options.hint : roundRobinPlan(problem),
            .hintUsed = isPlan};
}

CoverFunction coverOf(Backend backend)
{
    if (backend != Backend::Cbc)
        return bestCover;
#ifdef BERG_WITH_CBC
    return bestCoverByCbc;
#else
    throw Error(ErrorCode::Unsupported, "planner.backend", {IssueId::NoCbc});
#endif
}

SolveOutcome solveValid(const FleetProblem& problem, Backend backend, const SolveOptions& options)
{
    if (backend == Backend::Cbc && problem.criterion == Criterion::Latency)
        return unable({IssueId::CbcLatency});
    const bool mustProve = backend == Backend::Exact || backend == Backend::Cbc;
    if (mustProve && problem.icebergCount() > kMostProvenByEngine)
        return unable({IssueId::ProofTooLarge,
                       {nameOf(kBackendNames, backend), std::int64_t{kMostProvenByEngine}}});
    if (backend == Backend::Exact && problem.criterion == Criterion::Latency &&
        problem.icebergCount() > kMostFleetSubsets)
        return unable({IssueId::FleetLatencyProof, {std::int64_t{kMostFleetSubsets}}});
    if (options.stop.stop_requested())
        return {.reason = StopReason::Cancelled, .plan = {}};
    if (problem.icebergCount() == 0)
        return {.status = SolveStatus::Optimal,
                .plan = FleetPlan(static_cast<std::size_t>(problem.uavCount()))};
    if (problem.mu == 0 && problem.criterion == Criterion::Visitation &&
        problem.icebergCount() <= kMostProvenByEngine)
        return byRanks(problem, options);
    if (options.memoryLimit_bytes &&
        FleetCosts::mostBytesFor(problem) > *options.memoryLimit_bytes &&
        FleetCosts::bytesFor(problem) > *options.memoryLimit_bytes)
        return withoutMemory(problem, options);
    std::optional<std::int64_t> effort;
    if (!mustProve)
        effort = ownEffort(problem, options);
    FleetEngine engine(problem, options, effort);
    const bool subsets = backend == Backend::Exact || backend == Backend::Auto;
    if (subsets && engine.subsetsSuffice())
        return engine.bySubsets();
    return engine.byEngine(coverOf(backend));
}

/** Returns the valid part of a hint; empty if it has none. */
FleetPlan usablePart(const FleetProblem& problem, FleetPlan hint)
{
    if (static_cast<int>(hint.size()) != problem.uavCount())
        return {};
    hint = validPart(problem, std::move(hint));
    const bool nothing = std::ranges::all_of(hint, &VisitOrder::empty);
    return nothing ? FleetPlan{} : hint;
}

} // namespace

SolveOutcome solveFleet(const FleetProblem& problem, Backend backend, const SolveOptions& options)
{
    requireSolvingAllowed();
    const Stopwatch watch;
    if (std::vector<Issue> issues = validate(problem); !issues.empty())
        throw Error(ErrorCode::InvalidInput, "problem", std::move(issues));
    SolveOptions checked = options;
    checked.hint = usablePart(problem, std::move(checked.hint));
    SolveOutcome outcome = solveValid(problem, backend, checked);
    if (outcome.status != SolveStatus::None)
        outcome.objective = fleetObjective(problem, outcome.plan);
    if (outcome.status == SolveStatus::Optimal)
        outcome.bound = outcome.objective;
    else if (outcome.bound)
        outcome.bound = std::min(*outcome.bound, outcome.objective);
    if (outcome.source == AnswerSource::None)
        outcome.source = sourceOf(backend == Backend::Auto ? Backend::Heuristic : backend);
    outcome.elapsed_s = watch.elapsed_s();
    return outcome;
}

SolveOutcome solve(const FleetProblem& problem, Backend backend, const TvpSolver& alone,
                   const SolveOptions& options)
{
    if (problem.uavCount() == 0)
        return {.status = SolveStatus::Optimal, .bound = 0.0, .source = sourceOf(backend)};
    if (problem.uavCount() > 1)
        return solveFleet(problem, backend, options);
    SolveOptions withHint = options;
    withHint.hint = usablePart(problem, std::move(withHint.hint));
    // Icebergs that the last plan did not hold (new, or then in view) go to the end of the hint.
    for (VisitOrder& order : withHint.hint)
        for (int node = 1; node <= problem.icebergCount(); ++node)
            if (std::ranges::find(order, node) == order.end())
                order.push_back(node);
    return alone.solve(problemOfUav(problem, 0), withHint);
}

} // namespace berg
