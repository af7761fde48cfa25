#include "core/plan/planner.h"

#include "core/base/solving_guard.h"

#include <algorithm>
#include <exception>

namespace berg {

namespace {

/** Members of `order` that may be planned now. */
std::vector<int> stillAvailable(const std::vector<int>& order, const PlanRequest& request)
{
    std::vector<int> rest;
    for (const int id : order) {
        const auto it = std::find(request.ids.begin(), request.ids.end(), id);
        if (it == request.ids.end())
            continue;
        if (request.available[static_cast<std::size_t>(it - request.ids.begin())])
            rest.push_back(id);
    }
    return rest;
}

/** Each first one of a cluster with the others behind it. */
std::vector<int> withMembers(std::span<const int> order, std::span<const std::vector<int>> clusters)
{
    std::vector<int> ids;
    for (const int id : order) {
        const auto cluster = std::ranges::find_if(
            clusters, [id](const std::vector<int>& members) { return members.front() == id; });
        if (cluster == clusters.end())
            ids.push_back(id);
        else
            ids.insert(ids.end(), cluster->begin(), cluster->end());
    }
    return ids;
}

/** The clusters flown to. */
std::vector<std::vector<int>> clustersIn(std::span<const int> order,
                                         std::vector<std::vector<int>> clusters)
{
    std::erase_if(clusters, [order](const std::vector<int>& members) {
        return std::ranges::find(order, members.front()) == order.end();
    });
    return clusters;
}

/** With no plan in hand at all: the nearest available iceberg, the smallest node among equals. */
std::vector<int> nearestAvailable(const PlanRequest& request)
{
    int best = -1;
    for (int k = 0; k < static_cast<int>(request.ids.size()); ++k) {
        if (!request.available[static_cast<std::size_t>(k)])
            continue;
        if (best < 0 ||
            request.problem.distance_m(0, k + 1) < request.problem.distance_m(0, best + 1))
            best = k;
    }
    return best < 0 ? std::vector<int>{}
                    : std::vector<int>{request.ids[static_cast<std::size_t>(best)]};
}

} // namespace

Planner::Planner(const PlannerSettings& settings, std::unique_ptr<TvpSolver> solver,
                 PolicyMaker maker)
    : m_settings(settings)
    , m_maker(maker)
    , m_ownSolver(solver != nullptr)
    , m_solver(solver ? std::move(solver) : makeSolver(settings.backend, settings.formulation))
    , m_policy(m_maker(settings, *m_solver))
{
}

void Planner::setSettings(const PlannerSettings& settings)
{
    if (settings == m_settings)
        return;
    std::unique_ptr<TvpSolver> solver;
    if (!m_ownSolver)
        solver = makeSolver(settings.backend, settings.formulation);
    std::unique_ptr<Policy> policy = m_maker(settings, solver ? *solver : *m_solver);
    m_policy = std::move(policy);
    if (solver)
        m_solver = std::move(solver);
    m_settings = settings;
}

PlanAnswer Planner::plan(const PlanRequest& request, const SolveOptions& options, bool warmStart)
{
    requireSolvingAllowed(); // not one of the failures that are flown over
    SolveOptions telling = options;
    if (options.onProgress && !request.clusters.empty())
        telling.onProgress = [&](SolveProgress progress) {
            progress.order = withMembers(progress.order, request.clusters);
            options.onProgress(progress);
        };
    const std::vector<int> lastRest = stillAvailable(m_lastOrder, request);
    PlanAnswer answer;
    try {
        answer = m_policy->plan(request, warmStart ? lastRest : std::vector<int>{}, telling);
    } catch (const std::exception& failure) {
        // The autopilot always has a next iceberg, whatever becomes of the planner.
        answer = {.failure = failure.what()};
    }
    if (answer.outcome.reason == StopReason::Cancelled)
        return answer; // nothing is remembered: the same call will be made again
    if (answer.order.empty()) {
        answer.order = lastRest.empty() ? nearestAvailable(request) : lastRest;
        answer.fellBack = !answer.order.empty();
    }
    answer.clusters = clustersIn(answer.order, request.clusters);
    answer.order = withMembers(answer.order, request.clusters);
    m_lastOrder = answer.order;
    return answer;
}

} // namespace berg
