#include "core/io/visits.h"

#include <stdexcept>

namespace berg {

namespace {

/** A UAV under way along the plan. */
class Flight
{
public:
    explicit Flight(const Scenario& scenario)
        : m_airspeed_mps(scenario.uavs.at(0).spec.airspeed_mps)
        , m_wind_mps(scenario.wind_mps)
        , m_position_m(scenario.uavs[0].position_m)
    {
    }

    [[nodiscard]] double time_s() const { return m_time_s; }

    /** Flies to what is at `place_m` now and drifts with `drift_mps`; returns where it is met. */
    Point flyTo(const Point& place_m, const Point& drift_mps)
    {
        const Point relativeWind_mps = m_wind_mps - drift_mps;
        const bool sure = relativeWind_mps.norm() < m_airspeed_mps;
        const Point leg_m = place_m - m_position_m;
        const double flight_s =
            flightTime_s(leg_m, m_airspeed_mps, sure ? relativeWind_mps : m_wind_mps);
        m_time_s += flight_s;
        m_position_m = sure ? Point(place_m + drift_mps * flight_s) : place_m;
        return m_position_m;
    }

private:
    double m_airspeed_mps;
    Point m_wind_mps;
    Point m_position_m;
    double m_time_s = 0;
};

/** The drift of one iceberg of a mission, as its simulation made it. */
DriftModel driftOf(const Mission& mission, std::size_t iceberg)
{
    const Scenario& scenario = mission.scenario();
    const Iceberg& spec = mission.icebergs().at(iceberg);
    double start_s = 0;
    std::size_t added = scenario.icebergs.size();
    for (const Intervention& intervention : mission.interventions())
        if (intervention.appears && added++ == iceberg)
            start_s = intervention.time_s;
    return {DriftSpec{.position_m = spec.position_m,
                      .start_s = start_s,
                      .velocity_mps = spec.velocity_mps + scenario.current_mps,
                      .q_m2ps = spec.q_m2ps,
                      .track = spec.track.empty()
                                   ? nullptr
                                   : std::make_shared<const RecordedTrack>(spec.track)},
            static_cast<std::uint64_t>(scenario.seed), spec.id, scenario.noise};
}

} // namespace

std::vector<Visit> plannedVisits(const Scenario& scenario, const PlanAnswer& plan)
{
    Flight flight(scenario);
    std::vector<Visit> visits;
    for (const int index : plan.order) {
        const Iceberg& iceberg = scenario.icebergs.at(static_cast<std::size_t>(index));
        const Point drift_mps = iceberg.velocity_mps + scenario.current_mps;
        const Point now_m = iceberg.position_m + drift_mps * flight.time_s();
        const Point met_m = flight.flyTo(now_m, drift_mps);
        visits.push_back({.iceberg = index, .time_s = flight.time_s(), .position_m = met_m});
    }
    // The other policies do not read the route.
    const bool closed = scenario.planner.route == Route::Closed &&
                        scenario.planner.policy == PolicyKind::Visitation;
    if (closed && !visits.empty()) {
        const Point start_m = flight.flyTo(scenario.uavs.at(0).position_m, Point::Zero());
        visits.push_back({.time_s = flight.time_s(), .position_m = start_m});
    }
    return visits;
}

std::vector<Visit> flownVisits(const Mission& mission)
{
    // Drift is drawn anew rather than read between samples, which may be far apart.
    std::vector<DriftModel> drift;
    for (std::size_t i = 0; i < mission.icebergs().size(); ++i)
        drift.push_back(driftOf(mission, i));
    std::vector<Visit> visits;
    for (const MissionEvent& event : mission.events()) {
        if (event.kind != EventKind::Reached)
            continue;
        DriftModel& model = drift.at(static_cast<std::size_t>(event.iceberg));
        visits.push_back({.iceberg = event.iceberg,
                          .time_s = event.time_s,
                          .position_m = model.position_m(event.time_s)});
    }
    return visits;
}

std::vector<Visit> visitsOf(const ExportSource& source)
{
    return source.mission ? flownVisits(*source.mission)
                          : plannedVisits(source.scenario, source.plan);
}

const std::vector<Iceberg>& icebergsOf(const ExportSource& source)
{
    return source.mission ? source.mission->icebergs() : source.scenario.icebergs;
}

} // namespace berg
