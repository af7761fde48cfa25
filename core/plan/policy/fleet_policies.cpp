#include "core/plan/policy/fleet_policies.h"

#include "core/plan/fleet/fleet_solver.h"
#include "core/plan/policy/fleet_task.h"
#include "core/plan/policy/fleet_tour.h"
#include "core/plan/policy/policy.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace berg {

namespace {

/** Sigma set aside: least distance in all. */
FleetProblem distanceOnly(FleetProblem problem)
{
    std::ranges::fill(problem.sigma_m2, 0.0);
    problem.mu = 1;
    problem.route = Route::Open;
    return problem;
}

bool nothingUncertain(const FleetProblem& problem)
{
    return std::ranges::max(problem.sigma_m2) == 0;
}

/** Solves tasks with what the settings ask for. */
class FleetTaskSolver
{
public:
    FleetTaskSolver(Backend backend, const TvpSolver& solver) : m_backend(backend), m_solver(solver)
    {
    }

    [[nodiscard]] PlanAnswer solve(const PlanRequest& request, const FleetTask& task,
                                   bool warmStart, const SolveOptions& options) const
    {
        FleetOptions own{.timeLimit_s = options.timeLimit_s,
                         .workLimit = options.workLimit,
                         .memoryLimit_bytes = options.memoryLimit_bytes,
                         .gap = options.gap,
                         .hint = warmStart ? lastRests(request, task) : FleetPlan{},
                         .stop = options.stop,
                         .onProgress = {}};
        if (options.onProgress)
            own.onProgress = [&](const FleetProgress& progress) {
                options.onProgress({.order = {},
                                    .objective = progress.objective,
                                    .bound = progress.bound,
                                    .elapsed_s = progress.elapsed_s,
                                    .legs = {},
                                    .fleet = ordersInIds(request, task, progress.plan)});
            };
        const FleetOutcome outcome = solved(task.problem, own);
        PlanAnswer answer = fleetAnswer(request, ordersInIds(request, task, outcome.plan));
        answer.outcome = {.status = outcome.status,
                          .reason = outcome.reason,
                          .order = {},
                          .objective = outcome.objective,
                          .bound = outcome.bound,
                          .elapsed_s = outcome.elapsed_s,
                          .work = outcome.work,
                          .hintUsed = outcome.hintUsed,
                          .backend = outcome.backend,
                          .detail = outcome.detail};
        answer.problem.criterion = task.problem.criterion;
        answer.problem.mu = task.problem.mu;
        if (outcome.status == SolveStatus::None)
            return answer;
        answer.distance_m = fleetDistance(task.problem, outcome.plan);
        if (outcome.bound)
            answer.gap = fleetGap(task.problem, outcome.objective, *outcome.bound);
        return answer;
    }

private:
    [[nodiscard]] FleetOutcome solved(const FleetProblem& problem,
                                      const FleetOptions& options) const
    {
        if (problem.uavCount() == 0)
            return {.status = SolveStatus::Optimal,
                    .plan = {},
                    .bound = 0.0,
                    .backend = nameOf(kBackendNames, m_backend)};
        return problem.uavCount() == 1 ? solvedAlone(problem, options)
                                       : solveFleet(problem, m_backend, options);
    }

    [[nodiscard]] FleetOutcome solvedAlone(const FleetProblem& problem,
                                           const FleetOptions& options) const
    {
        SolveOptions own{.timeLimit_s = options.timeLimit_s,
                         .workLimit = options.workLimit,
                         .memoryLimit_bytes = options.memoryLimit_bytes,
                         .gap = options.gap,
                         .hint = options.hint.empty() ? VisitOrder{} : options.hint.front(),
                         .stop = options.stop,
                         .onProgress = {}};
        if (!own.hint.empty())
            for (int node = 1; node <= problem.icebergCount(); ++node)
                if (std::ranges::find(own.hint, node) == own.hint.end())
                    own.hint.push_back(node);
        if (options.onProgress)
            own.onProgress = [&](const SolveProgress& progress) {
                options.onProgress({.plan = {progress.order},
                                    .objective = progress.objective,
                                    .bound = progress.bound,
                                    .elapsed_s = progress.elapsed_s});
            };
        SolveOutcome outcome = m_solver.solve(problemOfUav(problem, 0), own);
        FleetOutcome result{.status = outcome.status,
                            .reason = outcome.reason,
                            .plan = {},
                            .objective = outcome.objective,
                            .bound = outcome.bound,
                            .elapsed_s = outcome.elapsed_s,
                            .work = outcome.work,
                            .hintUsed = outcome.hintUsed,
                            .backend = std::move(outcome.backend),
                            .detail = std::move(outcome.detail)};
        if (outcome.status != SolveStatus::None)
            result.plan = {std::move(outcome.order)};
        return result;
    }

    Backend m_backend;
    const TvpSolver& m_solver;
};

class FleetVisitation final : public Policy
{
public:
    FleetVisitation(const PlannerSettings& settings, const TvpSolver& solver)
        : m_settings(settings), m_solver(settings.backend, solver)
    {
    }

    PlanAnswer plan(const PlanRequest& request, std::span<const int>,
                    const SolveOptions& options) override
    {
        FleetTask task = fleetTask(request);
        task.problem.route = m_settings.route;
        if (!task.uavs.empty())
            task.problem.mu =
                fleetTuningWeight(task.problem, betweenStarts(request, task), m_settings.tau).mu;
        return m_solver.solve(request, task, true, options);
    }

private:
    PlannerSettings m_settings;
    FleetTaskSolver m_solver;
};

class FleetLatency final : public Policy
{
public:
    FleetLatency(const PlannerSettings& settings, const TvpSolver& solver)
        : m_solver(settings.backend, solver)
    {
    }

    PlanAnswer plan(const PlanRequest& request, std::span<const int>,
                    const SolveOptions& options) override
    {
        require(request.speed_mps > 0, "latency: no arrival times without an airspeed");
        FleetTask task = fleetTask(request);
        if (nothingUncertain(task.problem)) {
            task.problem = distanceOnly(std::move(task.problem));
        } else {
            task.problem.criterion = Criterion::Latency;
            task.problem.route = Route::Open;
            task.problem.mu = 1 / request.speed_mps;
        }
        return m_solver.solve(request, task, true, options);
    }

private:
    FleetTaskSolver m_solver;
};

class FleetGreedy final : public Policy
{
public:
    explicit FleetGreedy(bool nearest) : m_nearest(nearest) {}

    PlanAnswer plan(const PlanRequest& request, std::span<const int>, const SolveOptions&) override
    {
        const FleetTask task = fleetTask(request);
        FleetPlan plan(task.uavs.size());
        std::vector<bool> done(task.ids.size() + 1, false);
        for (std::size_t k = 0; k < task.ids.size(); ++k) {
            const Next next = bestNext(task.problem, plan, done);
            plan[static_cast<std::size_t>(next.uav)].push_back(next.node);
            done[static_cast<std::size_t>(next.node)] = true;
        }
        PlanAnswer answer = fleetAnswer(request, ordersInIds(request, task, plan));
        answer.outcome = {.status = SolveStatus::Feasible, .backend = "greedy"};
        answer.outcome.objective = fleetObjective(task.problem, plan);
        return answer;
    }

private:
    struct Next
    {
        double sigma_m2 = -1;
        double distance_m = std::numeric_limits<double>::infinity();
        int uav = -1;
        int node = 0;
    };

    /** Ties go to the smallest node, then to the first UAV. */
    [[nodiscard]] Next bestNext(const FleetProblem& problem, const FleetPlan& plan,
                                const std::vector<bool>& done) const
    {
        Next best;
        for (int node = 1; node < problem.nodeCount(); ++node)
            for (int uav = 0; uav < problem.uavCount(); ++uav) {
                const auto k = static_cast<std::size_t>(uav);
                if (done[static_cast<std::size_t>(node)] || !problem.allows(uav, node))
                    continue;
                const Next next{
                    .sigma_m2 = problem.sigma_m2[static_cast<std::size_t>(node)],
                    .distance_m = problem.distance_m[k](plan[k].empty() ? 0 : plan[k].back(), node),
                    .uav = uav,
                    .node = node};
                if (isBetter(next, best))
                    best = next;
            }
        return best;
    }
    [[nodiscard]] bool isBetter(const Next& next, const Next& best) const
    {
        if (m_nearest || next.node == best.node)
            return next.distance_m < best.distance_m;
        return next.sigma_m2 > best.sigma_m2;
    }

    bool m_nearest;
};

/** The orders are kept and flown iceberg by iceberg, as those of one UAV. */
class FleetPath final : public Policy
{
public:
    FleetPath(const PlannerSettings& settings, const TvpSolver& solver)
        : m_solver(settings.backend, solver)
    {
    }

    PlanAnswer plan(const PlanRequest& request, std::span<const int>,
                    const SolveOptions& options) override
    {
        if (request.ids == m_known) {
            const std::vector<std::vector<int>> orders = takeRests(request);
            if (!std::ranges::all_of(orders, &std::vector<int>::empty)) {
                PlanAnswer answer = fleetAnswer(request, orders);
                answer.outcome = {.status = SolveStatus::Feasible, .backend = "route"};
                return answer;
            }
        }
        FleetTask task = fleetTask(request);
        task.problem = distanceOnly(std::move(task.problem));
        PlanAnswer answer = m_solver.solve(request, task, false, options);
        if (answer.outcome.reason == StopReason::Cancelled)
            return answer; // half-made routes are not kept
        m_known = request.ids;
        m_rests.clear();
        for (std::size_t k = 0; k < request.fleet.size(); ++k)
            m_rests[request.fleet[k].uav] = answer.fleet[k].order;
        return answer;
    }

private:
    /** Those available of what is left of each UAV's order, from its first available one. A UAV to
     * which nothing is available keeps its place. */
    [[nodiscard]] std::vector<std::vector<int>> takeRests(const PlanRequest& request)
    {
        std::vector<std::vector<int>> orders;
        for (const UavRequest& uav : request.fleet) {
            std::vector<int>& order = orders.emplace_back();
            if (std::ranges::find(uav.available, true) == uav.available.end())
                continue;
            std::vector<int>& rest = m_rests[uav.uav];
            const auto available = [&](int id) { return isAvailable(request, uav, id); };
            rest.erase(rest.begin(), std::ranges::find_if(rest, available));
            std::ranges::copy_if(rest, std::back_inserter(order), available);
        }
        return orders;
    }

    FleetTaskSolver m_solver;
    std::map<int, std::vector<int>> m_rests; ///< by number of the UAV
    std::vector<int> m_known;
};

} // namespace

std::unique_ptr<Policy> makeFleetPolicy(const PlannerSettings& settings, const TvpSolver& solver)
{
    switch (settings.policy) {
    case PolicyKind::Visitation:
        return std::make_unique<FleetVisitation>(settings, solver);
    case PolicyKind::Latency:
        return std::make_unique<FleetLatency>(settings, solver);
    case PolicyKind::Path:
        return std::make_unique<FleetPath>(settings, solver);
    case PolicyKind::Tour:
        return makeFleetTour(solver);
    case PolicyKind::Nearest:
        return std::make_unique<FleetGreedy>(true);
    case PolicyKind::Uncertainty:
        return std::make_unique<FleetGreedy>(false);
    case PolicyKind::Coverage:
        break;
    }
    throw std::logic_error("makeFleetPolicy: unknown policy");
}

} // namespace berg
