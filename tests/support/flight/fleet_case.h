#pragma once

#include "core/base/angles.h"
#include "core/base/random.h"
#include "core/mission/mission.h"
#include "core/presets/presets.h"
#include "core/scenario/limits.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace berg::test {

/**
 * Two to six UAVs of one altitude layer over a field with hardly enough room, separated at the
 * start: wind, fences, slow autopilots, and endurances with a common home, drawn at random.
 */
class FleetCase
{
public:
    explicit FleetCase(std::int64_t seed) : m_random(static_cast<std::uint64_t>(seed), 23)
    {
        m_size_m = m_random.uniform(3000, 8000);
        m_scenario = randomScenario(seed, {.icebergs = 3 + static_cast<int>(m_random.below(18)),
                                           .size_m = {m_size_m, 0.8 * m_size_m}});
        m_scenario.duration_s = 1500;
        m_scenario.separation_m = m_random.uniform(50, 400);
        constexpr std::array kPolicies{PolicyKind::Visitation, PolicyKind::Latency,
                                       PolicyKind::Nearest, PolicyKind::Tour};
        m_scenario.planner.policy = kPolicies[m_random.below(kPolicies.size())];
        if (m_random.below(2) == 0) {
            const double from_rad = m_random.uniform(-kPi, kPi);
            m_scenario.wind_mps =
                m_random.uniform(0, 8) * Point(std::cos(from_rad), std::sin(from_rad));
        }
        if (m_random.below(3) == 0)
            drawFence();
        const Uav first = m_scenario.uavs.front();
        m_scenario.uavs.clear();
        const auto count = 2 + static_cast<int>(m_random.below(5));
        const bool isLimited = m_random.below(3) == 0;
        for (int i = 0; i < count; ++i)
            drawUav(first, isLimited);
    }

    [[nodiscard]] const Scenario& scenario() const { return m_scenario; }

private:
    void drawFence()
    {
        m_scenario.geofence = true;
        const double low_m = -2000;
        const double high_m = m_size_m + 2000;
        m_scenario.area_m = {{low_m, low_m}, {high_m, low_m}, {high_m, high_m}};
        if (m_random.below(2) == 0) // a corner pointing inwards
            m_scenario.area_m.push_back({m_size_m / 2, m_random.uniform(0.4, 1) * m_size_m});
        m_scenario.area_m.push_back({low_m, high_m});
    }

    static double circle_m(const Uav& uav, const Point& wind_mps)
    {
        const double faster = 1 + wind_mps.norm() / uav.spec.airspeed_mps;
        return 1.1 * faster * faster * turnRadius_m(uav.spec);
    }

    void drawUav(const Uav& first, bool isLimited)
    {
        Uav uav = first;
        uav.id = "uav-" + std::to_string(m_scenario.uavs.size() + 1);
        uav.heading_deg = m_random.uniform(0, 360);
        uav.spec.airspeed_mps = m_random.uniform(15, 30);
        constexpr std::array kBetween_s{0.0, 0.0, 0.5, 1.0, 2.0};
        uav.spec.autopilot_s = kBetween_s[m_random.below(kBetween_s.size())];
        uav.fov_m = Point::Constant(m_random.uniform(100, 600));
        if (isLimited) {
            uav.spec.endurance_s = m_random.uniform(400, 900);
            uav.turnaround_s = m_random.uniform(20, 200);
            uav.home_m = Point(m_size_m / 2, 0);
        }
        for (int i = 0; i < 300; ++i) {
            uav.position_m = {m_random.uniform(-1500, m_size_m + 1500),
                              m_random.uniform(-1500, m_size_m + 1500)};
            if (hasRoom(uav)) {
                m_scenario.uavs.push_back(uav);
                return;
            }
        }
    }

    /** Returns whether the UAV can circle inside the fence, clear of the others' circles. */
    [[nodiscard]] bool hasRoom(const Uav& uav) const
    {
        const double mine_m = 2 * circle_m(uav, m_scenario.wind_mps);
        const std::vector<Point>& area_m = m_scenario.area_m;
        if (!area_m.empty() && (!insidePolygon(area_m, uav.position_m) ||
                                distanceToEdges(area_m, uav.position_m) < mine_m + 10))
            return false;
        return std::ranges::all_of(m_scenario.uavs, [&](const Uav& other) {
            return (other.position_m - uav.position_m).norm() >=
                   mine_m + 2 * circle_m(other, m_scenario.wind_mps) + m_scenario.separation_m;
        });
    }

    Random m_random;
    double m_size_m = 0;
    Scenario m_scenario;
};

/** Results of a fleet's flight. */
struct FleetOutcome
{
    double least_m = 1e9;
    bool staysApart = true; ///< whether pairs stay apart once they have been separated
    bool isInside = true;
    double zeta_m2s = 0;
    int visits = 0;
    int landings = 0;
    int late = 0;  ///< UAVs reported to need part of the reserve
    int spent = 0; ///< landings after the whole endurance
    double longest_s =
        0; ///< that one of them had a target, or home to go to, and did not get there
    /** By landing: delay over the time predicted at the start of the return. */
    std::vector<double> waits_s;
};

inline FleetOutcome flownFleet(const Scenario& s)
{
    FleetOutcome flight;
    Mission mission(s, {.workLimit = 3'000, .record = false});
    std::vector<double> since_s(s.uavs.size());
    std::vector<int> visits(s.uavs.size());
    std::vector<double> tookOff_s(s.uavs.size());
    std::vector<double> due_s(s.uavs.size());
    std::vector<char> wereApart(s.uavs.size() * s.uavs.size());
    std::size_t counted = 0;
    const int count = static_cast<int>(s.uavs.size());
    while (!mission.simulation().finished()) {
        mission.advance(mission.simulation().time_s() + s.dt_s);
        const Simulation& world = mission.simulation();
        for (int a = 0; a < count; ++a) {
            const Autopilot& uav = world.fleet().autopilot(a);
            const Point& place_m = uav.pose().position_m;
            if (uav.isOnGround() || (!uav.isHomeward() && !uav.target()))
                since_s[toIndex(a)] = world.time_s();
            if (uav.isOnGround())
                continue;
            flight.isInside = flight.isInside && (!s.geofence || insidePolygon(s.area_m, place_m));
            for (int b = 0; b < a; ++b)
                if (const Autopilot& other = world.fleet().autopilot(b); !other.isOnGround()) {
                    const double apart_m = (other.pose().position_m - place_m).norm();
                    flight.least_m = std::min(flight.least_m, apart_m);
                    if (std::abs(other.altitude_m() - uav.altitude_m()) >= kLayerHeight_m)
                        continue;
                    char& wasApart = wereApart[toIndex(a) * s.uavs.size() + toIndex(b)];
                    flight.staysApart =
                        flight.staysApart && (wasApart == 0 || apart_m >= s.separation_m);
                    wasApart = wasApart != 0 || apart_m >= s.separation_m ? 1 : 0;
                }
        }
        for (; counted < mission.events().size(); ++counted) {
            const MissionEvent& event = mission.events()[counted];
            flight.landings += event.kind == EventKind::Landed ? 1 : 0;
            flight.late += event.kind == EventKind::LateHome ? 1 : 0;
            if (event.kind == EventKind::HomeBound) {
                const Autopilot& uav = world.fleet().autopilot(*event.uav);
                due_s[toIndex(*event.uav)] = event.time_s + uav.guard().enduranceLeft_s() -
                                             uav.homeMargin_s(world.observer()).value_or(0);
            }
            if (event.kind == EventKind::Landed)
                flight.waits_s.push_back(event.time_s - due_s[toIndex(*event.uav)]);
            if (event.kind == EventKind::TookOff)
                tookOff_s[toIndex(*event.uav)] = event.time_s;
            if (event.kind == EventKind::Landed)
                flight.spent += event.time_s - tookOff_s[toIndex(*event.uav)] >
                                        s.uavs[toIndex(*event.uav)].spec.endurance_s
                                    ? 1
                                    : 0;
            if (event.kind == EventKind::HomeBound)
                since_s[toIndex(*event.uav)] = event.time_s;
        }
        for (int a = 0; a < count; ++a) {
            if (std::exchange(visits[toIndex(a)], mission.visits(a)) != mission.visits(a))
                since_s[toIndex(a)] = world.time_s();
            flight.longest_s = std::max(flight.longest_s, world.time_s() - since_s[toIndex(a)]);
        }
    }
    flight.zeta_m2s = mission.metrics().zeta_m2s;
    flight.visits = mission.metrics().visits;
    return flight;
}

} // namespace berg::test
