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
#include <utility>

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

Json uavJson(const PlanReport& report, std::size_t k)
{
    const UavPlan& uav = report.plan.uavs[k];
    const UavLength& length = report.lengths[k];
    Json json{{"id", report.uavId(k)},
              {"order", report.numbersOf(uav.order)},
              {"icebergs", report.idsOf(uav.order)},
              {"distance_m", length.distance_m}};
    if (uav.thisSortie)
        json["this_sortie"] = *uav.thisSortie;
    if (length.slot_s)
        json["recovery_slot_s"] = *length.slot_s;
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
    if (plan.outcome.status == SolveStatus::None || plan.problem.sigma_m2.empty())
        return std::nullopt;
    return plan.outcome.objective;
}

std::optional<double> PlanReport::gap() const
{
    if (!objective() || !plan.outcome.bound)
        return std::nullopt;
    return relativeGap(plan.problem, plan.outcome.objective, *plan.outcome.bound);
}

std::optional<double> PlanReport::mu() const
{
    return plan.problem.sigma_m2.empty() ? std::nullopt : std::optional(plan.problem.mu);
}

std::vector<IcebergList> PlanReport::clusters() const
{
    std::vector<IcebergList> all;
    for (const UavPlan& own : plan.uavs)
        all.insert(all.end(), own.clusters.begin(), own.clusters.end());
    std::ranges::sort(all);
    return all;
}

std::vector<int> PlanReport::numbersOf(const IcebergList& icebergs) const
{
    std::vector<int> numbers;
    for (const IcebergIndex iceberg : icebergs)
        numbers.push_back(iceberg.number() + firstNumber);
    return numbers;
}

std::vector<std::string> PlanReport::idsOf(const IcebergList& icebergs) const
{
    std::vector<std::string> ids;
    if (scenario != nullptr)
        for (const IcebergIndex iceberg : icebergs)
            ids.push_back(scenario->icebergs[toIndex(iceberg)].id);
    return ids;
}

std::string PlanReport::uavId(std::size_t k) const
{
    return scenario == nullptr ? std::string() : scenario->uavs[toIndex(plan.uavs[k].uav)].id;
}

PlanReport planReport(const Scenario& scenario, Plan plan)
{
    const Simulation start(scenario);
    const PlanRequest request = requestFor(start, scenario.planner.policy);
    require(plan.uavs.size() == request.uavs.size(), "planReport: an answer for each UAV");
    PlanReport report{.plan = std::move(plan), .scenario = &scenario};
    for (std::size_t k = 0; k < request.uavs.size(); ++k) {
        UavPlan& own = report.plan.uavs[k];
        const UavRequest& asked = request.uavs[k];
        own.uav = asked.uav;
        own.thisSortie = thisSortie(start, asked.uav, own.order, own.clusters);
        report.lengths.push_back({.distance_m = ownDistance_m(request, asked, scenario, own.order),
                                  .slot_s = slotOfSortie_s(scenario, toIndex(asked.uav),
                                                           start.uav(asked.uav).withheld_s)});
        report.distance_m += report.lengths.back().distance_m;
    }
    if (hasWeatherLimits(scenario)) {
        report.weather = weatherAlong(scenario, plannedFlights(scenario, report.plan));
        report.weatherLine = weatherLine(scenario, *report.weather);
        for (const Uav& uav : scenario.uavs)
            report.weatherUavs.push_back(uav.id);
    }
    const PolicyKind policy = scenario.planner.policy;
    if (report.lengths.size() == 1 && policy == PolicyKind::Tour)
        report.path = LengthKind::Round;
    if (report.lengths.size() == 1 && policy == PolicyKind::Coverage)
        report.path = LengthKind::Flight;
    if (report.path != LengthKind::Order)
        report.lengths.front().distance_m = report.distance_m = report.plan.distance_m;
    return report;
}

std::string planJson(const PlanReport& report)
{
    const SolveOutcome& outcome = report.plan.outcome;
    const bool solved = outcome.status != SolveStatus::None;
    IcebergList order;
    for (const UavPlan& uav : report.plan.uavs)
        order.insert(order.end(), uav.order.begin(), uav.order.end());
    const std::vector<std::string> ids = report.idsOf(order);
    Json json{{"status", nameOf(kStatusNames, outcome.status)},
              {"objective", orNull(report.objective())},
              {"bound", orNull(outcome.bound)},
              {"gap", orNull(report.gap())},
              {"order", report.numbersOf(order)},
              {"distance_m", solved ? Json(report.distance_m) : Json(nullptr)},
              {"mu", orNull(report.mu())},
              {"seconds", outcome.elapsed_s},
              {"backend", nameOf(kSourceNames, outcome.source)}};
    if (!ids.empty()) // a problem without a scenario has no ids
        json["icebergs"] = ids;
    Json together = Json::array();
    for (const IcebergList& members : report.clusters())
        together.push_back(report.idsOf(members));
    if (!together.empty())
        json["clusters"] = together;
    Json uavs = Json::array();
    for (std::size_t k = 0; k < report.lengths.size(); ++k)
        uavs.push_back(uavJson(report, k));
    if (!ids.empty())
        json["uavs"] = uavs;
    if (report.secondOpinion)
        json["verify"] = secondOpinionJson(*report.secondOpinion);
    if (report.weather)
        json["weather"] = weatherTree(report.weatherUavs, *report.weather);
    return resultText(json);
}

} // namespace berg
