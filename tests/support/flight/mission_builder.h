#pragma once

#include "core/io/export/formats.h"
#include "core/mission/visits.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace berg::test {

/**
 * Four drifting icebergs off Newfoundland, with a current, an area, a start time and names that
 * need quoting. The policy needs no solver.
 */
inline Scenario fourIcebergs()
{
    Scenario scenario;
    scenario.name = "Four icebergs";
    scenario.origin = {.latitude_deg = 47, .longitude_deg = -48};
    scenario.startUtc = "2026-05-01T23:59:30Z";
    scenario.duration_s = 400;
    scenario.seed = 7;
    scenario.current_mps = Point(0.1, 0);
    // clockwise on purpose
    scenario.area_m = {Point(-1000, -500), Point(-1000, 4000), Point(5000, 4500),
                       Point(5500, -500)};
    scenario.planner.policy = PolicyKind::Nearest;
    Uav uav;
    uav.id = "uav-1";
    uav.position_m = Point(-500, 500);
    scenario.uavs = {uav};
    const std::vector<std::pair<Point, Point>> places{{Point(2000, 1000), Point(0.3, -0.2)},
                                                      {Point(3500, 2500), Point(-0.1, 0.25)},
                                                      {Point(1200, 3000), Point(0, 0)},
                                                      {Point(4200, 500), Point(-0.2, -0.2)}};
    for (std::size_t i = 0; i < places.size(); ++i) {
        Iceberg iceberg;
        iceberg.id = "berg-" + std::to_string(i + 1);
        iceberg.position_m = places[i].first;
        iceberg.velocity_mps = places[i].second;
        iceberg.sigma0_m2 = 2.5 + static_cast<double>(i);
        scenario.icebergs.push_back(iceberg);
    }
    scenario.icebergs[1].name = "Tabular \"B\", grounded\nsince May";
    scenario.icebergs[2].name = "Isbjerg \xC3\x85";
    scenario.icebergs[3].observed_s = 100;
    return scenario;
}

/** `fourIcebergs` with a change. */
inline Scenario changed(const std::function<void(Scenario&)>& change)
{
    Scenario scenario = fourIcebergs();
    change(scenario);
    return scenario;
}

/** Two UAVs that differ in everything, a moving asset, a fence. */
inline Scenario twoUavsAndAsset()
{
    return changed([](Scenario& s) {
        s.uavs[0].id = "ravn";
        s.uavs[0].name = "\xC3\x86rfugl <1>";
        s.uavs[0].home_m = Point(-700, -300);
        s.uavs[0].heading_deg = 359.5;
        s.uavs[0].spec.altitude_m = 95.5;
        s.uavs[0].spec.airspeed_mps = 24.25;
        s.uavs.push_back(s.uavs[0]);
        s.uavs[1].id = "uav-1";
        s.uavs[1].name.clear();
        s.uavs[1].position_m = Point(3000, 2000);
        s.uavs[1].home_m.reset();
        s.uavs[1].heading_deg = 12;
        s.asset = Asset{.name = "Hibernia",
                        .position_m = Point(2500, 900),
                        .velocity_mps = Point(1.25, -0.5),
                        .range_m = 4500,
                        .extraJson = {}};
        s.geofence = true;
        s.planner.policy = PolicyKind::Visitation; // this policy gives each of them something to do
    });
}

/** Returns an answer of the planner with an order only. */
inline Plan planOf(IcebergList order)
{
    Plan plan;
    plan.uavs.emplace_back().order = std::move(order);
    return plan;
}

/** Returns the order in which the golden files visit `fourIcebergs`. */
inline Plan fourIcebergPlan()
{
    return planOf({0, 3, 1, 2});
}

/** Returns the visits of the only UAV. */
inline std::vector<Visit> plannedVisits(const Scenario& scenario, const Plan& plan)
{
    return berg::plannedVisits(scenario, plan.uavs.at(0).order, plan.uavs.at(0).clusters);
}

/** Returns the export content of a plan. It does not refer to the scenario. */
inline ExportContent planContent(const Scenario& scenario, const Plan& plan = fourIcebergPlan(),
                                 const ExportOptions& options = {})
{
    return exportContent({.scenario = scenario, .plan = plan}, options);
}

/** Returns the export content of a run, which must outlive it. */
inline ExportContent runContent(const Mission& mission, const ExportOptions& options = {})
{
    const Plan plan;
    return exportContent({.scenario = mission.scenario(), .plan = plan, .mission = &mission},
                         options);
}

/** Flies the mission until `until_s`, or to its end. */
inline Mission flown(const Scenario& scenario, double until_s = 1e9)
{
    Mission mission(scenario);
    mission.advance(until_s);
    return mission;
}

} // namespace berg::test
