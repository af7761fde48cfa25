#include "core/coverage/coverage_answer.h"

#include "core/coverage/coverage_settings.h"
#include "core/coverage/own_inputs.h"
#include "core/coverage/patrol_plans.h"
#include "core/coverage/plan_conversion.h"
#include "core/plan/policy/fleet_task.h"

#include <utility>

namespace berg {

namespace {

/** Returns the predicted zeta without weights; sigma at the horizon counts for `rest_s`. */
double zeta_m2s(std::vector<PredictionInput> inputs, const FoundPlans& plans, double rest_s)
{
    for (PredictionInput& input : inputs)
        input.weights.clear();
    CoverageHorizon horizon = plans.horizon;
    horizon.rest_s = rest_s;
    std::optional<PatrolTails> tails = plans.tails;
    if (tails)
        tails->setIcebergs(patrolIcebergs(inputs));
    return fleetTotal_m2s(modelsOf(inputs, horizon), plans.found.plans, tails ? &*tails : nullptr);
}

double flown_m(const PlanRequest& request, std::span<const UavPlan> answers)
{
    double sum_m = 0;
    for (std::size_t u = 0; u < answers.size(); ++u) {
        NodeIndex from;
        for (const IcebergIndex iceberg : answers[u].order) {
            const NodeIndex to = nodeOf(request.ids, iceberg);
            sum_m += legBetween(request.uavs[u].distance_m, from, to);
            from = to;
        }
    }
    return sum_m;
}

} // namespace

Plan answerOf(const PlanRequest& request, const std::vector<PredictionInput>& inputs,
              const FoundPlans& plans)
{
    Plan answer{.uavs = describeFleet(plans.models, request, plans.found.plans)};
    answer.predictedZeta_m2s = isWeighted(inputs.front())
                                   ? zeta_m2s(inputs, plans, plans.horizon.rest_s)
                                   : plans.found.total_m2s;
    const double outlook_m2s = zeta_m2s(inputs, plans, 0);
    for (std::size_t u = 0; u < answer.uavs.size(); ++u) {
        answer.uavs[u].outlook->zeta_m2s = outlook_m2s;
        if (plans.tails)
            answer.uavs[u].laterVisits =
                laterVisits(plans.models[u], request, plans.found.plans[u], plans.tails->visits(u));
    }
    answer.distance_m = flown_m(request, answer.uavs);
    if (plans.isStraight) {
        answer.predictedZeta_m2s.reset();
        for (UavPlan& uav : answer.uavs) {
            uav.legs.clear();
            uav.outlook.reset();
        }
    }
    return answer;
}

void judgeAlone(Plan& answer, const PlanRequest& request)
{
    const UavPlan& only = answer.uavs.front();
    VisitOrder nodes;
    for (const IcebergIndex iceberg : only.order)
        nodes.push_back(nodeOf(request.ids, iceberg));
    const TvpProblem problem = restrictedTo(
        {.distance_m = request.uavs.front().distance_m, .sigma_m2 = request.sigma_m2}, nodes);
    VisitOrder order = ascendingOrder(problem.icebergCount());
    answer.outcome.objective = objective(problem, order);
    answer.outcome.plan = {std::move(order)};
    answer.problem = problemOf(problem);
    answer.solvedIds = only.order;
    if (only.outlook && !only.outlook->sightings_s.empty())
        answer.distance_m = request.speed_mps * (only.outlook->sightings_s.back() -
                                                 request.uavs.front().prediction->time_s);
}

} // namespace berg
