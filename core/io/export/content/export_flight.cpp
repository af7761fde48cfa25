#include "core/io/export/content/export_flight.h"

#include "core/base/angles.h"
#include "core/mission/policy_forecast.h"
#include "core/scenario/utc_time.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

/** Time after the end of any flight. */
constexpr double kNever_s = 2 * kLargestTime_s;

/** Returns the iceberg at its estimate, for a scenario that starts now. */
Iceberg presentIceberg(const Iceberg& iceberg, const Simulation& simulation, IcebergIndex index)
{
    Iceberg now = iceberg;
    now.track = {};
    const double appears_s = iceberg.appears_s - simulation.time_s();
    now.appears_s = simulation.active(index) ? 0 : appears_s > 0 ? appears_s : kNever_s;
    if (now.appears_s > 0)
        return now;
    const Track& track = simulation.track(index);
    now.position_m = simulation.observer().estimate_m(index);
    now.velocity_mps = track.velocity_mps - track.mean_mps; // the scenario still adds the current
    now.sigma0_m2 = track.sigma_m2;
    now.velocitySd_mps = std::sqrt(track.velocity_m2ps2);
    now.observed_s = 0;
    return now;
}

void advanceToNow(Uav& uav, const UavState& now, double least_s)
{
    uav.position_m = now.pose.position_m;
    uav.heading_deg = headingFromPsi(now.pose.psi_rad);
    if (uav.spec.endurance_s == 0)
        return;
    const double left_s = std::max(least_s, usableEndurance_s(uav.spec) - now.aloft_s);
    uav.spec.reserve_s = reserve_s(uav.spec); // fixed by the whole endurance, not by what is left
    uav.spec.climb_s = 0;                     // the climb is over
    uav.spec.endurance_s = left_s + *uav.spec.reserve_s + uav.spec.landing_s;
}

/** Lets the scenario start now in its forecast, whose wind a report of the crew has replaced. */
void advanceForecast(Scenario& scene, const Simulation& simulation)
{
    if (const std::optional<UtcTime> start = parseUtc(scene.startUtc))
        scene.startUtc = utcText(*start, simulation.time_s());
    if (!simulation.fleet().isWindReported())
        return;
    scene.wind_mps = simulation.motion(0).wind_mps;
    for (Forecast& place : scene.forecast->places)
        for (ForecastEntry& entry : place.series)
            entry.wind_mps.reset();
}

/** Updates the scenario, which has UAV `row` only, to the present state of the mission. */
void advanceToNow(Scenario& scene, const Mission& mission, int row)
{
    const Simulation& simulation = mission.simulation();
    scene.planner = mission.plannerSettings();
    if (scene.forecast)
        advanceForecast(scene, simulation);
    else
        scene.wind_mps = simulation.motion(row).wind_mps;
    scene.asset = simulation.world().asset();
    scene.icebergs.clear();
    for (const Iceberg& iceberg : mission.icebergs())
        scene.icebergs.push_back(
            presentIceberg(iceberg, simulation, IcebergIndex::of(scene.icebergs.size())));
    scene.uavs.front().home_m = simulation.fleet().autopilot(row).home_m();
    advanceToNow(scene.uavs.front(), simulation.uav(row), simulation.world().dt_s());
}

} // namespace

UavPlan presentPlan(const ExportSource& source, std::size_t row)
{
    const int uav = static_cast<int>(row);
    const PlanPointer last = source.mission ? lastPlanOf(source.mission->plans(), uav) : nullptr;
    const UavPlan* own = last ? last->of(uav) : source.plan.of(uav);
    if (own == nullptr || (last && !source.mission->simulation().uav(uav).isPlanned()))
        return {};
    UavPlan plan = *own;
    if (!last)
        return plan;
    const Simulation& simulation = source.mission->simulation();
    if (!plan.legs.empty() && simulation.uav(uav).aim)
        plan.legs.front() = *simulation.uav(uav).aim; // the rest of the current turn
    for (AimedLeg& leg : plan.legs) {
        leg.sighting_s -= simulation.time_s();
        if (leg.end_s)
            *leg.end_s -= simulation.time_s();
    }
    return plan;
}

Scenario presentScene(const ExportSource& source, std::size_t row)
{
    Scenario scene = withoutUnknowns(source.scenario, source.scenario.planner.policy);
    scene.uavs = {source.scenario.uavs.at(row)};
    if (source.mission != nullptr)
        advanceToNow(scene, *source.mission, static_cast<int>(row));
    for (Iceberg& iceberg : scene.icebergs)
        iceberg.uav.clear(); // the order determines the UAV
    return scene;
}

TrackPoints flownTrack(const Mission& mission, std::size_t row)
{
    TrackPoints track;
    for (const Sample& sample : mission.recorder().samples())
        track.append(trackPointOf(sample, row));
    return track;
}

} // namespace berg
