#include "core/plan/fleet/fleet_problem.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace berg {

bool isFleetPlan(const FleetProblem& problem, const FleetPlan& plan)
{
    if (static_cast<int>(plan.size()) != problem.uavCount())
        return false;
    std::vector<bool> seen(problem.sigma_m2.size(), false);
    int visits = 0;
    for (int uav = 0; uav < problem.uavCount(); ++uav)
        for (const NodeIndex node : plan[static_cast<std::size_t>(uav)]) {
            if (node < 1 || node.number() >= problem.nodeCount() || seen[toIndex(node)] ||
                !problem.allows(uav, node))
                return false;
            seen[toIndex(node)] = true;
            ++visits;
        }
    return visits == problem.icebergCount();
}

FleetPlan validPart(const FleetProblem& problem, FleetPlan plan)
{
    std::vector<bool> seen(problem.sigma_m2.size(), false);
    for (int uav = 0; uav < problem.uavCount(); ++uav)
        std::erase_if(plan[static_cast<std::size_t>(uav)], [&](NodeIndex node) {
            if (node < 1 || node.number() >= problem.nodeCount() || seen[toIndex(node)] ||
                !problem.allows(uav, node))
                return true;
            seen[toIndex(node)] = true;
            return false;
        });
    return plan;
}

FleetProblem problemOf(const TvpProblem& alone)
{
    return {.distance_m = {alone.distance_m},
            .sigma_m2 = alone.sigma_m2,
            .mu = alone.mu,
            .route = alone.route,
            .criterion = alone.criterion};
}

TvpProblem problemOfUav(const FleetProblem& problem, int uav)
{
    return {.distance_m = problem.distance_m[static_cast<std::size_t>(uav)],
            .sigma_m2 = problem.sigma_m2,
            .mu = problem.mu,
            .route = problem.route,
            .criterion = problem.criterion};
}

double fleetDistance(const FleetProblem& problem, const FleetPlan& plan)
{
    double distance_m = 0;
    for (std::size_t uav = 0; uav < plan.size(); ++uav)
        distance_m +=
            follow(problem.distance_m[uav], problem.route, plan[uav], [](NodeIndex, double) {});
    return distance_m;
}

double fleetObjective(const FleetProblem& problem, const FleetPlan& plan)
{
    require(isFleetPlan(problem, plan), "fleetObjective: not a plan of this problem");
    if (problem.criterion == Criterion::Latency) {
        double latency = 0;
        for (std::size_t uav = 0; uav < plan.size(); ++uav)
            latency += weightedLatency(problem.distance_m[uav], problem.sigma_m2, plan[uav]);
        return problem.mu * latency;
    }
    return problem.mu * fleetDistance(problem, plan) - fleetReward(problem, plan);
}

double fleetReward(const FleetProblem& problem, const FleetPlan& plan)
{
    double reward = 0;
    for (const VisitOrder& order : plan) {
        int t = 1;
        for (const NodeIndex node : order)
            reward += problem.sigma_m2[toIndex(node)] * (problem.nodeCount() - ++t);
    }
    return reward;
}

TuningWeight fleetTuningWeight(const FleetProblem& problem, const Eigen::MatrixXd& betweenStarts_m,
                               double tau)
{
    const Eigen::Index uavs = problem.uavCount();
    const Eigen::Index n = problem.icebergCount();
    if (n < 1)
        return {};
    if (uavs == 1)
        return tuningWeight(problemOfUav(problem, 0), tau);
    require(betweenStarts_m.rows() == uavs && betweenStarts_m.cols() == uavs,
            "fleetTuningWeight: one row and column for each UAV");
    double sum_m = betweenStarts_m.sum() - betweenStarts_m.diagonal().sum();
    for (const Eigen::MatrixXd& all_m : problem.distance_m) {
        const Eigen::MatrixXd between_m = all_m.bottomRightCorner(n, n);
        sum_m += all_m.row(0).tail(n).sum() + all_m.col(0).tail(n).sum();
        sum_m += (between_m.sum() - between_m.diagonal().sum()) / static_cast<double>(uavs);
    }
    const auto places = static_cast<double>(uavs + n);
    // This applies the rule for one UAV to a matrix that has this average everywhere.
    TuningWeight weight = tuningWeight(
        {.distance_m = Eigen::MatrixXd::Constant(n + 1, n + 1, sum_m / (places * (places - 1))),
         .sigma_m2 = problem.sigma_m2},
        tau);
    if (!weight.distanceOnly)
        weight.mu /= std::sqrt(static_cast<double>(uavs));
    return weight;
}

namespace {

void validateAllowed(const FleetProblem& problem, std::vector<Issue>& issues)
{
    if (problem.allowed.empty())
        return;
    const auto right = [&](const std::vector<bool>& row) {
        return row.size() == problem.sigma_m2.size();
    };
    if (problem.allowed.size() != problem.distance_m.size() ||
        !std::ranges::all_of(problem.allowed, right)) {
        issues.push_back({Severity::Error, "allowed", {IssueId::AllowedCount}});
        return;
    }
    for (std::size_t i = 1; i < problem.sigma_m2.size(); ++i)
        if (std::ranges::none_of(problem.allowed, [i](const auto& row) { return row[i]; }))
            issues.push_back({Severity::Error,
                              "allowed[][" + std::to_string(i) + "]",
                              {IssueId::NobodyAllowed}});
}

} // namespace

std::vector<Issue> validate(const FleetProblem& problem)
{
    std::vector<Issue> issues;
    if (problem.distance_m.empty())
        issues.push_back({Severity::Error, "uavs", {IssueId::LeastEntries, {1}}});
    for (int uav = 0; uav < problem.uavCount(); ++uav)
        for (Issue& issue : validate(problemOfUav(problem, uav))) {
            if (issue.field.starts_with("distance_m"))
                issue.field = "uavs[" + std::to_string(uav) + "]." + issue.field;
            // Faults that all UAVs share are reported once.
            if (std::ranges::find(issues, issue) == issues.end())
                issues.push_back(std::move(issue));
        }
    validateAllowed(problem, issues);
    return issues;
}

} // namespace berg
