#include "core/mission/flyable_path.h"

#include "core/coverage/aimed_path.h"
#include "core/geometry/enclosing_circle.h"
#include "core/scenario/fence.h"
#include "core/sim/clusters.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

constexpr double kSample_s = 1;
/** A flight that takes this many times the time of its straight legs is abandoned. */
constexpr double kPatience = 4;
constexpr double kLeastPatience_s = 3600;

/** Returns the time allowed for the order, s. */
double longestFlight_s(const Scenario& scene, const UavPlan& plan)
{
    const std::vector<Visit> visits = plannedVisits(scene, plan.order, plan.clusters);
    const double straight_s = visits.empty() ? 0 : visits.back().time_s;
    return std::min(604800.0, kLeastPatience_s + kPatience * straight_s);
}

/**
 * Freezes the stand-off ring as a no-fly area, since the ring of a moving asset depends on the
 * duration.
 */
Scenario withTime(Scenario scene, double duration_s)
{
    scene.noFly = closedAreas(scene);
    if (scene.asset)
        scene.asset->standoff_m = 0;
    scene.duration_s = duration_s;
    return scene;
}

class OrderFlight
{
public:
    OrderFlight(const Scenario& scene, const UavPlan& plan)
        : m_plan(plan)
        , m_rest(plan.order)
        , m_simulation(withTime(scene, longestFlight_s(scene, plan)))
        , m_sampleSteps(std::max<std::int64_t>(1, std::llround(kSample_s / scene.dt_s)))
        , m_paths(aimedPaths(plan.legs, m_simulation.uav(0).pose, 0, m_simulation.motion(0)))
    {
    }

    FlyablePath fly()
    {
        sample();
        while (!m_simulation.finished() && updateTarget()) {
            m_simulation.advanceStep();
            if (m_simulation.step() % m_sampleSteps == 0)
                sample();
        }
        if (m_path.track.back().time_s < m_simulation.time_s())
            sample();
        return std::move(m_path);
    }

private:
    /** State of the scene's only UAV. */
    [[nodiscard]] UavState uav() const { return m_simulation.uav(0); }

    /** Sends the autopilot to its next target. Returns false if the flight has ended. */
    bool updateTarget()
    {
        if (uav().mode == FlightMode::Ground) {
            m_path.visits.push_back(
                {.time_s = m_simulation.time_s(), .position_m = uav().pose.position_m});
            return false;
        }
        const PlanReason reason = m_simulation.planReason(0);
        const bool hasLegs = m_leg < m_paths.size();
        const bool isLegOver = hasLegs && m_simulation.time_s() >= pathEnd_s();
        if ((reason == PlanReason::None && !isLegOver) || !uav().isPlanned())
            return true;
        if (hasLegs)
            passOverAllVisible();
        else if (uav().target && reason == PlanReason::TargetReached)
            finishTarget();
        passOverVisible();
        if (isLegOver)
            ++m_leg;
        if (!m_rest.empty()) {
            flyOn(isLegOver);
            return true;
        }
        m_simulation.setTarget(0, std::nullopt);
        return !uav().isPlanned();
    }

    [[nodiscard]] double pathEnd_s() const { return m_paths[m_leg].points.back().time_s; }

    /** Continues the present aimed leg, or flies straight to the next iceberg. */
    void flyOn(bool isNewLeg)
    {
        if (m_leg >= m_paths.size()) {
            flyToNext();
            return;
        }
        const bool continues = !isNewLeg && uav().aim;
        AimedLeg leg = continues ? *uav().aim : m_plan.legs[m_leg];
        leg.sighting_s = pathEnd_s(); // sightings before the end do not end the leg
        leg.end_s.reset();
        m_simulation.setTarget(0, m_rest.front(), leg);
    }

    void finishTarget()
    {
        const IcebergIndex target = m_rest.front();
        const std::span<const IcebergIndex> members = clusterWith(m_plan.clusters, target);
        IcebergList together =
            members.empty() ? std::vector{target} : std::vector(members.begin(), members.end());
        std::erase_if(together,
                      [this](IcebergIndex member) { // skips members seen on the path to the others
                          return std::ranges::find(m_rest, member) == m_rest.end();
                      });
        visit(together);
        while (!m_rest.empty() && std::ranges::find(together, m_rest.front()) != together.end())
            m_rest.erase(m_rest.begin());
    }

    /** Removes the next icebergs of the order that are in view or too far for a timely return. */
    void passOverVisible()
    {
        while (!m_rest.empty() && !m_simulation.available(0, m_rest.front())) {
            if (m_simulation.track(m_rest.front()).inView)
                visit({m_rest.front()});
            m_rest.erase(m_rest.begin());
        }
    }

    /** Removes every iceberg in view: aimed legs see icebergs in any order. */
    void passOverAllVisible()
    {
        std::erase_if(m_rest, [this](IcebergIndex iceberg) {
            const bool isSeen = m_simulation.track(iceberg).inView;
            if (isSeen)
                visit({iceberg});
            return isSeen;
        });
    }

    void flyToNext()
    {
        const IcebergIndex target = m_rest.front();
        IcebergList members;
        for (const IcebergIndex member : clusterWith(m_plan.clusters, target))
            if (m_simulation.available(0, member))
                members.push_back(member);
        if (members.size() < 2)
            members.clear();
        m_simulation.setTarget(0, target, std::nullopt, members);
    }

    void visit(const IcebergList& icebergs)
    {
        const Circle circle = circleRound(
            icebergs, [this](IcebergIndex i) { return m_simulation.observer().estimate_m(i); });
        m_path.visits.push_back({.iceberg = icebergs.front(),
                                 .time_s = m_simulation.time_s(),
                                 .position_m = circle.centre_m,
                                 .members = icebergs.size() > 1 ? icebergs : IcebergList{},
                                 .spread_m = circle.radius_m});
    }

    void sample()
    {
        m_path.track.push_back({.time_s = m_simulation.time_s(),
                                .state = uav().pose,
                                .u_radps = uav().u_radps,
                                .crossTrack_m = uav().crossTrack_m});
    }

    const UavPlan& m_plan;
    IcebergList m_rest; ///< icebergs still to be visited
    Simulation m_simulation;
    std::int64_t m_sampleSteps;
    std::vector<AimedPath> m_paths; ///< of the aimed legs
    std::size_t m_leg = 0;          ///< index of the present leg in `m_paths`
    FlyablePath m_path;
};

void flyHome(FlyablePath& path, const Scenario& scene)
{
    const Uav& uav = scene.uavs.front();
    const TrackPoint& last = path.track.back();
    const Point home_m = uav.home_m.value_or(uav.position_m);
    const Point path_m = home_m - last.state.position_m;
    const double time_s = last.time_s + flightTime_s(path_m, uav.spec.airspeed_mps, Point::Zero(),
                                                     windFromStart(scene), last.time_s);
    path.visits.push_back({.time_s = time_s, .position_m = home_m});
    if (time_s > last.time_s)
        path.track.push_back(
            {.time_s = time_s,
             .state = {.position_m = home_m, .psi_rad = std::atan2(path_m.y(), path_m.x())}});
}

} // namespace

FlyablePath flyOrder(const Scenario& scene, const UavPlan& plan, bool home)
{
    FlyablePath path = OrderFlight(scene, plan).fly();
    const bool isHome = !path.visits.empty() && !path.visits.back().iceberg;
    if (home && !isHome)
        flyHome(path, scene);
    return path;
}

} // namespace berg
