#include "core/io/results/plan_result.h"

#include "core/io/results/result_parts.h"
#include "core/io/results/weather_result.h"
#include "core/mission/flight_places.h"
#include "core/mission/plan_requests.h"
#include "core/plan/policy/fleet_task.h"
#include "core/plan/solve/names.h"
#include "core/scenario/recovery.h"
#include "core/sim/clusters.h"
#include "core/sim/simulation.h"

#include <algorithm>
#include <iterator>

namespace berg {

namespace {

using Json = ResultJson;

/**
 * Length of the order for a UAV. A request measures distances in the unit of its first UAV; they
 * are converted to the UAV's own airspeed.
 */
double ownDistance_m(const PlanRequest& request, const UavRequest& uav, const Scenario& scenario,
                     const IcebergList& order)
{
    const double ownUnit = scenario.uavs[toIndex(uav.uav)].spec.airspeed_mps / request.speed_mps;
    double distance_m = 0;
    NodeIndex from;
    for (const IcebergIndex iceberg : order) {
        if (std::ranges::find(request.ids, iceberg) == request.ids.end())
            continue; // reached together with the first member of its cluster
        const NodeIndex to = nodeOf(request.ids, iceberg);
        distance_m += legBetween(uav.distance_m, from, to) * ownUnit;
        from = to;
    }
    if (scenario.planner.route == Route::Closed)
        distance_m += legBetween(uav.distance_m, from, 0) * ownUnit;
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
    if (uav.slot_s)
        json["recovery_slot_s"] = *uav.slot_s;
    return json;
}

Json secondOpinionJson(const SecondOpinion& second)
{
    const SolveOutcome& outcome = second.outcome;
    const bool solved = outcome.status != SolveStatus::None;
    Json agrees = nullptr; // not verified
    if (second.verdict != Verdict::NotVerified)
        agrees = second.verdict == Verdict::Agrees;
    return {{"agrees", agrees},
            {"backend", nameOf(kSourceNames, outcome.source)},
            {"formulation", second.formulation
                                ? Json(nameOf(kFormulationNames, *second.formulation))
                                : Json(nullptr)},
            {"status", nameOf(kStatusNames, outcome.status)},
            {"objective", solved ? Json(outcome.objective) : Json(nullptr)},
            {"bound", orNull(outcome.bound)},
            {"seconds", outcome.elapsed_s}};
}

} // namespace

std::optional<double> PlanReport::objective() const
{
    if (outcome.status == SolveStatus::None || problem.sigma_m2.empty())
        return std::nullopt;
    return outcome.objective;
}

std::optional<double> PlanReport::gap() const
{
    if (!objective() || !outcome.bound)
        return std::nullopt;
    return relativeGap(problem, outcome.objective, *outcome.bound);
}

std::optional<double> PlanReport::mu() const
{
    return problem.sigma_m2.empty() ? std::nullopt : std::optional(problem.mu);
}

PlanReport planReport(const Scenario& scenario, const Plan& answer)
{
    const Simulation start(scenario);
    const PlanRequest request = requestFor(start, scenario.planner.policy);
    require(answer.uavs.size() == request.uavs.size(), "planReport: an answer for each UAV");
    const auto idOf = [&](IcebergIndex iceberg) { return scenario.icebergs[toIndex(iceberg)].id; };
    PlanReport report{.problem = answer.problem, .outcome = answer.outcome, .uavs = {}};
    for (std::size_t k = 0; k < answer.uavs.size(); ++k) {
        const IcebergList& order = answer.uavs[k].order;
        const UavRequest& asked = request.uavs[k];
        UavReport uav{.id = scenario.uavs[toIndex(asked.uav)].id,
                      .order = {},
                      .ids = {},
                      .distance_m = ownDistance_m(request, asked, scenario, order),
                      .thisSortie = thisSortie(start, asked.uav, order, answer.uavs[k].clusters),
                      .slot_s = slotOfSortie_s(scenario, toIndex(asked.uav),
                                               start.uav(asked.uav).withheld_s)};
        for (const IcebergIndex iceberg : order) {
            uav.order.push_back(iceberg.number() + 1);
            uav.ids.push_back(idOf(iceberg));
        }
        report.distance_m += uav.distance_m;
        report.uavs.push_back(std::move(uav));
    }
    if (hasWeatherLimits(scenario)) {
        report.weather = weatherAlong(scenario, plannedFlights(scenario, answer));
        report.weatherLine = weatherLine(scenario, *report.weather);
        for (const Uav& uav : scenario.uavs)
            report.weatherUavs.push_back(uav.id);
    }
    const PolicyKind policy = scenario.planner.policy;
    if (report.uavs.size() == 1 && policy == PolicyKind::Tour)
        report.path = LengthKind::Round;
    if (report.uavs.size() == 1 && policy == PolicyKind::Coverage)
        report.path = LengthKind::Flight;
    if (report.path != LengthKind::Order)
        report.uavs.front().distance_m = report.distance_m = answer.distance_m;
    std::vector<IcebergList> clusters;
    for (const UavPlan& own : answer.uavs)
        clusters.insert(clusters.end(), own.clusters.begin(), own.clusters.end());
    std::ranges::sort(clusters);
    for (const IcebergList& members : clusters)
        std::ranges::transform(members, std::back_inserter(report.clusters.emplace_back()), idOf);
    return report;
}

std::string planJson(const PlanReport& report)
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
    Json json{{"status", nameOf(kStatusNames, outcome.status)},
              {"objective", orNull(report.objective())},
              {"bound", orNull(outcome.bound)},
              {"gap", orNull(report.gap())},
              {"order", order},
              {"distance_m", solved ? Json(report.distance_m) : Json(nullptr)},
              {"mu", orNull(report.mu())},
              {"seconds", outcome.elapsed_s},
              {"backend", nameOf(kSourceNames, outcome.source)}};
    if (!ids.empty()) // a problem without a scenario has no ids
        json["icebergs"] = ids;
    if (!report.clusters.empty())
        json["clusters"] = report.clusters;
    if (!ids.empty())
        json["uavs"] = uavs;
    if (report.secondOpinion)
        json["verify"] = secondOpinionJson(*report.secondOpinion);
    if (report.weather)
        json["weather"] = weatherTree(report.weatherUavs, *report.weather);
    return resultText(json);
}

} // namespace berg
