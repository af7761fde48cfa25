#include "core/plan/fleet/certificate.h"

#include "core/plan/fleet/fleet_bound.h"
#include "core/plan/fleet/fleet_graph.h"
#include "core/plan/fleet/fleet_subsets.h"
#include "core/plan/proof/layered_bound.h"
#include "core/plan/proof/layered_graph.h"
#include "core/plan/solve/order_moves.h"
#include "core/plan/solve/subset_solver.h"

#include <algorithm>

namespace berg {

namespace {

constexpr int kMostEnumerated = 14;
constexpr double kCertifiedGap = 0.001;
/**
 * Allowance for the rounding of the checker, which may round every number down; relative to the
 * cost.
 */
constexpr double kRoundingAllowance = 2e-9;
/** Some minutes: a certificate is worth the wait. */
constexpr std::int64_t kMostWork = 100'000'000'000;

template <class Costs>
void certifyByRelaxation(const TvpProblem& problem, const VisitOrder& order,
                         const std::stop_token& stop, Proof& proof)
{
    const Costs costs(problem);
    const BoundResult result =
        improveBound(costs, order,
                     {.gap = costs.icebergs > kMostCertifiedExactly ? kCertifiedGap : 0.0,
                      .workLimit = kMostWork,
                      .isStopped = [&stop] { return stop.stop_requested(); }},
                     {.onStep = [&proof](const ProofStep& step) { proof.steps.push_back(step); }});
    proof.bound = result.bound;
    if (!result.reached) { // the steps prove nothing, so the bound without memory is used
        proof.steps = {result.step};
        LayeredPaths<Costs> paths(costs);
        const Multipliers multipliers = certifiedMultipliers(result.step.lambda, proof.cost);
        proof.bound = multipliers.certified(paths.sweep(multipliers, {}));
    }
    if constexpr (Costs::kWeighted)
        proof.rises = costs.steps;
}

} // namespace

Proof certify(const TvpProblem& problem, const VisitOrder& order, const std::stop_token& stop)
{
    const double shift = objectiveShift(problem);
    Proof proof{.mu = problem.mu, .orders = {order}, .cost = objective(problem, order) + shift};
    if (problem.icebergCount() <= kMostEnumerated) {
        const SolveOutcome best = SubsetSolver().solve(problem, {.stop = stop});
        if (best.status == SolveStatus::Optimal)
            proof.bound = best.objective + shift;
    } else if (problem.mu == 0 && problem.criterion == Criterion::Visitation) {
        proof.method = ProofMethod::Sorting;
        proof.bound = objective(problem, sigmaOrder(problem)) + shift;
    } else {
        proof.method = ProofMethod::Relaxation;
        if (problem.criterion == Criterion::Latency)
            certifyByRelaxation<LatencyCosts>(problem, order, stop, proof);
        else
            certifyByRelaxation<VisitCosts>(problem, order, stop, proof);
    }
    proof.bound = std::max(0.0, proof.bound - kRoundingAllowance * proof.cost);
    return proof;
}

Proof certify(const FleetProblem& problem, const FleetPlan& plan, const std::stop_token& stop)
{
    if (problem.uavCount() == 1)
        return certify(problemOfUav(problem, 0), plan.front(), stop);
    Proof proof{.mu = problem.mu,
                .orders = plan,
                .cost = fleetObjective(problem, plan) + objectiveShift(problem)};
    const FleetCosts costs(problem);
    const auto isStopped = [&stop] { return stop.stop_requested(); };
    if (costs.icebergs() <= kMostEnumerated) {
        if (const std::optional<FleetPlan> best = bestFleetPlan(costs, isStopped))
            proof.bound = costs.total(*best);
    } else {
        proof.method = ProofMethod::Relaxation;
        if (isBounded(costs)) {
            const BoundResult result =
                improveFleetBound(costs, plan, {.workLimit = kMostWork, .isStopped = isStopped},
                                  {.relaxationOnly = true});
            proof.bound = result.bound;
            proof.steps.push_back(result.step);
        }
    }
    proof.bound = std::max(0.0, proof.bound - kRoundingAllowance * proof.cost);
    return proof;
}

} // namespace berg
