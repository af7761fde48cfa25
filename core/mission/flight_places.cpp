#include "core/mission/flight_places.h"

#include "core/base/error.h"
#include "core/mission/plan_forecast.h"

#include <algorithm>

namespace berg {

namespace {

constexpr double kPlaceInterval_s = 60;

ForecastStart startOfPlan(const Simulation& start)
{
    ForecastStart forecast{
        .world = start.state(), .time_s = start.time_s(), .wind_mps = start.motion(0).wind_mps};
    for (int uav = 0; uav < start.uavCount(); ++uav)
        forecast.airspeeds_mps.push_back(start.motion(uav).airspeed_mps);
    for (const IcebergIndex iceberg : start.icebergs())
        forecast.active.push_back(start.active(iceberg));
    return forecast;
}

/** Returns the end of the UAV's first sortie, or of the run. */
double endOfFlight_s(const Scenario& scenario, const Uav& uav)
{
    return uav.spec.endurance_s > 0 ? std::min(scenario.duration_s, uav.spec.endurance_s)
                                    : scenario.duration_s;
}

/** Returns the place at a time on the straight line between two places. */
FlightPlace between(const FlightPlace& from, const FlightPlace& to, double time_s)
{
    const double part = (time_s - from.time_s) / (to.time_s - from.time_s);
    return {.time_s = time_s,
            .position_m = from.position_m + part * (to.position_m - from.position_m)};
}

} // namespace

bool FlightPlaces::isDue(double time_s) const
{
    return !m_last_s || time_s >= *m_last_s + kPlaceInterval_s;
}

void FlightPlaces::add(std::size_t uav, const FlightPlace& place, bool isOnGround)
{
    std::vector<FlightPlace>& flight = m_flights.at(uav);
    if (!isOnGround)
        flight.push_back(place);
    else if (!flight.empty())
        flight.back().isLanding = true;
}

void FlightPlaces::addAll(const Simulation& simulation)
{
    m_last_s = simulation.time_s();
    m_flights.resize(static_cast<std::size_t>(simulation.uavCount()));
    for (int uav = 0; uav < simulation.uavCount(); ++uav) {
        const UavState state = simulation.uav(uav);
        add(static_cast<std::size_t>(uav),
            {.time_s = simulation.time_s(), .position_m = state.pose.position_m},
            state.mode == FlightMode::Ground);
    }
}

void FlightPlaces::note(const Simulation& simulation)
{
    if (isDue(simulation.time_s()))
        addAll(simulation);
}

void FlightPlaces::finish(const Simulation& simulation)
{
    if (!m_last_s || simulation.time_s() > *m_last_s)
        addAll(simulation);
}

void FlightPlaces::note(const Sample& sample)
{
    if (!isDue(sample.time_s))
        return;
    m_last_s = sample.time_s;
    m_flights.resize(sample.uavs.size());
    for (std::size_t uav = 0; uav < sample.uavs.size(); ++uav)
        add(uav, {.time_s = sample.time_s, .position_m = sample.uavs[uav].pose.position_m},
            sample.uavs[uav].onGround);
}

std::vector<std::vector<FlightPlace>> plannedFlights(const Scenario& scenario, const Plan& plan)
{
    const Simulation start(scenario);
    std::vector<std::vector<FlightPlace>> flights;
    OrdersByUav orders(scenario.uavs.size());
    std::vector<IcebergList> clusters;
    for (const UavPlan& own : plan.uavs) {
        orders.at(static_cast<std::size_t>(own.uav)) = own.order;
        clusters.insert(clusters.end(), own.clusters.begin(), own.clusters.end());
    }
    const PlanForecast forecast =
        forecastPlan(startOfPlan(start), orders, scenario.duration_s, clusters);
    for (std::size_t i = 0; i < scenario.uavs.size(); ++i) {
        const double end_s = endOfFlight_s(scenario, scenario.uavs[i]);
        std::vector<FlightPlace> flight{{.position_m = scenario.uavs[i].position_m}};
        for (const ForecastVisit& visit : forecast.uavs.at(i).visits) {
            const FlightPlace next{.time_s = visit.arrival_s, .position_m = visit.place_m};
            if (!(next.time_s > flight.back().time_s))
                continue;
            flight.push_back(next.time_s > end_s ? between(flight.back(), next, end_s) : next);
            if (next.time_s >= end_s)
                break;
        }
        if (flight.back().time_s < end_s)
            flight.push_back({.time_s = end_s, .position_m = flight.back().position_m});
        flights.push_back(std::move(flight));
    }
    return flights;
}

} // namespace berg
