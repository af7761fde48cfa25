#include "core/plan/policy/policy.h"

#include "core/plan/fleet/fleet_solver.h"
#include "core/plan/policy/fleet_task.h"
#include "core/plan/policy/tour.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace berg {

namespace {

/** Returns the problem of least total distance, without sigma. */
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

/** Solves tasks with the back end of the settings and stores the multipliers of the last solves. */
class TaskSolver
{
public:
    TaskSolver(Backend backend, const TvpSolver& alone) : m_backend(backend), m_alone(alone) {}

    [[nodiscard]] Plan solve(const PlanRequest& request, FleetTask task, bool warmStart,
                             SolveOptions options)
    {
        options.hint = warmStart ? lastRests(request, task) : FleetPlan{};
        if (options.inFlight && !options.hint.empty())
            options.multipliers = multipliersOf(task.ids);
        if (options.onProgress)
            options.onProgress = [&, report = options.onProgress](SolveProgress progress) {
                progress.orders = ordersInIds(request, task, progress.plan);
                report(progress);
            };
        SolveOutcome outcome = berg::solve(task.problem, m_backend, m_alone, options);
        Plan answer =
            answerOf(request, ordersInIds(request, task, outcome.plan), task.problem.route);
        if (outcome.status != SolveStatus::None && outcome.bound)
            answer.gap = relativeGap(task.problem, outcome.objective, *outcome.bound);
        remember(task.ids, outcome);
        answer.outcome = std::move(outcome);
        answer.problem = std::move(task.problem);
        answer.solvedIds = std::move(task.ids);
        return answer;
    }

private:
    /** Returns multipliers by node; 0 for icebergs that have not been solved for before. */
    [[nodiscard]] std::vector<double> multipliersOf(const IcebergList& ids) const
    {
        std::vector<double> multipliers(ids.size() + 1, 0.0);
        for (std::size_t k = 0; k < ids.size(); ++k)
            if (const auto known = m_multipliers.find(ids[k]); known != m_multipliers.end())
                multipliers[k + 1] = known->second;
        return multipliers;
    }
    /**
     * Stores the multipliers. Those of icebergs not in this solve stay: icebergs return after a
     * time in view.
     */
    void remember(const IcebergList& ids, const SolveOutcome& outcome)
    {
        if (outcome.reason == StopReason::Cancelled)
            return; // the caller repeats the request
        for (std::size_t k = 1; k < outcome.multipliers.size(); ++k)
            m_multipliers[ids[k - 1]] = outcome.multipliers[k];
    }

    Backend m_backend;
    const TvpSolver& m_alone;
    std::map<IcebergIndex, double> m_multipliers; ///< multipliers of the last solves
};

/** The paper's policy. */
class VisitationPolicy final : public Policy
{
public:
    VisitationPolicy(const PlannerSettings& settings, const TvpSolver& solver)
        : m_settings(settings), m_solver(settings.backend, solver)
    {
    }

    Plan plan(const PlanRequest& request, const SolveOptions& options) override
    {
        FleetTask task = visitationTask(request, m_settings.route);
        if (task.ids.empty()) // no UAV has anything to visit
            task = fleetTask(request);
        else
            task.problem.mu =
                fleetTuningWeight(task.problem, task.betweenStarts_m, m_settings.tau).mu;
        return m_solver.solve(request, std::move(task), true, options);
    }

private:
    PlannerSettings m_settings;
    TaskSolver m_solver;
};

class LatencyPolicy final : public Policy
{
public:
    LatencyPolicy(const PlannerSettings& settings, const TvpSolver& solver)
        : m_solver(settings.backend, solver)
    {
    }

    Plan plan(const PlanRequest& request, const SolveOptions& options) override
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
        return m_solver.solve(request, std::move(task), true, options);
    }

private:
    TaskSolver m_solver;
};

class GreedyPolicy final : public Policy
{
public:
    explicit GreedyPolicy(bool nearest) : m_nearest(nearest) {}

    Plan plan(const PlanRequest& request, const SolveOptions&) override
    {
        FleetTask task = fleetTask(request);
        FleetPlan plan(task.uavs.size());
        std::vector<bool> done(task.ids.size() + 1, false);
        for (std::size_t k = 0; k < task.ids.size(); ++k) {
            const Next next = bestNext(task.problem, plan, done);
            plan[toIndex(next.uav)].push_back(next.node);
            done[toIndex(next.node)] = true;
        }
        Plan answer = answerOf(request, ordersInIds(request, task, plan));
        answer.outcome = {.status = SolveStatus::Feasible, .source = AnswerSource::OneByOne};
        answer.outcome.objective = fleetObjective(task.problem, plan);
        answer.outcome.plan = std::move(plan);
        answer.problem = std::move(task.problem);
        answer.solvedIds = std::move(task.ids);
        return answer;
    }

private:
    struct Next
    {
        double sigma_m2 = 0;
        double distance_m = 0;
        int uav = 0;
        NodeIndex node;
        bool isFirst = false; ///< whether it is the first iceberg of the UAV
    };

    /**
     * Returns the best next iceberg; one must be left. Every UAV gets a first iceberg before any
     * gets a second one. Ties go to the smallest node, then to the first UAV.
     */
    [[nodiscard]] Next bestNext(const FleetProblem& problem, const FleetPlan& plan,
                                const std::vector<bool>& done) const
    {
        std::optional<Next> best;
        for (const NodeIndex node : icebergNodes(problem.icebergCount()))
            for (int uav = 0; uav < problem.uavCount(); ++uav) {
                const auto k = toIndex(uav);
                if (done[toIndex(node)] || !problem.allows(uav, node))
                    continue;
                const Next next{
                    .sigma_m2 = problem.sigma_m2[toIndex(node)],
                    .distance_m = legBetween(problem.distance_m[k],
                                             plan[k].empty() ? NodeIndex() : plan[k].back(), node),
                    .uav = uav,
                    .node = node,
                    .isFirst = plan[k].empty()};
                if (!best || isBetter(next, *best))
                    best = next;
            }
        return best.value();
    }
    [[nodiscard]] bool isBetter(const Next& next, const Next& best) const
    {
        if (next.isFirst != best.isFirst)
            return next.isFirst;
        if (m_nearest || next.node == best.node)
            return next.distance_m < best.distance_m;
        return next.sigma_m2 > best.sigma_m2;
    }

    bool m_nearest;
};

/** Keeps the orders and flies them iceberg by iceberg; icebergs in view are passed over. */
class PathPolicy final : public Policy
{
public:
    PathPolicy(const PlannerSettings& settings, const TvpSolver& solver)
        : m_solver(settings.backend, solver)
    {
    }

    Plan plan(const PlanRequest& request, const SolveOptions& options) override
    {
        if (request.ids == m_known) {
            const std::vector<IcebergList> orders = remainingOrders(request);
            if (!std::ranges::all_of(orders, &IcebergList::empty)) {
                Plan answer = answerOf(request, orders);
                answer.outcome = {.status = SolveStatus::Feasible,
                                  .source = AnswerSource::KeptRoute};
                return answer;
            }
        }
        FleetTask task = fleetTask(request);
        task.problem = distanceOnly(std::move(task.problem));
        SolveOptions whole = options;
        whole.inFlight = false; // this plan is kept for a long time
        Plan answer = m_solver.solve(request, std::move(task), false, whole);
        if (answer.outcome.reason == StopReason::Cancelled)
            return answer; // incomplete routes are discarded
        m_known = request.ids;
        m_rests.clear();
        for (std::size_t k = 0; k < request.uavs.size(); ++k)
            m_rests[request.uavs[k].uav] = answer.uavs[k].order;
        return answer;
    }

private:
    /**
     * Returns for each UAV the rest of its order from the first available iceberg, without icebergs
     * that are not available; a single UAV keeps those in view. A UAV to which nothing is available
     * keeps its place; one that has flown its part before others gets the icebergs that only it may
     * visit.
     */
    [[nodiscard]] std::vector<IcebergList> remainingOrders(const PlanRequest& request)
    {
        std::vector<IcebergList> orders;
        for (const UavRequest& uav : request.uavs) {
            IcebergList& order = orders.emplace_back();
            if (std::ranges::find(uav.available, true) == uav.available.end())
                continue;
            IcebergList& rest = m_rests[uav.uav];
            const auto available = [&](IcebergIndex id) { return isAvailable(request, uav, id); };
            rest.erase(rest.begin(), std::ranges::find_if(rest, available));
            const bool isAlone = m_rests.size() == 1;
            std::ranges::copy_if(rest, std::back_inserter(order),
                                 [&](IcebergIndex id) { return isAlone || available(id); });
        }
        if (!std::ranges::all_of(orders, &IcebergList::empty))
            for (std::size_t k = 0; k < orders.size(); ++k)
                if (IcebergList& rest = m_rests[request.uavs[k].uav]; rest.empty())
                    rest = orders[k] = exclusiveIcebergs(request, request.uavs[k]);
        return orders;
    }

    /**
     * Returns the icebergs that are available to this UAV, to no other one, and not in the order of
     * a UAV that is absent from the request. Icebergs assigned since that order was made are
     * included, because it is out of date.
     */
    [[nodiscard]] IcebergList exclusiveIcebergs(const PlanRequest& request,
                                                const UavRequest& uav) const
    {
        IcebergList exclusive;
        std::ranges::copy_if(request.ids, std::back_inserter(exclusive), [&](IcebergIndex id) {
            const auto isOthers = [&](const UavRequest& other) {
                return other.uav != uav.uav && isAvailable(request, other, id);
            };
            const auto isInOrderOfAbsent = [&](const auto& rest) {
                return std::ranges::find(request.uavs, rest.first, &UavRequest::uav) ==
                           request.uavs.end() &&
                       std::ranges::find(rest.second, id) != rest.second.end();
            };
            return isAvailable(request, uav, id) &&
                   (std::ranges::find(uav.assigned, id) != uav.assigned.end() ||
                    (std::ranges::none_of(request.uavs, isOthers) &&
                     std::ranges::none_of(m_rests, isInOrderOfAbsent)));
        });
        return exclusive;
    }

    TaskSolver m_solver;
    std::map<int, IcebergList> m_rests; ///< by `UavRequest::uav`
    IcebergList m_known;
};

} // namespace

std::unique_ptr<Policy> makePolicy(const PlannerSettings& settings, const TvpSolver& solver)
{
    switch (settings.policy) {
    case PolicyKind::Visitation:
        return std::make_unique<VisitationPolicy>(settings, solver);
    case PolicyKind::Latency:
        if (settings.backend == Backend::Cbc)
            throw Error(ErrorCode::Unsupported, "planner.backend", {IssueId::CbcLatency});
        return std::make_unique<LatencyPolicy>(settings, solver);
    case PolicyKind::Path:
        return std::make_unique<PathPolicy>(settings, solver);
    case PolicyKind::Tour:
        return makeTour(solver);
    case PolicyKind::Nearest:
        return std::make_unique<GreedyPolicy>(true);
    case PolicyKind::Uncertainty:
        return std::make_unique<GreedyPolicy>(false);
    case PolicyKind::Coverage:
        throw Error(ErrorCode::Unsupported, "planner.policy",
                    {IssueId::PolicyNotFlown, {nameOf(kPolicyNames, settings.policy)}});
    }
    throw std::logic_error("makePolicy: unknown policy");
}

} // namespace berg
