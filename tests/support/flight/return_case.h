#pragma once

#include "core/base/angles.h"
#include "core/base/random.h"
#include "core/scenario/fence.h"
#include "core/vehicle/return_path.h"
#include "core/vehicle/uav_spec.h"

#include <algorithm>
#include <cmath>

namespace berg::test {

/**
 * A flight that must return home inside a fence: convex or with corners that point inwards, wind up
 * to 0.7 of the airspeed, icebergs anywhere. Its endurance is that of a path home from the start,
 * plus the reserve and up to five minutes; `isSafe` states whether there is such a path.
 * `WithAreas` adds no-fly areas of any shape and a stand-off ring, some above each other or across
 * the fence, some at other heights, and sometimes no fence.
 */
class ReturnCase
{
public:
    enum Kind
    {
        FenceOnly,
        WithAreas
    };

    explicit ReturnCase(std::uint64_t seed, Kind kind = FenceOnly) : m_random(seed, 22)
    {
        m_scenario.seed = static_cast<std::int64_t>(seed);
        m_scenario.noise = false;
        m_scenario.geofence = true;
        drawUav();
        drawFence();
        if (kind == WithAreas)
            drawAreas(seed);
        const std::shared_ptr<const Geofence> fence = this->fence();
        const auto reach_m = [&](const Point& place_m) { return fence->clearance_m(place_m); };
        Uav& uav = m_scenario.uavs.front();
        uav.position_m = inside_m();
        for (int i = 0; i < 50 && reach_m(uav.position_m) < 60; ++i)
            uav.position_m = inside_m();
        uav.home_m = inside_m();
        for (int i = 0; i < 50 && reach_m(*uav.home_m) < 60; ++i)
            uav.home_m = inside_m();
        for (int i = 0; i < 3; ++i)
            m_scenario.icebergs.push_back(
                {.id = std::to_string(i), .position_m = inside_m(), .velocity_mps = {0, 0}});
        setEndurance();
    }

    [[nodiscard]] const Scenario& scenario() const { return m_scenario; }
    [[nodiscard]] bool isSafe() const { return m_isSafe; }
    [[nodiscard]] std::shared_ptr<const Geofence> fence() const
    {
        const UavSpec& spec = m_scenario.uavs.front().spec;
        return fenceOf(m_scenario, spec.altitude_m,
                       {.airspeed_mps = spec.airspeed_mps,
                        .limit_radps = maxTurnRate_radps(spec),
                        .wind_mps = m_scenario.wind_mps});
    }

private:
    void drawUav()
    {
        Uav uav{.id = "u"};
        uav.spec.airspeed_mps = m_random.uniform(15, 30);
        uav.heading_deg = m_random.uniform(0, 360);
        uav.turnaround_s = 1e5;
        const double wind_mps = m_random.uniform(0, 0.7) * uav.spec.airspeed_mps;
        const double from_rad = m_random.uniform(-kPi, kPi);
        m_scenario.wind_mps = wind_mps * Point(std::cos(from_rad), std::sin(from_rad));
        m_scenario.uavs = {uav};
    }

    void drawFence()
    {
        std::vector<Point>& area_m = m_scenario.area_m;
        if (m_random.below(4) == 0) { // a corner pointing inwards, near or far
            const double tip_m = m_random.uniform(-500, 4500);
            area_m = {{-1500, -1000}, {6000, -1000}, {6000, 5500}, {3000, tip_m}, {-1500, 5500}};
            return;
        }
        const bool isConvex = m_random.below(2) == 0;
        const auto corners = static_cast<int>(5 + m_random.below(9));
        for (int i = 0; i < corners; ++i) {
            const double angle_rad = 2 * kPi * (i + m_random.uniform(-0.3, 0.3)) / corners;
            const double away_m = isConvex ? 3000 : m_random.uniform(900, 4000);
            area_m.push_back(Point(2000, 2000) +
                             away_m * Point(std::cos(angle_rad), std::sin(angle_rad)));
        }
    }

    void drawAreas(std::uint64_t seed)
    {
        Random random(seed, 23);
        m_scenario.geofence = random.below(5) != 0;
        const auto areas = static_cast<int>(1 + random.below(5));
        for (int k = 0; k < areas; ++k) {
            NoFlyArea& area = m_scenario.noFly.emplace_back();
            const double x_m = random.uniform(-500, 4500);
            const Point middle_m(x_m, random.uniform(-500, 4500));
            const auto corners = static_cast<int>(3 + random.below(6));
            for (int i = 0; i < corners; ++i) {
                const double angle_rad = 2 * kPi * (i + random.uniform(-0.3, 0.3)) / corners;
                area.corners_m.push_back(middle_m +
                                         random.uniform(50, 800) *
                                             Point(std::cos(angle_rad), std::sin(angle_rad)));
            }
            if (k > 0 && random.below(6) == 0)
                area.floor_m = 500;
        }
        if (random.below(3) != 0)
            return;
        const double x_m = random.uniform(0, 4000);
        m_scenario.asset = Asset{.position_m = {x_m, random.uniform(0, 4000)},
                                 .velocity_mps = {random.uniform(-1, 1), 0},
                                 .standoff_m = random.uniform(100, 900)};
    }

    Point inside_m()
    {
        const std::vector<NoFlyArea> areas = closedAreas(m_scenario);

        for (;;) {
            const double x_m = m_random.uniform(-2500, 6500);
            const Point place_m(x_m, m_random.uniform(-2500, 6500));
            if (insidePolygon(m_scenario.area_m, place_m) &&
                std::none_of(areas.begin(), areas.end(), [&](const NoFlyArea& area) {
                    return insidePolygon(area.corners_m, place_m);
                }))
                return place_m;
        }
    }

    void setEndurance()
    {
        Uav& uav = m_scenario.uavs.front();
        const std::shared_ptr<const Geofence> fence = this->fence();
        const ReturnSearch search(*fence, {.dt_s = m_scenario.dt_s}, *uav.home_m);
        const std::optional<ReturnPath> path = search.anyPath(
            {.position_m = uav.position_m, .psi_rad = psiFromHeading(uav.heading_deg)});
        m_isSafe = path.has_value();
        const double slack_s = m_random.uniform(0, m_random.below(2) == 0 ? 60 : 300);
        uav.spec.reservePercent = 0;
        uav.spec.endurance_s =
            (path ? static_cast<double>(path->commands()) * m_scenario.dt_s : 200) +
            kHomeReserve_s + slack_s + 1;
        m_scenario.duration_s = uav.spec.endurance_s + 200;
    }

    Random m_random;
    Scenario m_scenario;
    bool m_isSafe = false;
};

} // namespace berg::test
