#include "core/plan/policy/planner.h"

#include "core/base/solving_guard.h"

#include <algorithm>
#include <exception>
#include <optional>

namespace berg {

namespace {

bool contains(std::span<const IcebergIndex> ids, IcebergIndex id)
{
    return std::ranges::find(ids, id) != ids.end();
}

/** Returns the members of `order` that may be planned now. */
IcebergList stillAvailable(const IcebergList& order, const PlanRequest& request,
                           const std::vector<bool>& available)
{
    IcebergList rest;
    for (const IcebergIndex id : order) {
        const auto it = std::find(request.ids.begin(), request.ids.end(), id);
        if (it == request.ids.end())
            continue;
        if (available[static_cast<std::size_t>(it - request.ids.begin())])
            rest.push_back(id);
    }
    return rest;
}

/** Inserts after the first member of each cluster its other members. */
IcebergList withMembers(std::span<const IcebergIndex> order, std::span<const IcebergList> clusters)
{
    IcebergList ids;
    for (const IcebergIndex id : order) {
        const auto cluster = std::ranges::find_if(
            clusters, [id](const IcebergList& members) { return members.front() == id; });
        if (cluster == clusters.end())
            ids.push_back(id);
        else
            ids.insert(ids.end(), cluster->begin(), cluster->end());
    }
    return ids;
}

/** Returns the clusters whose first member is in the order. */
std::vector<IcebergList> clustersIn(std::span<const IcebergIndex> order,
                                    std::vector<IcebergList> clusters)
{
    std::erase_if(clusters, [order](const IcebergList& members) {
        return std::ranges::find(order, members.front()) == order.end();
    });
    return clusters;
}

/**
 * Returns the nearest available iceberg, the smallest node among equals: the fallback without a
 * plan.
 */
IcebergList nearestAvailable(const IcebergList& ids, const std::vector<bool>& available,
                             const Eigen::MatrixXd& distance_m)
{
    std::optional<int> best;
    for (int k = 0; k < static_cast<int>(ids.size()); ++k)
        if (available[static_cast<std::size_t>(k)] &&
            (!best || distance_m(0, k + 1) < distance_m(0, *best + 1)))
            best = k;
    return best ? IcebergList{ids[static_cast<std::size_t>(*best)]} : IcebergList{};
}

/**
 * Ensures, for any policy, that no order begins with an iceberg that is not available to its UAV,
 * or with one that another order begins with.
 */
void separateFirsts(const PlanRequest& request, std::vector<UavPlan>& answers)
{
    IcebergList firsts;
    for (std::size_t k = 0; k < answers.size(); ++k) {
        IcebergList& order = answers[k].order;
        const auto first = std::ranges::find_if(order, [&](IcebergIndex id) {
            return !contains(firsts, id) &&
                   !stillAvailable({id}, request, request.uavs[k].available).empty();
        });
        if (first != order.begin())
            answers[k].legs.clear(); // they lead to the iceberg that is removed
        order.erase(order.begin(), first);
        if (!order.empty())
            firsts.push_back(order.front());
    }
}

} // namespace

Planner::Planner(const PlannerSettings& settings, std::unique_ptr<TvpSolver> solver,
                 PolicyMaker maker)
    : m_settings(settings)
    , m_maker(maker)
    , m_hasGivenSolver(solver != nullptr)
    , m_solver(solver ? std::move(solver) : makeSolver(settings.backend, settings.formulation))
    , m_policy(m_maker(settings, *m_solver))
{
}

void Planner::setSettings(const PlannerSettings& settings)
{
    if (settings == m_settings)
        return;
    std::unique_ptr<TvpSolver> solver;
    if (!m_hasGivenSolver)
        solver = makeSolver(settings.backend, settings.formulation);
    std::unique_ptr<Policy> policy = m_maker(settings, solver ? *solver : *m_solver);
    m_policy = std::move(policy);
    if (solver)
        m_solver = std::move(solver);
    m_settings = settings;
}

Plan Planner::plan(const PlanRequest& request, const SolveOptions& options, bool warmStart)
{
    requireSolvingAllowed(); // its error must not count as a failure of the policy
    SolveOptions solveOptions = options;
    if (options.onProgress && !request.clusters.empty())
        solveOptions.onProgress = [&](SolveProgress progress) {
            for (IcebergList& order : progress.orders)
                order = withMembers(order, request.clusters);
            options.onProgress(progress);
        };
    PlanRequest withRests = request;
    for (UavRequest& uav : withRests.uavs)
        uav.lastRest = warmStart ? stillAvailable(m_lastOrders[uav.uav], request, uav.available)
                                 : IcebergList{};
    Plan answer;
    try {
        answer = m_policy->plan(withRests, solveOptions);
    } catch (const std::exception& failure) {
        // The autopilot needs a next iceberg even if the planner fails.
        answer = {.failure = failure.what()};
    }
    if (answer.outcome.reason == StopReason::Cancelled)
        return answer; // nothing is stored: the caller repeats the request
    answer.uavs.resize(request.uavs.size());
    separateFirsts(request, answer.uavs);
    if (std::ranges::all_of(answer.uavs, [](const UavPlan& uav) { return uav.order.empty(); }))
        answer.fellBack = fallBack(request, answer.uavs);
    for (std::size_t k = 0; k < answer.uavs.size(); ++k) {
        UavPlan& own = answer.uavs[k];
        own.uav = request.uavs[k].uav;
        own.clusters = clustersIn(own.order, request.clusters);
        own.order = withMembers(own.order, request.clusters);
        m_lastOrders[own.uav] = own.order;
    }
    return answer;
}

bool Planner::fallBack(const PlanRequest& request, std::vector<UavPlan>& answers) const
{
    IcebergList taken;
    for (std::size_t k = 0; k < answers.size(); ++k) {
        const UavRequest& uav = request.uavs[k];
        const auto last = m_lastOrders.find(uav.uav);
        if (last == m_lastOrders.end())
            continue;
        answers[k].order = stillAvailable(last->second, request, uav.available);
        std::erase_if(answers[k].order, [&](IcebergIndex id) { return contains(taken, id); });
        taken.insert(taken.end(), answers[k].order.begin(), answers[k].order.end());
    }
    for (std::size_t k = 0; k < answers.size(); ++k) {
        if (!answers[k].order.empty())
            continue;
        const UavRequest& uav = request.uavs[k];
        std::vector<bool> left = uav.available;
        for (std::size_t i = 0; i < left.size(); ++i)
            left[i] = left[i] && !contains(taken, request.ids[i]);
        answers[k].order = nearestAvailable(request.ids, left, uav.distance_m);
        taken.insert(taken.end(), answers[k].order.begin(), answers[k].order.end());
    }
    return !taken.empty();
}

} // namespace berg
