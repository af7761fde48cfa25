#include "core/plan/fleet_costs.h"

#include <algorithm>

namespace berg {

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
    const Eigen::Index n = icebergs();
    if (m_problem->route == Route::Closed ||
        of(a).legs.bottomRightCorner(n, n) != of(b).legs.bottomRightCorner(n, n))
        return false;
    for (int i = 1; i <= icebergs(); ++i)
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
            // No less, or a long leg that nobody flies would drown all the others.
            lambda(order[k]) = std::max(cost - costs.total(uav, others), -cost);
        }
    }
    return lambda;
}

} // namespace berg
