#include "core/plan/fleet/fleet_costs.h"

#include <algorithm>
#include <utility>

namespace berg {

namespace {

/** Returns whether both UAVs fly the same distances between icebergs. */
bool sameBetween(const Eigen::MatrixXd& a_m, const Eigen::MatrixXd& b_m)
{
    for (Eigen::Index j = 1; j < a_m.cols(); ++j)
        for (Eigen::Index i = 1; i < a_m.rows(); ++i)
            if (i != j && a_m(i, j) != b_m(i, j))
                return false;
    return true;
}

/** Returns by UAV the first UAV that flies the same distances between icebergs. */
std::vector<std::size_t> representatives(const FleetProblem& problem)
{
    std::vector<std::size_t> first(problem.distance_m.size());
    std::vector<std::size_t> found;
    for (std::size_t uav = 0; uav < first.size(); ++uav) {
        const auto same = std::find_if(found.begin(), found.end(), [&](std::size_t other) {
            return sameBetween(problem.distance_m[other], problem.distance_m[uav]);
        });
        first[uav] = same == found.end() ? uav : *same;
        if (same == found.end())
            found.push_back(uav);
    }
    return first;
}

std::int64_t matrixCount(const std::vector<std::size_t>& first)
{
    std::int64_t count = 0;
    for (std::size_t uav = 0; uav < first.size(); ++uav)
        count += first[uav] == uav ? 1 : 0;
    return count;
}

std::int64_t bytesOf(const FleetProblem& problem, std::int64_t matrices)
{
    const std::int64_t n = problem.nodeCount();
    // One more matrix is needed temporarily.
    return std::int64_t{sizeof(double)} * n *
           ((matrices + 1) * n + std::int64_t{2} * problem.uavCount());
}

} // namespace

UavCosts::UavCosts(std::shared_ptr<const VisitCosts> shared, const FleetProblem& problem, int uav)
    : m_shared(std::move(shared))
    , m_between(m_shared->legs.data())
    , m_sigma(m_shared->sigma.data())
    , m_start(problem.mu * problem.distance_m[static_cast<std::size_t>(uav)].row(0).transpose())
    , m_end(Eigen::VectorXd::Zero(problem.nodeCount()))
{
    m_start(0) = 0;
    if (problem.route == Route::Closed && problem.criterion == Criterion::Visitation)
        m_end = problem.mu * problem.distance_m[static_cast<std::size_t>(uav)].col(0);
    m_end(0) = 0;
}

FleetCosts::FleetCosts(const FleetProblem& problem) : m_problem(&problem)
{
    const std::vector<std::size_t> first = representatives(problem);
    m_bytes = bytesOf(problem, matrixCount(first));
    std::vector<std::shared_ptr<const VisitCosts>> shared(first.size());
    for (int uav = 0; uav < problem.uavCount(); ++uav) {
        std::shared_ptr<const VisitCosts>& costs = shared[first[static_cast<std::size_t>(uav)]];
        if (!costs)
            costs = std::make_shared<const VisitCosts>(problemOfUav(problem, uav));
        m_uavs.emplace_back(costs, problem, uav);
    }
}

std::int64_t FleetCosts::bytesFor(const FleetProblem& problem)
{
    return bytesOf(problem, matrixCount(representatives(problem)));
}

std::int64_t FleetCosts::mostBytesFor(const FleetProblem& problem)
{
    return bytesOf(problem, problem.uavCount());
}

std::vector<std::vector<int>> FleetCosts::alike() const
{
    std::vector<std::vector<int>> groups;
    for (int uav = 0; uav < uavs(); ++uav) {
        const auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& other) {
            return areAlike(other.front(), uav);
        });
        if (group != groups.end())
            group->push_back(uav);
        else
            groups.push_back({uav});
    }
    return groups;
}

bool FleetCosts::areAlike(int a, int b) const
{
    if (m_problem->route == Route::Closed || &of(a).shared() != &of(b).shared())
        return false;
    for (const NodeIndex i : icebergNodes(icebergs()))
        if (allows(a, i) != allows(b, i))
            return false;
    return true;
}

Eigen::VectorXd savings(const FleetCosts& costs, const FleetPlan& plan)
{
    Eigen::VectorXd lambda = Eigen::VectorXd::Zero(costs.icebergs() + 1);
    for (int uav = 0; uav < costs.uavs(); ++uav) {
        const VisitOrder& order = plan[static_cast<std::size_t>(uav)];
        const double cost = costs.total(uav, order);
        for (std::size_t k = 0; k < order.size(); ++k) {
            VisitOrder others = order;
            others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
            // The saving is limited from below, else a long leg that no UAV flies would dominate
            // all the others.
            lambda(order[k].number()) = std::max(cost - costs.total(uav, others), -cost);
        }
    }
    return lambda;
}

} // namespace berg
