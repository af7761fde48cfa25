#include "core/io/results/fleet_result.h"

#include "core/io/results/result_parts.h"
#include "core/plan/policy/fleet_task.h"
#include "core/plan/policy/policy.h"
#include "core/sim/clusters.h"
#include "core/sim/simulation.h"

#include <numeric>

namespace berg {

namespace {

using Json = ResultJson;

/** Distances of a request are in the unit of the fleet: those of the UAV's own speed. */
double ownDistance_m(const PlanRequest& request, const UavRequest& uav, const Scenario& scenario,
                     const std::vector<int>& order)
{
    const double ownUnit =
        scenario.uavs[static_cast<std::size_t>(uav.uav)].spec.airspeed_mps / request.speed_mps;
    double distance_m = 0;
    int from = 0;
    for (const int id : order) {
        const int to = nodeOfId(request, id);
        distance_m += uav.distance_m(from, to) * ownUnit;
        from = to;
    }
    if (scenario.planner.route == Route::Closed)
        distance_m += uav.distance_m(from, 0) * ownUnit;
    return distance_m;
}

Json uavJson(const UavReport& uav)
{
    Json json{{"id", uav.id},
              {"order", uav.order},
              {"icebergs", uav.ids},
              {"distance_m", uav.distance_m}};
    if (uav.thisSortie)
        json["this_sortie"] = *uav.thisSortie;
    return json;
}

} // namespace

double FleetReport::distance_m() const
{
    return std::accumulate(uavs.begin(), uavs.end(), 0.0, [](double sum_m, const UavReport& uav) {
        return sum_m + uav.distance_m;
    });
}

FleetReport fleetReport(const Scenario& scenario, const PlanAnswer& answer)
{
    const Simulation start(scenario);
    const PlanRequest request = requestFor(start, scenario.planner.policy);
    require(answer.fleet.size() == request.fleet.size(), "fleetReport: an answer for each UAV");
    FleetReport report;
    report.outcome = answer.outcome;
    report.gap = answer.gap;
    if (scenario.planner.policy == PolicyKind::Visitation)
        report.mu = answer.problem.mu;
    if (answer.outcome.status != SolveStatus::None &&
        scenario.planner.policy != PolicyKind::Coverage)
        report.objective = answer.outcome.objective;
    for (std::size_t k = 0; k < answer.fleet.size(); ++k) {
        const std::vector<int>& order = answer.fleet[k].order;
        const UavRequest& asked = request.fleet[k];
        UavReport uav{.id = scenario.uavs[static_cast<std::size_t>(asked.uav)].id,
                      .distance_m = ownDistance_m(request, asked, scenario, order),
                      .thisSortie = thisSortie(start, asked.uav, order, answer.clusters)};
        for (const int iceberg : order) {
            uav.order.push_back(iceberg + 1);
            uav.ids.push_back(scenario.icebergs[static_cast<std::size_t>(iceberg)].id);
        }
        report.uavs.push_back(std::move(uav));
    }
    return report;
}

std::string fleetJson(const FleetReport& report)
{
    const SolveOutcome& outcome = report.outcome;
    const bool solved = outcome.status != SolveStatus::None;
    std::vector<int> order;
    std::vector<std::string> ids;
    Json uavs = Json::array();
    for (const UavReport& uav : report.uavs) {
        order.insert(order.end(), uav.order.begin(), uav.order.end());
        ids.insert(ids.end(), uav.ids.begin(), uav.ids.end());
        uavs.push_back(uavJson(uav));
    }
    const Json json{{"status", nameOf(kStatusNames, outcome.status)},
                    {"objective", orNull(report.objective)},
                    {"bound", orNull(outcome.bound)},
                    {"gap", orNull(report.gap)},
                    {"order", order},
                    {"distance_m", solved ? Json(report.distance_m()) : Json(nullptr)},
                    {"mu", orNull(report.mu)},
                    {"seconds", outcome.elapsed_s},
                    {"backend", outcome.backend},
                    {"icebergs", ids},
                    {"uavs", uavs}};
    return resultText(json);
}

} // namespace berg
