#include "core/io/flyable_path.h"

#include "core/base/enclosing_circle.h"
#include "core/sim/clusters.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

constexpr double kSample_s = 1;
/** A flight that takes so many times as long as its straight legs does not get there. */
constexpr double kPatience = 4;
constexpr double kLeastPatience_s = 3600;

/** Time enough to fly the order, seconds. */
double longestFlight_s(const Scenario& scene, const UavOrder& order)
{
    PlanAnswer plan;
    plan.order = order.icebergs;
    plan.clusters = order.clusters;
    const std::vector<Visit> visits = plannedVisits(scene, plan);
    const double straight_s = visits.empty() ? 0 : visits.back().time_s;
    return std::min(604800.0, kLeastPatience_s + kPatience * straight_s);
}

Scenario withTime(Scenario scene, double duration_s)
{
    scene.duration_s = duration_s;
    return scene;
}

class OrderFlight
{
public:
    OrderFlight(const Scenario& scene, const UavOrder& order)
        : m_order(order)
        , m_simulation(withTime(scene, longestFlight_s(scene, order)))
        , m_sampleSteps(std::max<std::int64_t>(1, std::llround(kSample_s / scene.dt_s)))
    {
    }

    FlyablePath fly()
    {
        sample();
        while (!m_simulation.finished() && goOn()) {
            m_simulation.advanceStep();
            if (m_simulation.state().step % m_sampleSteps == 0)
                sample();
        }
        if (m_path.track.back().time_s < m_simulation.time_s())
            sample();
        return std::move(m_path);
    }

private:
    /** The only one of the scene. */
    [[nodiscard]] const UavState& uav() const { return m_simulation.uav(0); }

    /** Whether there is something left to fly to; tells the autopilot what. */
    bool goOn()
    {
        if (uav().mode == FlightMode::Ground)
            return landed();
        const PlanReason reason = m_simulation.planReason(0);
        if (reason == PlanReason::None || uav().homeward())
            return true;
        if (isDone(reason))
            finishTarget();
        passOverVisible();
        if (m_next < m_order.icebergs.size()) {
            flyToNext();
            return true;
        }
        m_simulation.setTarget(0, -1);
        return uav().homeward();
    }

    bool landed()
    {
        m_path.visits.push_back(
            {.time_s = m_simulation.time_s(), .position_m = uav().pose.position_m});
        return false;
    }

    [[nodiscard]] bool isDone(PlanReason reason) const
    {
        return uav().target >= 0 && reason == PlanReason::TargetReached;
    }

    void finishTarget()
    {
        const int target = m_order.icebergs.at(m_next);
        const std::span<const int> members = clusterWith(m_order.clusters, target);
        const std::vector<int> together =
            members.empty() ? std::vector{target} : std::vector(members.begin(), members.end());
        visit(together);
        while (m_next < m_order.icebergs.size() &&
               std::ranges::find(together, m_order.icebergs[m_next]) != together.end())
            ++m_next;
    }

    /** Those next in the order that are in view, or too far to be home in time after. */
    void passOverVisible()
    {
        for (; m_next < m_order.icebergs.size(); ++m_next) {
            const int iceberg = m_order.icebergs[m_next];
            if (m_simulation.available(0, iceberg))
                return;
            if (m_simulation.track(iceberg).inView)
                visit({iceberg});
        }
    }

    void flyToNext()
    {
        const int target = m_order.icebergs[m_next];
        std::vector<int> members;
        for (const int member : clusterWith(m_order.clusters, target))
            if (m_simulation.available(0, member))
                members.push_back(member);
        if (members.size() < 2)
            members.clear();
        m_simulation.setTarget(0, target, std::nullopt, members);
    }

    void visit(const std::vector<int>& icebergs)
    {
        std::vector<Point> places_m;
        for (const int iceberg : icebergs)
            places_m.push_back(m_simulation.estimate_m(iceberg));
        const Circle circle = enclosingCircle(places_m);
        m_path.visits.push_back({.iceberg = icebergs.front(),
                                 .time_s = m_simulation.time_s(),
                                 .position_m = circle.centre_m,
                                 .members = icebergs.size() > 1 ? icebergs : std::vector<int>{},
                                 .spread_m = circle.radius_m});
    }

    void sample()
    {
        m_path.track.push_back({.time_s = m_simulation.time_s(),
                                .state = uav().pose,
                                .u_radps = uav().u_radps,
                                .crossTrack_m = uav().crossTrack_m});
    }

    const UavOrder& m_order;
    Simulation m_simulation;
    std::int64_t m_sampleSteps;
    std::size_t m_next = 0;
    FlyablePath m_path;
};

void flyHome(FlyablePath& path, const Scenario& scene)
{
    const Uav& uav = scene.uavs.front();
    const TrackPoint& last = path.track.back();
    const Point home_m = uav.home_m.value_or(uav.position_m);
    const Point way_m = home_m - last.state.position_m;
    const double time_s = last.time_s + flightTime_s(way_m, uav.spec.airspeed_mps, scene.wind_mps);
    path.visits.push_back({.time_s = time_s, .position_m = home_m});
    if (time_s > last.time_s)
        path.track.push_back(
            {.time_s = time_s,
             .state = {.position_m = home_m, .psi_rad = std::atan2(way_m.y(), way_m.x())}});
}

} // namespace

FlyablePath flyOrder(const Scenario& scene, const UavOrder& order, bool home)
{
    FlyablePath path = OrderFlight(scene, order).fly();
    const bool isHome = !path.visits.empty() && path.visits.back().iceberg < 0;
    if (home && !isHome)
        flyHome(path, scene);
    return path;
}

} // namespace berg
