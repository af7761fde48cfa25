#include "core/coverage/coverage_policy.h"

#include "core/coverage/coverage_effort.h"
#include "core/coverage/coverage_fleet.h"
#include "core/coverage/coverage_search.h"
#include "core/coverage/described_plan.h"
#include "core/plan/solve/tuning.h"

#include <algorithm>
#include <numeric>

namespace berg {

namespace {

CoverageSearch searchFor(const CoverageModel& model, const FlightPicture& picture)
{
    const std::uint64_t stream = stableHash("coverage") + static_cast<std::uint64_t>(picture.step);
    return CoverageSearch(model, Random(picture.seed, stream));
}

/** All icebergs, for the only UAV. */
TvpProblem wholeProblem(const PlanRequest& request)
{
    return {.distance_m = request.uavs.front().distance_m, .sigma_m2 = request.sigma_m2};
}

/** Greedy, the paper's order, that of least waiting, and the shortest tour, either way round. */
std::vector<CoveragePlan> firstPlans(const PlanRequest& request, const SolveOptions& limits)
{
    constexpr double kTau = 1;
    const std::unique_ptr<TvpSolver> solver = makeSolver(Backend::Auto);
    TvpProblem problem = wholeProblem(request);
    problem.mu = tuningWeight(problem, kTau).mu;
    const VisitOrder order = solver->solve(problem, limits).order();
    problem.mu = 1;
    VisitOrder soonest;
    if (*std::max_element(problem.sigma_m2.begin(), problem.sigma_m2.end()) > 0) {
        problem.criterion = Criterion::Latency;
        soonest = solver->solve(problem, limits).order();
        problem.criterion = Criterion::Visitation;
    }
    std::fill(problem.sigma_m2.begin(), problem.sigma_m2.end(), 0.0);
    problem.route = Route::Closed;
    VisitOrder tour = solver->solve(problem, limits).order();
    const CoveragePlan there = straightPlan(tour, kRounds);
    std::reverse(tour.begin(), tour.end());
    return {
        {}, straightPlan(order, 1), straightPlan(soonest, 1), there, straightPlan(tour, kRounds)};
}

/** Of a plan and its prediction; the solve that found it is the caller's to tell of. */
PlanAnswer answerOf(const CoverageModel& model, const PlanRequest& request,
                    const CoverageResult& found)
{
    const UavRequest& uav = request.uavs.front();
    DescribedPlan described = describe(model, uav, request.ids, found.plan);
    const TvpProblem problem = restrictedTo(wholeProblem(request), described.nodes);
    VisitOrder order(described.nodes.size());
    std::iota(order.begin(), order.end(), 1);
    PlanAnswer answer{.outcome = {.objective = objective(problem, order)},
                      .problem = problemOf(problem),
                      .predictedZeta_m2s = found.total_m2s,
                      .distance_m = flownDistance(problem, order)};
    if (!described.outlook.sightings_s.empty())
        answer.distance_m =
            request.speed_mps * (described.outlook.sightings_s.back() - uav.picture->time_s);
    for (const int node : described.nodes)
        answer.solvedIds.push_back(request.ids[static_cast<std::size_t>(node - 1)]);
    answer.uavs = {{.order = answer.solvedIds,
                    .legs = std::move(described.legs),
                    .outlook = std::move(described.outlook)}};
    answer.outcome.plan = {std::move(order)};
    return answer;
}

/** Tells whoever made the request of better plans, a few tens a second at most. */
class ProgressTeller
{
public:
    ProgressTeller(const CoverageModel& model, const PlanRequest& request,
                   const SolveOptions& options)
        : m_model(model), m_request(request), m_options(options)
    {
    }

    void operator()(const CoverageResult& better)
    {
        constexpr double kBetween_s = 0.02;
        const double elapsed_s = m_clock.elapsed_s();
        if (elapsed_s < m_next_s)
            return;
        m_next_s = elapsed_s + kBetween_s;
        PlanAnswer answer = answerOf(m_model, m_request, better);
        m_options.onProgress({.plan = {std::move(answer.uavs.front().order)},
                              .objective = better.total_m2s,
                              .elapsed_s = elapsed_s,
                              .legs = {std::move(answer.uavs.front().legs)}});
    }

private:
    const CoverageModel& m_model;
    const PlanRequest& m_request;
    const SolveOptions& m_options;
    Stopwatch m_clock;
    double m_next_s = 0;
};

/** Predicted zeta minimised over sequences of icebergs and aim points. */
class CoveragePolicy final : public Policy
{
public:
    PlanAnswer plan(const PlanRequest& request, const SolveOptions& options) override;

private:
    [[nodiscard]] PlanAnswer planOfOne(const PlanRequest& request, const SolveOptions& options);
    [[nodiscard]] static CoverageResult first(CoverageSearch& search, const PlanRequest& request,
                                              const SolveOptions& options, const SolveWatch& watch);
    [[nodiscard]] CoverageResult next(CoverageSearch& search, const PlanRequest& request,
                                      bool warmStart, const SolveOptions& options,
                                      const SolveWatch& watch) const;

    KeptPlan m_last; ///< the plan that is flown; empty: none yet
    bool m_isOfSeveral = false;
    CoverageFleet m_fleet;
};

CoverageResult CoveragePolicy::first(CoverageSearch& search, const PlanRequest& request,
                                     const SolveOptions& options, const SolveWatch& watch)
{
    const std::int64_t work = options.workLimit.value_or(kFirstWork);
    const auto share = static_cast<std::int64_t>(kShareOfStart * static_cast<double>(work));
    const SolveOptions limits{.timeLimit_s = options.timeLimit_s,
                              .workLimit = std::min(kOrderWork, work),
                              .stop = options.stop};
    std::optional<CoverageResult> best;
    for (const CoveragePlan& start : firstPlans(request, limits)) {
        const CoverageResult found =
            search.improved(search.completed(start), search.work() + share, kHeat, watch);
        if (!best || found.total_m2s < best->total_m2s)
            best = found;
    }
    return search.improved(*best, work, kHeat, watch);
}

CoverageResult CoveragePolicy::next(CoverageSearch& search, const PlanRequest& request,
                                    bool warmStart, const SolveOptions& options,
                                    const SolveWatch& watch) const
{
    CoverageResult start = search.completed({});
    if (warmStart) {
        CoverageResult warm = search.completed(restOf(m_last, request.ids));
        if (warm.total_m2s <= start.total_m2s)
            start = std::move(warm);
    }
    return search.improved(start, options.workLimit.value_or(kNextWork), kHeat, watch);
}

/** The plan was found with weights; zeta, which it is predicted to come to, has none. */
PlanAnswer unweightedAnswer(const PlanRequest& request, const CoverageResult& found)
{
    FlightPicture picture = *request.uavs.front().picture;
    picture.weights.clear();
    const CoverageModel model(picture, horizonOf(picture));
    CoverageState state = model.start();
    for (const CoverageLeg& leg : found.plan)
        model.fly(state, leg);
    return answerOf(model, request, {.plan = found.plan, .total_m2s = model.total_m2s(state)});
}

PlanAnswer CoveragePolicy::plan(const PlanRequest& request, const SolveOptions& options)
{
    // Those of several may be planned alone later, but go on from what they fly.
    m_isOfSeveral = m_isOfSeveral || request.uavs.size() > 1;
    return m_isOfSeveral ? m_fleet.plan(request, options) : planOfOne(request, options);
}

PlanAnswer CoveragePolicy::planOfOne(const PlanRequest& request, const SolveOptions& options)
{
    const UavRequest& uav = request.uavs.front();
    require(uav.picture != nullptr, "CoveragePolicy: the request has no picture of the flight");
    const Stopwatch clock;
    const SolveWatch watch(options);
    PlanAnswer answer{.uavs = std::vector<UavAnswer>(1)};
    const bool nothing =
        std::find(uav.available.begin(), uav.available.end(), true) == uav.available.end();
    if (!nothing) {
        const CoverageModel model(*uav.picture, horizonOf(*uav.picture));
        CoverageSearch search = searchFor(model, *uav.picture);
        const bool warmStart = !uav.lastRest.empty();
        if (options.onProgress && m_last.empty()) // later plans take a few milliseconds
            search.setListener(ProgressTeller(model, request, options));
        const CoverageResult found = m_last.empty()
                                         ? first(search, request, options, watch)
                                         : next(search, request, warmStart, options, watch);
        const std::optional<StopReason> cut = watch.cut();
        if (cut == StopReason::Cancelled)
            return {.outcome = {.reason = StopReason::Cancelled, .backend = "coverage"}};
        answer = isWeighted(*uav.picture) ? unweightedAnswer(request, found)
                                          : answerOf(model, request, found);
        answer.outcome.reason = cut.value_or(StopReason::WorkLimit);
        answer.outcome.work = search.work();
        answer.outcome.hintUsed = warmStart && !m_last.empty();
        m_last = keptPlan(found.plan, request.ids);
    }
    answer.outcome.status = SolveStatus::Feasible;
    answer.outcome.backend = "coverage";
    answer.outcome.elapsed_s = clock.elapsed_s();
    return answer;
}

} // namespace

std::unique_ptr<Policy> makeFlownPolicy(const PlannerSettings& settings, const TvpSolver& solver)
{
    if (settings.policy == PolicyKind::Coverage)
        return std::make_unique<CoveragePolicy>();
    return makePolicy(settings, solver);
}

} // namespace berg
