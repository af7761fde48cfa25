#include "core/plan/policy/policy.h"

#include "core/plan/policy/fleet_policies.h"
#include "core/plan/solve/tuning.h"

#include <algorithm>
#include <numeric>

namespace berg {

namespace {

/** Node number (1 ..) of an id in the request, 0 when it is not there. */
int nodeOf(const PlanRequest& request, int id)
{
    const auto it = std::find(request.ids.begin(), request.ids.end(), id);
    return it == request.ids.end() ? 0 : static_cast<int>(it - request.ids.begin()) + 1;
}

std::vector<int> availableNodes(const PlanRequest& request)
{
    std::vector<int> nodes;
    for (int k = 0; k < static_cast<int>(request.ids.size()); ++k)
        if (request.available[static_cast<std::size_t>(k)])
            nodes.push_back(k + 1);
    return nodes;
}

std::vector<int> idsOf(const PlanRequest& request, std::span<const int> nodes)
{
    std::vector<int> ids;
    for (const int node : nodes)
        ids.push_back(request.ids[static_cast<std::size_t>(node - 1)]);
    return ids;
}

/** Order of sub-problem nodes (1 ..) as ids. */
std::vector<int> orderAsIds(const VisitOrder& order, const std::vector<int>& solvedIds)
{
    std::vector<int> ids;
    for (const int node : order)
        ids.push_back(solvedIds[static_cast<std::size_t>(node - 1)]);
    return ids;
}

/** Solves `sub` (its mu and route set), whose nodes are `solvedIds`, from a hint in ids. */
PlanAnswer solved(TvpProblem sub, std::vector<int> solvedIds, std::span<const int> hintIds,
                  const TvpSolver& solver, SolveOptions options)
{
    options.hint.clear();
    for (const int id : hintIds) {
        const auto it = std::find(solvedIds.begin(), solvedIds.end(), id);
        if (it != solvedIds.end())
            options.hint.push_back(static_cast<int>(it - solvedIds.begin()) + 1);
    }
    // Icebergs the last plan did not hold (new, or in view then) go to the end of the hint.
    if (!options.hint.empty())
        for (int node = 1; node <= sub.icebergCount(); ++node)
            if (std::find(options.hint.begin(), options.hint.end(), node) == options.hint.end())
                options.hint.push_back(node);

    if (options.onProgress)
        options.onProgress = [told = options.onProgress,
                              &solvedIds](const SolveProgress& progress) {
            SolveProgress inIds = progress;
            inIds.order = orderAsIds(progress.order, solvedIds);
            told(inIds);
        };

    PlanAnswer answer;
    answer.outcome = solver.solve(sub, options);
    answer.order = orderAsIds(answer.outcome.order, solvedIds);
    answer.problem = std::move(sub);
    answer.solvedIds = std::move(solvedIds);
    return answer;
}

/** The paper's strategy: Eq. (1) with mu of Eq. (14), solved again at every iceberg reached. */
class VisitationPolicy final : public Policy
{
public:
    VisitationPolicy(const PlannerSettings& settings, const TvpSolver& solver)
        : m_settings(settings), m_solver(solver)
    {
    }

    PlanAnswer plan(const PlanRequest& request, std::span<const int> lastRest,
                    const SolveOptions& options) override
    {
        VisitationProblem now = visitationProblem(request, m_settings.route);
        now.problem.mu = tuningWeight(now.problem, m_settings.tau).mu;
        return solved(std::move(now.problem), std::move(now.ids), lastRest, m_solver, options);
    }

private:
    PlannerSettings m_settings;
    const TvpSolver& m_solver;
};

/** Sigma set aside: what is left of Eq. (1) is mu D with mu = 1, a travelling-salesman problem. */
TvpProblem distanceOnly(TvpProblem problem, Route route)
{
    std::fill(problem.sigma_m2.begin(), problem.sigma_m2.end(), 0.0);
    problem.mu = 1;
    problem.route = route;
    return problem;
}

/**
 * `latency`: least sum sigma_i t_i, t_i the predicted arrival times, solved again at every iceberg
 * reached; neither tau nor the route matters. With all sigma 0 by distance alone, as Eq. (14) has
 * it.
 */
class LatencyPolicy final : public Policy
{
public:
    explicit LatencyPolicy(const TvpSolver& solver) : m_solver(solver) {}

    PlanAnswer plan(const PlanRequest& request, std::span<const int> lastRest,
                    const SolveOptions& options) override
    {
        require(request.speed_mps > 0, "latency: no arrival times without an airspeed");
        VisitationProblem now = visitationProblem(request, Route::Open);
        const std::vector<double>& sigma_m2 = now.problem.sigma_m2;
        if (*std::max_element(sigma_m2.begin(), sigma_m2.end()) > 0) {
            now.problem.criterion = Criterion::Latency;
            now.problem.mu = 1 / request.speed_mps;
        } else {
            now.problem = distanceOnly(std::move(now.problem), Route::Open);
        }
        return solved(std::move(now.problem), std::move(now.ids), lastRest, m_solver, options);
    }

private:
    const TvpSolver& m_solver;
};

/** One iceberg at a time: nearest first, or largest sigma first; ties to the smallest node. */
class GreedyPolicy final : public Policy
{
public:
    explicit GreedyPolicy(bool nearest) : m_nearest(nearest) {}

    PlanAnswer plan(const PlanRequest& request, std::span<const int>, const SolveOptions&) override
    {
        std::vector<int> left = availableNodes(request);
        std::vector<int> nodes;
        int from = 0;
        while (!left.empty()) {
            const auto best = std::min_element(left.begin(), left.end(), [&](int a, int b) {
                return score(request.problem, from, a) < score(request.problem, from, b);
            });
            from = *best;
            nodes.push_back(from);
            left.erase(best);
        }
        PlanAnswer answer;
        answer.order = idsOf(request, nodes);
        answer.solvedIds = answer.order;
        answer.problem = restrictedTo(request.problem, nodes);
        answer.outcome = {.status = SolveStatus::Feasible, .backend = "greedy"};
        answer.outcome.order.resize(nodes.size());
        std::iota(answer.outcome.order.begin(), answer.outcome.order.end(), 1);
        answer.outcome.objective = objective(answer.problem, answer.outcome.order);
        return answer;
    }

private:
    [[nodiscard]] double score(const TvpProblem& problem, int from, int to) const
    {
        return m_nearest ? problem.distance_m(from, to)
                         : -problem.sigma_m2[static_cast<std::size_t>(to)];
    }

    bool m_nearest;
};

/**
 * What the two fixed routes share: the sequence is kept and flown iceberg by iceberg (those in
 * view are passed over); only when it is used up, or the set of icebergs has changed, is it made
 * anew.
 */
class FixedRoutePolicy : public Policy
{
public:
    explicit FixedRoutePolicy(const TvpSolver& solver) : m_solver(solver) {}

    PlanAnswer plan(const PlanRequest& request, std::span<const int>,
                    const SolveOptions& options) final
    {
        std::vector<int> rest = takeRest(request);
        if (rest.empty()) {
            PlanAnswer answer = newRoute(request, options);
            if (answer.outcome.reason == StopReason::Cancelled)
                return answer; // half-made routes are not kept
            m_rest = answer.order;
            m_known = request.ids;
            return answer;
        }
        PlanAnswer answer;
        answer.order = std::move(rest);
        answer.solvedIds = answer.order;
        answer.outcome = {.status = SolveStatus::Feasible, .backend = "route"};
        m_rest = answer.order;
        return answer;
    }

protected:
    /** The route from here, available icebergs only. */
    [[nodiscard]] virtual PlanAnswer newRoute(const PlanRequest& request,
                                              const SolveOptions& options) = 0;
    [[nodiscard]] const TvpSolver& solver() const { return m_solver; }

private:
    /** What is left of the sequence from its first available iceberg; empty: make a new one. */
    [[nodiscard]] std::vector<int> takeRest(const PlanRequest& request) const
    {
        if (request.ids != m_known)
            return {};
        std::vector<int> rest;
        for (const int id : m_rest) {
            const int node = nodeOf(request, id);
            const bool available = request.available[static_cast<std::size_t>(node - 1)];
            if (available || !rest.empty())
                rest.push_back(id);
        }
        return rest;
    }

    const TvpSolver& m_solver;
    std::vector<int> m_rest;
    std::vector<int> m_known;
};

/** `path`: the shortest open path over the icebergs, solved again from its end. */
class PathPolicy final : public FixedRoutePolicy
{
public:
    using FixedRoutePolicy::FixedRoutePolicy;

protected:
    PlanAnswer newRoute(const PlanRequest& request, const SolveOptions& options) override
    {
        const std::vector<int> nodes = availableNodes(request);
        TvpProblem sub = distanceOnly(restrictedTo(request.problem, nodes), Route::Open);
        return solved(std::move(sub), idsOf(request, nodes), {}, solver(), options);
    }
};

/**
 * `tour`: the shortest cycle over the icebergs alone, entered at the iceberg and flown in the
 * direction that minimise sum sigma_i t_i (t_i by distance at constant speed), repeated.
 */
class TourPolicy final : public FixedRoutePolicy
{
public:
    using FixedRoutePolicy::FixedRoutePolicy;

protected:
    PlanAnswer newRoute(const PlanRequest& request, const SolveOptions& options) override
    {
        if (m_cycle.empty() || m_cycleIds != request.ids) {
            PlanAnswer answer = shortestCycle(request, options);
            if (answer.outcome.status == SolveStatus::None ||
                answer.outcome.reason == StopReason::Cancelled)
                return answer;
            m_cycle = answer.order;
            m_cycleIds = request.ids;
            m_cycleOutcome = std::move(answer);
            m_cycle = bestEntry(request);
        }
        PlanAnswer answer = m_cycleOutcome;
        answer.order = fromFirstAvailable(request);
        return answer;
    }

private:
    /** Ids round the cycle; the first iceberg takes the UAV's place as the node to return to. */
    [[nodiscard]] PlanAnswer shortestCycle(const PlanRequest& request,
                                           const SolveOptions& options) const
    {
        const auto n = static_cast<Eigen::Index>(request.ids.size());
        if (n == 0)
            return {.outcome = {.status = SolveStatus::Optimal}};
        TvpProblem cycle{.distance_m = request.problem.distance_m.bottomRightCorner(n, n),
                         .sigma_m2 = std::vector<double>(request.ids.size(), 0.0),
                         .mu = 1,
                         .route = Route::Closed};
        PlanAnswer answer = solved(std::move(cycle), {request.ids.begin() + 1, request.ids.end()},
                                   {}, solver(), options);
        if (answer.outcome.status != SolveStatus::None)
            answer.order.insert(answer.order.begin(), request.ids.front());
        return answer;
    }

    [[nodiscard]] std::vector<int> bestEntry(const PlanRequest& request) const
    {
        std::vector<int> best;
        double bestCost = 0;
        std::vector<int> candidate = m_cycle;
        for (int direction = 0; direction < 2; ++direction) {
            for (std::size_t turn = 0; turn < m_cycle.size(); ++turn) {
                const double cost = waiting(request, candidate);
                if (best.empty() || cost < bestCost) {
                    best = candidate;
                    bestCost = cost;
                }
                std::rotate(candidate.begin(), candidate.begin() + 1, candidate.end());
            }
            std::reverse(candidate.begin(), candidate.end());
        }
        return best;
    }

    /** sum sigma_i t_i along the sequence, times the speed (which does not change the choice). */
    [[nodiscard]] static double waiting(const PlanRequest& request, const std::vector<int>& ids)
    {
        double distance_m = 0;
        double sum = 0;
        int from = 0;
        for (const int id : ids) {
            const int node = nodeOf(request, id);
            distance_m += request.problem.distance_m(from, node);
            sum += request.problem.sigma_m2[static_cast<std::size_t>(node)] * distance_m;
            from = node;
        }
        return sum;
    }

    /** Once round the cycle, starting at its first iceberg that is not in view. */
    [[nodiscard]] std::vector<int> fromFirstAvailable(const PlanRequest& request) const
    {
        std::vector<int> order;
        for (const int id : m_cycle) {
            const auto k = static_cast<std::size_t>(nodeOf(request, id) - 1);
            if (request.available[k] || !order.empty())
                order.push_back(id);
        }
        return order;
    }

    std::vector<int> m_cycle;
    std::vector<int> m_cycleIds;
    PlanAnswer m_cycleOutcome;
};

} // namespace

VisitationProblem visitationProblem(const PlanRequest& request, Route route)
{
    const std::vector<int> nodes = availableNodes(request);
    VisitationProblem result{.problem = restrictedTo(request.problem, nodes),
                             .ids = idsOf(request, nodes)};
    result.problem.mu = 0;
    result.problem.route = route;
    return result;
}

namespace {

std::unique_ptr<Policy> makePolicyOfOne(const PlannerSettings& settings, const TvpSolver& solver)
{
    switch (settings.policy) {
    case PolicyKind::Visitation:
        return std::make_unique<VisitationPolicy>(settings, solver);
    case PolicyKind::Path:
        return std::make_unique<PathPolicy>(solver);
    case PolicyKind::Tour:
        return std::make_unique<TourPolicy>(solver);
    case PolicyKind::Nearest:
        return std::make_unique<GreedyPolicy>(true);
    case PolicyKind::Uncertainty:
        return std::make_unique<GreedyPolicy>(false);
    case PolicyKind::Latency:
        if (settings.backend == Backend::Cbc)
            throw Error(ErrorCode::Unsupported, "planner.backend",
                        "the back end cbc cannot plan for the policy latency");
        return std::make_unique<LatencyPolicy>(solver);
    case PolicyKind::Coverage:
        throw Error(ErrorCode::Unsupported, "planner.policy",
                    nameOf(kPolicyNames, settings.policy) + " is not flown by this version");
    }
    throw std::logic_error("makePolicy: unknown policy");
}

/** A policy for one UAV and its counterpart for several. */
class OneOrFleet final : public Policy
{
public:
    OneOrFleet(std::unique_ptr<Policy> one, std::unique_ptr<Policy> fleet)
        : m_one(std::move(one)), m_fleet(std::move(fleet))
    {
    }

    PlanAnswer plan(const PlanRequest& request, std::span<const int> lastRest,
                    const SolveOptions& options) override
    {
        return (request.fleet.empty() ? *m_one : *m_fleet).plan(request, lastRest, options);
    }

private:
    std::unique_ptr<Policy> m_one;
    std::unique_ptr<Policy> m_fleet;
};

} // namespace

std::unique_ptr<Policy> makePolicy(const PlannerSettings& settings, const TvpSolver& solver)
{
    std::unique_ptr<Policy> one = makePolicyOfOne(settings, solver);
    return std::make_unique<OneOrFleet>(std::move(one), makeFleetPolicy(settings, solver));
}

} // namespace berg
