#include "core/mission/visits.h"

#include "core/scenario/initial_truth.h"
#include "core/sim/clusters.h"
#include "core/sim/leg_flight.h"

#include <algorithm>
#include <map>
#include <memory>
#include <span>
#include <stdexcept>

namespace berg {

namespace {

/** Rebuilds the drift of one iceberg as the mission's simulation drew it. */
DriftModel driftOf(const Mission& mission, std::size_t iceberg)
{
    const Scenario& scenario = mission.scenario();
    const Iceberg& spec = mission.icebergs().at(iceberg);
    double start_s = 0;
    std::size_t added = scenario.icebergs.size();
    for (const Intervention& intervention : mission.interventions())
        if (intervention.appears && added++ == iceberg)
            start_s = intervention.time_s;
    return {trueDrift(scenario, spec, mission.simulation().world().weather(), start_s),
            static_cast<std::uint64_t>(scenario.seed), spec.id, scenario.noise};
}

/** Predicts the icebergs of the order from the start on. */
class PredictedPlaces
{
public:
    explicit PredictedPlaces(const Scenario& scenario)
        : m_scenario(scenario), m_weather(weatherOf(scenario))
    {
    }

    DriftAhead& of(IcebergIndex iceberg)
    {
        auto found = m_places.find(iceberg);
        if (found == m_places.end()) {
            const Iceberg& spec = m_scenario.icebergs.at(toIndex(iceberg));
            found = m_places
                        .emplace(iceberg, DriftAhead(trackAtStart(m_scenario, spec, m_weather),
                                                     forcingOf(m_weather, spec), 0))
                        .first;
        }
        return found->second;
    }

private:
    const Scenario& m_scenario;
    std::shared_ptr<const FlightWeather> m_weather;
    std::map<IcebergIndex, DriftAhead> m_places;
};

/** Flies on to the cluster and returns the visit. */
Visit visitOf(std::span<const IcebergIndex> members, PredictedPlaces& places, LegFlight& flight)
{
    const Circle met = flight.flyTo([&](double time_s) {
        return circleRound(members,
                           [&](IcebergIndex member) { return places.of(member).at_m(time_s); });
    });
    return {.iceberg = members.front(),
            .time_s = flight.time_s(),
            .position_m = met.centre_m,
            .members = {members.begin(), members.end()},
            .spread_m = met.radius_m};
}

/** Returns the cluster reached by the event; empty for a single iceberg. */
std::span<const IcebergIndex> clusterReached(const Mission& mission, const MissionEvent& reached)
{
    const std::vector<PlanPointer>& plans = mission.plans();
    const auto after = std::ranges::lower_bound(plans, reached.time_s, {}, &Plan::time_s);
    const auto before = std::span(plans).first(static_cast<std::size_t>(after - plans.begin()));
    const PlanPointer plan = lastPlanOf(before, *reached.uav);
    return plan ? clusterWith(plan->of(*reached.uav)->clusters, *reached.iceberg)
                : std::span<const IcebergIndex>();
}

} // namespace

std::vector<Visit> plannedVisits(const Scenario& scenario, const IcebergList& order,
                                 const std::vector<IcebergList>& clusters)
{
    const Uav& uav = scenario.uavs.at(0);
    LegFlight flight(uav.position_m, uav.spec.airspeed_mps, windFromStart(scenario));
    PredictedPlaces places(scenario);
    std::vector<Visit> visits;
    const bool endures = uav.spec.endurance_s == 0;
    const auto count =
        endures ? order.size()
                : static_cast<std::size_t>(*thisSortie(Simulation(scenario), 0, order, clusters));
    for (const IcebergIndex index : std::span(order).first(count)) {
        const std::span<const IcebergIndex> members = clusterWith(clusters, index);
        if (!members.empty()) {
            if (index == members.front())
                visits.push_back(visitOf(members, places, flight));
            continue;
        }
        const Point met_m = flight.flyTo(places.of(index), 0);
        visits.push_back({.iceberg = index, .time_s = flight.time_s(), .position_m = met_m});
    }
    // Other policies do not use the route setting.
    const bool closed =
        scenario.planner.route == Route::Closed && traitsOf(scenario.planner.policy).usesTau;
    if (!endures || (closed && !visits.empty())) {
        const Point end_m = endures ? uav.position_m : uav.home_m.value_or(uav.position_m);
        flight.flyTo(end_m, Point::Zero());
        visits.push_back({.time_s = flight.time_s(), .position_m = end_m});
    }
    return visits;
}

std::vector<Visit> flownVisits(const Mission& mission, int uav)
{
    // Drift is drawn again, because samples may be far apart.
    std::vector<DriftModel> drift;
    for (std::size_t i = 0; i < mission.icebergs().size(); ++i)
        drift.push_back(driftOf(mission, i));
    std::vector<Visit> visits;
    for (const MissionEvent& event : mission.events()) {
        if (event.kind != EventKind::Reached || event.uav != uav)
            continue;
        const auto truth_m = [&](IcebergIndex iceberg) {
            return drift.at(toIndex(iceberg)).position_m(event.time_s);
        };
        const std::span<const IcebergIndex> members = clusterReached(mission, event);
        const Circle circle =
            circleRound(members.empty() ? std::span(&*event.iceberg, 1) : members, truth_m);
        visits.push_back({.iceberg = event.iceberg,
                          .time_s = event.time_s,
                          .position_m = circle.centre_m,
                          .members = {members.begin(), members.end()},
                          .spread_m = circle.radius_m});
    }
    return visits;
}

IcebergList icebergsOf(const Visit& visit)
{
    return visit.members.empty() && visit.iceberg ? std::vector{*visit.iceberg} : visit.members;
}

} // namespace berg
