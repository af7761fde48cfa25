#include "core/coverage/coverage_starts.h"

#include "core/coverage/coverage_settings.h"
#include "core/plan/fleet/fleet_solver.h"
#include "core/plan/problem/tuning.h"

#include <algorithm>

namespace berg {

namespace {

/** Returns the problem, at tau = 1, whose orders annealing starts from. */
FleetProblem fleetProblem(const PlanRequest& request)
{
    constexpr double kTau = 1;
    FleetProblem problem{.sigma_m2 = request.sigma_m2};
    problem.allowed.assign(request.uavs.size(), std::vector<bool>(problem.sigma_m2.size(), true));
    for (const UavRequest& uav : request.uavs)
        problem.distance_m.push_back(uav.distance_m);
    for (std::size_t k = 0; k < request.ids.size(); ++k) {
        const auto may = [k](const UavRequest& uav) { return uav.available[k]; };
        // An iceberg that no UAV may have is in view now, and any UAV may come later.
        if (std::ranges::any_of(request.uavs, may))
            for (std::size_t u = 0; u < request.uavs.size(); ++u)
                problem.allowed[u][k + 1] = request.uavs[u].available[k];
    }
    problem.mu = fleetTuningWeight(problem, request.betweenUavs_m, kTau).mu;
    return problem;
}

/** Returns the shortest tour from the UAV over these icebergs and back. */
VisitOrder tourOf(TvpProblem problem, const VisitOrder& nodes, const SolveOptions& limits)
{
    problem.route = Route::Closed;
    problem.mu = 1;
    std::fill(problem.sigma_m2.begin(), problem.sigma_m2.end(), 0.0);
    const VisitOrder found =
        makeSolver(Backend::Auto)->solve(restrictedTo(problem, nodes), limits).order();
    VisitOrder tour;
    for (const NodeIndex node : found)
        tour.push_back(nodes[toIndex(node) - 1]);
    return tour;
}

} // namespace

std::vector<CoveragePlans> firstPlans(const PlanRequest& request, const SolveOptions& limits)
{
    const FleetProblem problem = fleetProblem(request);
    FleetPlan orders = solveFleet(problem, Backend::Auto, limits).plan;
    orders.resize(request.uavs.size());
    CoveragePlans once;
    CoveragePlans round;
    for (std::size_t u = 0; u < orders.size(); ++u) {
        once.push_back(straightPlan(orders[u], 1));
        const TvpProblem own = problemOfUav(problem, static_cast<int>(u));
        round.push_back(straightPlan(tourOf(own, orders[u], limits), kRounds));
    }
    return {CoveragePlans(request.uavs.size()), once, round};
}

std::vector<CoveragePlans> firstPlansAlone(const PlanRequest& request, const SolveOptions& limits)
{
    const std::unique_ptr<TvpSolver> solver = makeSolver(Backend::Auto);
    TvpProblem problem = problemOfUav(fleetProblem(request), 0);
    const VisitOrder order = solver->solve(problem, limits).order();
    problem.mu = 1;
    VisitOrder soonest;
    if (*std::max_element(problem.sigma_m2.begin(), problem.sigma_m2.end()) > 0) {
        problem.criterion = Criterion::Latency;
        soonest = solver->solve(problem, limits).order();
        problem.criterion = Criterion::Visitation;
    }
    VisitOrder tour = tourOf(problem, ascendingOrder(problem.icebergCount()), limits);
    std::vector<CoveragePlans> starts{{{}}, {straightPlan(order, 1)}, {straightPlan(soonest, 1)}};
    starts.push_back({straightPlan(tour, kRounds)});
    std::reverse(tour.begin(), tour.end());
    starts.push_back({straightPlan(tour, kRounds)});
    return starts;
}

} // namespace berg
