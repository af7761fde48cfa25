#pragma once

#include "core/base/angles.h"
#include "core/base/random.h"
#include "core/mission/mission.h"
#include "core/scenario/scenario.h"
#include "core/vehicle/geofence.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace berg::test {

/**
 * A flight with any combination of features: one to four UAVs, with and without endurance, wind,
 * fence, either observer with causes for lost icebergs, icebergs that appear, are assigned or have
 * unexpected drift, every policy, and changes in flight.
 */
class RandomFleet
{
public:
    /**
     * Returns the flight of this number with measured icebergs whose velocities change, and several
     * UAVs.
     */
    [[nodiscard]] static RandomFleet withChangingVelocities(std::uint64_t seed)
    {
        RandomFleet fleet(seed);
        fleet.m_random = Random(seed, 223);
        fleet.m_scenario.observer.model = ObserverModel::Kalman;
        for (Iceberg& iceberg : fleet.m_scenario.icebergs) {
            iceberg.velocitySpread_mps = fleet.m_random.uniform(0.02, 0.2);
            iceberg.velocityTime_s = fleet.m_random.uniform(600, 36'000);
        }
        fleet.m_scenario.noFly.clear(); // areas in which additional UAVs may start
        if (fleet.m_scenario.asset)
            fleet.m_scenario.asset->standoff_m = 0;
        while (fleet.m_scenario.uavs.size() < 3)
            fleet.drawUav(static_cast<int>(fleet.m_scenario.uavs.size()));
        return fleet;
    }

    explicit RandomFleet(std::uint64_t seed) : m_random(seed, 221)
    {
        m_scenario.seed = static_cast<std::int64_t>(seed);
        m_scenario.duration_s = m_random.uniform(1500, 3500);
        if (oneIn(2))
            m_scenario.wind_mps = point_m(9);
        if (oneIn(3))
            drawFence();
        drawObserver();
        drawPlanner();
        const auto uavs = static_cast<int>(1 + m_random.below(4));
        for (int i = 0; i < uavs; ++i)
            drawUav(i);
        const auto icebergs = static_cast<int>(3 + m_random.below(12));
        for (int i = 0; i < icebergs; ++i)
            m_scenario.icebergs.push_back(iceberg("berg-" + std::to_string(i + 1)));
        drawChange();
        // a separate stream leaves the flights of older seeds unchanged
        m_random = Random(seed, 222);
        if (oneIn(3))
            drawAreas();
        if (oneIn(3))
            drawOrders();
        std::ranges::stable_sort(m_changes, {}, &Intervention::time_s);
    }

    [[nodiscard]] const Scenario& scenario() const { return m_scenario; }
    /** Changes in flight at ascending whole seconds. */
    [[nodiscard]] const std::vector<Intervention>& changes() const { return m_changes; }

private:
    bool oneIn(std::uint64_t count) { return m_random.below(count) == 0; }
    Point point_m(double largest_m)
    {
        const double x_m = m_random.uniform(-largest_m, largest_m);
        return {x_m, m_random.uniform(-largest_m, largest_m)};
    }
    /** Returns a place in the fence with this clearance, or anywhere without a fence. */
    Point place_m(double clear_m)
    {
        for (;;) {
            const Point place_m = point_m(3500);
            if (!m_scenario.geofence || (insidePolygon(m_scenario.area_m, place_m) &&
                                         distanceToEdges(m_scenario.area_m, place_m) >= clear_m))
                return place_m;
        }
    }
    void drawFence()
    {
        m_scenario.geofence = true;
        const bool isConvex = oneIn(2);
        const auto corners = static_cast<int>(5 + m_random.below(8));
        for (int i = 0; i < corners; ++i) {
            const double angle_rad = 2 * kPi * (i + m_random.uniform(-0.3, 0.3)) / corners;
            const double away_m = isConvex ? 4500 : m_random.uniform(2200, 4500);
            m_scenario.area_m.push_back(away_m * Point(std::cos(angle_rad), std::sin(angle_rad)));
        }
    }
    void drawObserver()
    {
        if (oneIn(2))
            m_scenario.observer = {.model = ObserverModel::Kalman,
                                   .interval_s = oneIn(2) ? 1.0 : 5.0,
                                   .detection = oneIn(2) ? 1.0 : 0.8};
        if (oneIn(3))
            m_scenario.observer.search = SearchPattern::Sector;
    }
    void drawPlanner()
    {
        m_scenario.planner.policy = static_cast<PolicyKind>(m_random.below(kPolicyTable.size()));
        m_scenario.clusters = oneIn(4);
        if (oneIn(3))
            m_scenario.planningTime_s = m_random.uniform(1, 10);
        if (oneIn(5))
            m_scenario.reachRadius_m = m_random.uniform(150, 300);
        if (oneIn(3))
            m_scenario.fovShape = oneIn(2) ? FovShape::Disk : FovShape::North;
        if (oneIn(5))
            m_scenario.asset = Asset{.name = "rig", .position_m = point_m(3000), .extraJson = {}};
    }
    void drawUav(int i)
    {
        Uav uav{.id = "uav-" + std::to_string(i + 1)};
        uav.spec.airspeed_mps = m_random.uniform(18, 28);
        uav.spec.altitude_m = 100 + 15.0 * static_cast<double>(m_random.below(6));
        if (oneIn(3))
            uav.spec.autopilot_s = 1;
        uav.heading_deg = m_random.uniform(0, 360);
        const Motion motion{.airspeed_mps = uav.spec.airspeed_mps,
                            .limit_radps = maxTurnRate_radps(uav.spec),
                            .wind_mps = m_scenario.wind_mps};
        const double clearance_m =
            m_scenario.geofence ? 2.1 * Geofence(m_scenario.area_m, motion).radius_m() : 0;
        uav.position_m = place_m(clearance_m);
        if (oneIn(2)) {
            uav.spec.endurance_s = m_random.uniform(700, 2400);
            uav.turnaround_s = m_random.uniform(30, 600);
        }
        m_scenario.uavs.push_back(uav);
    }
    Iceberg iceberg(const std::string& id)
    {
        Iceberg iceberg{.id = id};
        iceberg.position_m = place_m(0);
        iceberg.velocity_mps = point_m(m_scenario.geofence ? 0.1 : 0.4);
        iceberg.sigma0_m2 = m_random.uniform(1, 100);
        if (oneIn(3))
            iceberg.velocitySd_mps = m_random.uniform(0, 0.4);
        if (oneIn(4)) {
            iceberg.velocitySpread_mps = m_random.uniform(0.05, 0.3);
            iceberg.velocityTime_s = m_random.uniform(600, 36'000);
        }
        if (oneIn(6))
            iceberg.observed_s = m_random.uniform(0, 2000);
        if (oneIn(6))
            iceberg.q_m2ps = m_random.uniform(0.1, 10);
        if (oneIn(6))
            iceberg.appears_s = m_random.uniform(0, 0.6) * m_scenario.duration_s;
        if (oneIn(6))
            iceberg.uav = m_scenario.uavs[m_random.below(m_scenario.uavs.size())].id;
        if (oneIn(4)) { // its true motion differs from the known one
            const Point velocity_mps = iceberg.velocity_mps + point_m(0.4);
            iceberg.track.time_s = {0, 1e4};
            iceberg.track.position_m = {iceberg.position_m,
                                        iceberg.position_m + 1e4 * velocity_mps};
        }
        return iceberg;
    }
    /** Draws no-fly areas and a stand-off ring away from the starts. */
    void drawAreas()
    {
        const auto count = 1 + m_random.below(3);
        for (std::uint64_t i = 0; i < count; ++i) {
            const double away_m = m_random.uniform(150, 700);
            const Point middle_m = point_m(3000);
            if (!isClear(middle_m, away_m))
                continue;
            NoFlyArea area{.name = "area-" + std::to_string(i + 1)};
            const auto corners = static_cast<int>(3 + m_random.below(5));
            for (int k = 0; k < corners; ++k) {
                const double angle_rad = 2 * kPi * (k + m_random.uniform(-0.3, 0.3)) / corners;
                area.corners_m.push_back(middle_m +
                                         m_random.uniform(0.5, 1) * away_m *
                                             Point(std::cos(angle_rad), std::sin(angle_rad)));
            }
            if (oneIn(3))
                area.ceiling_m = m_random.uniform(90, 160);
            m_scenario.noFly.push_back(std::move(area));
        }
        if (m_scenario.asset && isClear(m_scenario.asset->position_m, 500))
            m_scenario.asset->standoff_m = 500;
    }
    [[nodiscard]] bool isClear(const Point& middle_m, double away_m) const
    {
        return std::ranges::all_of(m_scenario.uavs, [&](const Uav& uav) {
            const Motion motion{.airspeed_mps = uav.spec.airspeed_mps,
                                .limit_radps = maxTurnRate_radps(uav.spec),
                                .wind_mps = m_scenario.wind_mps};
            return (uav.position_m - middle_m).norm() >
                   1.1 * away_m + 2.1 * 2 * circleRadius_m(motion);
        });
    }
    /** Orders one UAV to return or to hold, and to resume. */
    void drawOrders()
    {
        const std::string uav = m_scenario.uavs[m_random.below(m_scenario.uavs.size())].id;
        const double time_s = std::round(m_random.uniform(0.1, 0.6) * m_scenario.duration_s);
        const double again_s = time_s + std::round(m_random.uniform(20, 500));
        m_changes.push_back(
            {.time_s = time_s,
             .commanded = UavCommand{
                 .uav = uav, .order = oneIn(2) ? FlightOrder::ReturnNow : FlightOrder::HoldHere}});
        m_changes.push_back(
            {.time_s = again_s, .commanded = UavCommand{.uav = uav, .order = FlightOrder::None}});
    }
    void drawChange()
    {
        Intervention& change = m_changes.emplace_back();
        change.time_s = std::round(m_random.uniform(0.1, 0.7) * m_scenario.duration_s);
        switch (m_random.below(4)) {
        case 0:
            change.wind_mps = point_m(6);
            break;
        case 1:
            change.appears = iceberg("new");
            change.appears->appears_s = 0;
            break;
        case 2:
            change.tau = m_random.uniform(0, 3);
            break;
        default:
            change.assigned = Assignment{.iceberg = "berg-1", .uav = m_scenario.uavs.back().id};
            m_scenario.icebergs.front().appears_s = 0;
        }
    }

    Random m_random;
    Scenario m_scenario;
    std::vector<Intervention> m_changes;
};

} // namespace berg::test
