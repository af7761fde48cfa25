#include "core/plan/fleet/fleet_solver.h"

#include "core/base/solving_guard.h"
#include "core/plan/fleet/fleet_bound.h"
#include "core/plan/fleet/fleet_costs.h"
#include "core/plan/fleet/fleet_ranks.h"
#include "core/plan/fleet/fleet_search.h"
#include "core/plan/fleet/fleet_subsets.h"
#include "core/plan/solve/engine.h"
#include "core/plan/solve/engine_loop.h"
#include "core/plan/solve/names.h"
#ifdef BERG_WITH_CBC
#include "core/plan/fleet/cbc_cover.h"
#endif

#include <algorithm>
#include <utility>

namespace berg {

namespace {

constexpr std::int64_t kSearchShare = 4; ///< see `EngineLoop`
/** Least length of an annealing. */
constexpr std::int64_t kLeastTimes = 2000;
/** Work of a removal and insertion, per iceberg. */
constexpr std::int64_t kWorkOfTime = 50;
/** Length of the first annealing, per iceberg, without a hint and with one; measured. */
constexpr std::int64_t kFirstTimes = 600;
constexpr std::int64_t kFirstTimesFromHint = 100;

std::int64_t firstTimes(const SolveOptions& options)
{
    return options.hint.empty() ? kFirstTimes : kFirstTimesFromHint;
}

class FleetEngine final : EngineLoop
{
public:
    FleetEngine(const FleetProblem& problem, const SolveOptions& options, CoverFunction cover,
                std::optional<std::int64_t> effort)
        : EngineLoop(options, problem.icebergCount(), objectiveShift(problem), effort, kSearchShare)
        , m_costs(problem)
        , m_cover(cover)
        , m_search(m_costs, m_effort)
    {
        m_search.onImproved = [this, &problem](const FleetPlan& plan) {
            storePlan(plan, fleetObjective(problem, plan));
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
            return {.reason = *m_reason, .plan = {}};
        m_search.accept(*plan);
        return {.status = SolveStatus::Optimal,
                .plan = *plan,
                .work = fleetSubsetWork(m_costs.uavs(), m_costs.icebergs()),
                .source = AnswerSource::Exact};
    }

    using EngineLoop::run;

private:
    void start() override
    {
        if (m_options.hint.empty())
            m_search.startGreedily();
        else
            m_search.complete(m_options.hint);
        m_search.descend();
    }
    void searchFirst() override
    {
        std::int64_t times = firstTimes(m_options) * m_icebergs;
        if (m_options.inFlight) // so that it has cooled down before the work is used up
            times = std::min(times, (m_limit - m_effort.work) / 2 / (kWorkOfTime * m_icebergs));
        m_search.disturb(times);
    }
    void searchMore(std::int64_t work) override
    {
        // Without a bound, only the search can improve the plan.
        const std::int64_t times = isBounded(m_costs) ? work / (kWorkOfTime * m_icebergs)
                                                      : firstTimes(m_options) * m_icebergs;
        if (times >= kLeastTimes)
            m_search.disturb(times);
    }
    void accept(const FleetPlan& plan) override { m_search.accept(plan); }
    [[nodiscard]] double costOf(const FleetPlan& plan) const override
    {
        return m_costs.total(plan);
    }

    [[nodiscard]] BoundResult improve(const BoundOptions& options) override
    {
        BoundOptions left = options;
        left.memoryLimit_bytes -= m_costs.bytes();
        try {
            return improveFleetBound(m_costs, m_plan, left, {.cover = m_cover});
        } catch (const Error& error) { // the program of the cover failed: plan and bound stay
            if (error.code() != ErrorCode::SolverFailed)
                throw;
            m_failure = error.what();
            return {.plan = m_plan};
        }
    }

    FleetCosts m_costs;
    CoverFunction m_cover;
    FleetSearch m_search;
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
    FleetEngine engine(problem, options, coverOf(backend), effort);
    const bool subsets = backend == Backend::Exact || backend == Backend::Auto;
    return subsets && engine.subsetsSuffice() ? engine.bySubsets() : engine.run();
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
        for (const NodeIndex node : icebergNodes(problem.icebergCount()))
            if (std::ranges::find(order, node) == order.end())
                order.push_back(node);
    return alone.solve(problemOfUav(problem, 0), withHint);
}

} // namespace berg
