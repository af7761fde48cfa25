#include "core/plan/policy/fleet_task.h"

#include <algorithm>
#include <utility>

namespace berg {

namespace {

double distanceOf(const PlanRequest& request, const UavRequest& uav, const IcebergList& order,
                  Route route)
{
    VisitOrder nodes;
    for (const IcebergIndex iceberg : order)
        nodes.push_back(nodeOf(request.ids, iceberg));
    return follow(uav.distance_m, route, nodes, [](NodeIndex, double) {});
}

std::vector<std::vector<bool>> allowedOf(const PlanRequest& request, const FleetTask& task,
                                         const VisitOrder& nodes)
{
    bool all = true;
    std::vector<std::vector<bool>> allowed;
    for (const int uav : task.uavs) {
        std::vector<bool>& row = allowed.emplace_back(1, false);
        for (const NodeIndex node : nodes) {
            row.push_back(request.uavs[toIndex(uav)].available[toIndex(node) - 1]);
            all = all && row.back();
        }
    }
    return all ? std::vector<std::vector<bool>>{} : allowed;
}

} // namespace

NodeIndex nodeOf(const IcebergList& ids, IcebergIndex iceberg)
{
    const auto it = std::ranges::find(ids, iceberg);
    require(it != ids.end(), "nodeOf: not in the request");
    return NodeIndex::of(it - ids.begin() + 1);
}

IcebergIndex icebergOf(const IcebergList& ids, NodeIndex node)
{
    return ids[toIndex(node) - 1];
}

bool isAvailable(const PlanRequest& request, const UavRequest& uav, IcebergIndex iceberg)
{
    return uav.available[toIndex(nodeOf(request.ids, iceberg)) - 1];
}

FleetTask fleetTask(const PlanRequest& request)
{
    FleetTask task;
    std::vector<bool> wanted(request.ids.size(), false);
    for (std::size_t uav = 0; uav < request.uavs.size(); ++uav) {
        const std::vector<bool>& available = request.uavs[uav].available;
        require(available.size() == request.ids.size(),
                "fleetTask: needs an entry for each iceberg");
        if (std::ranges::find(available, true) != available.end())
            task.uavs.push_back(static_cast<int>(uav));
        for (std::size_t k = 0; k < wanted.size(); ++k)
            wanted[k] = wanted[k] || available[k];
    }
    VisitOrder nodes;
    for (std::size_t k = 0; k < wanted.size(); ++k)
        if (wanted[k]) {
            nodes.push_back(NodeIndex::of(k + 1));
            task.ids.push_back(request.ids[k]);
        }
    std::vector<int> all{0};
    for (const NodeIndex node : nodes)
        all.push_back(node.number());
    for (const int uav : task.uavs)
        task.problem.distance_m.emplace_back(request.uavs[toIndex(uav)].distance_m(all, all));
    for (const int node : all)
        task.problem.sigma_m2.push_back(request.sigma_m2[toIndex(node)]);
    task.problem.allowed = allowedOf(request, task, nodes);
    if (request.betweenUavs_m.rows() == static_cast<Eigen::Index>(request.uavs.size()))
        task.betweenStarts_m = request.betweenUavs_m(task.uavs, task.uavs);
    return task;
}

FleetTask visitationTask(const PlanRequest& request, Route route)
{
    FleetTask task = fleetTask(request);
    if (task.uavs.empty()) {
        task.uavs = {0};
        task.problem.distance_m = {Eigen::MatrixXd::Zero(1, 1)};
    }
    for (Eigen::MatrixXd& all_m : task.problem.distance_m)
        all_m = ((all_m + all_m.transpose()) / 2).eval();
    task.problem.route = route;
    return task;
}

std::vector<IcebergList> ordersInIds(const PlanRequest& request, const FleetTask& task,
                                     const FleetPlan& plan)
{
    std::vector<IcebergList> orders(request.uavs.size());
    for (std::size_t k = 0; k < plan.size(); ++k)
        for (const NodeIndex node : plan[k])
            orders[toIndex(task.uavs[k])].push_back(icebergOf(task.ids, node));
    return orders;
}

FleetPlan lastRests(const PlanRequest& request, const FleetTask& task)
{
    FleetPlan plan(task.uavs.size());
    for (std::size_t k = 0; k < plan.size(); ++k)
        for (const IcebergIndex id : request.uavs[toIndex(task.uavs[k])].lastRest)
            if (std::ranges::find(task.ids, id) != task.ids.end())
                plan[k].push_back(nodeOf(task.ids, id));
    return validPart(task.problem, std::move(plan));
}

Plan answerOf(const PlanRequest& request, std::span<const IcebergList> orders, Route route)
{
    Plan answer;
    for (std::size_t uav = 0; uav < orders.size(); ++uav) {
        answer.distance_m += distanceOf(request, request.uavs[uav], orders[uav], route);
        answer.uavs.emplace_back().order = orders[uav];
    }
    return answer;
}

} // namespace berg
