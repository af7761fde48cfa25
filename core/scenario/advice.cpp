#include "core/scenario/advice.h"

#include "core/base/angles.h"
#include "core/plan/engine.h"
#include "core/plan/plans_clusters.h"
#include "core/scenario/checks.h"
#include "core/vehicle/geofence.h"
#include "core/vehicle/way_home.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace berg {

namespace {

/** Nearer than this two icebergs are one, entered or imported twice. */
constexpr double kSamePlace_m = 1;
/** Icebergs drift at some tenths of a metre a second; more is a slip of unit or sign. */
constexpr double kFastDrift_mps = 2;
/** Beyond this the back end exact may take a minute. */
constexpr std::size_t kQuickProof = 80;
constexpr auto kMostProven = static_cast<std::size_t>(kMostProvenByEngine);

Motion motionOf(const Scenario& scenario)
{
    const UavSpec& spec = scenario.uavs.front().spec;
    return {.airspeed_mps = spec.airspeed_mps,
            .limit_radps = maxTurnRate_radps(spec),
            .wind_mps = scenario.wind_mps};
}

DubinsState startOf(const Uav& uav)
{
    return {.position_m = uav.position_m, .psi_rad = psiFromHeading(uav.heading_deg)};
}

/** The findings about one scenario without errors. */
class Adviser
{
public:
    explicit Adviser(const Scenario& scenario) : m_s(scenario), m_uav(scenario.uavs.front())
    {
        const Point half_m = 0.5 * m_uav.fov_m;
        m_reach_m = m_s.reachRadius_m.value_or(half_m.norm());
        m_turnView_m = m_s.reachRadius_m.value_or(half_m.minCoeff());
    }

    [[nodiscard]] std::vector<Issue> findings()
    {
        adviseUnused();
        adviseUavs();
        adviseEndurance();
        adviseGeofence();
        adviseAsset();
        for (std::size_t i = 0; i < m_s.icebergs.size(); ++i)
            adviseIceberg(i);
        adviseSamePlace();
        adviseReach();
        advisePlanner();
        return std::move(m_issues);
    }

private:
    void warn(std::string field, std::string_view message)
    {
        m_issues.push_back({Severity::Warning, std::move(field), std::string(message)});
    }
    void hint(std::string field, std::string_view message)
    {
        m_issues.push_back({Severity::Hint, std::move(field), std::string(message)});
    }

    [[nodiscard]] bool isOutside(const Point& p_m) const
    {
        return !m_s.area_m.empty() && !insidePolygon(m_s.area_m, p_m);
    }
    [[nodiscard]] bool comesInTime(const Iceberg& iceberg) const
    {
        return iceberg.appears_s <= m_s.duration_s;
    }
    /** Of the estimate: straight on from where it appears. */
    [[nodiscard]] Point endOf(const Iceberg& iceberg) const
    {
        return iceberg.position_m + (iceberg.velocity_mps + m_s.current_mps) *
                                        std::max(0.0, m_s.duration_s - iceberg.appears_s);
    }
    /** Straight until it is reached or comes into view, without the turn at the start. */
    [[nodiscard]] double timeTo_s(const Point& from_m, const Point& to_m, double reach_m) const
    {
        const Point way_m = to_m - from_m;
        const double distance_m = way_m.norm();
        if (distance_m <= reach_m)
            return 0;
        return flightTime_s(way_m * ((distance_m - reach_m) / distance_m), m_uav.spec.airspeed_mps,
                            m_s.wind_mps);
    }

    void adviseUnused();
    void adviseUavs();
    void adviseEndurance();
    void adviseGeofence();
    void adviseAsset();
    void adviseIceberg(std::size_t i);
    void adviseTrack(const Iceberg& iceberg, const std::string& path);
    void adviseSamePlace();
    void adviseReach();
    void advisePlanner();

    const Scenario& m_s;
    const Uav& m_uav;        ///< the one that flies
    double m_reach_m = 0;    ///< farthest from the UAV that counts as reached
    double m_turnView_m = 0; ///< what it sees of its side when it passes
    std::vector<Issue> m_issues;
};

void Adviser::adviseUnused()
{
    const auto hasExtra = [](const auto& part) { return !part.extraJson.empty(); };
    if (hasExtra(m_s) || !m_s.plannerExtraJson.empty() || !m_s.originExtraJson.empty() ||
        !m_s.observerExtraJson.empty() || (m_s.asset && hasExtra(*m_s.asset)) ||
        std::any_of(m_s.uavs.begin(), m_s.uavs.end(), hasExtra) ||
        std::any_of(m_s.icebergs.begin(), m_s.icebergs.end(), [](const Iceberg& iceberg) {
            return !iceberg.extraJson.empty() || !iceberg.trackExtraJson.empty();
        }))
        hint({}, advised::kUnknownMembers);
    if (!m_s.area_m.empty() && !m_s.geofence)
        hint("area_m", advised::kAreaNoFence);
    if (m_s.observer.model == ObserverModel::Simple)
        for (std::size_t i = 0; i < m_s.icebergs.size(); ++i)
            if (m_s.icebergs[i].velocitySd_mps > 0)
                hint(entryPath("icebergs", i) + ".velocity_sd_mps", advised::kVelocitySdUnused);
    if (m_s.uavs.size() > 1)
        hint("uavs[1]", advised::kFirstUavOnly);
}

void Adviser::adviseUavs()
{
    for (std::size_t i = 0; i < m_s.uavs.size(); ++i)
        if (isOutside(m_s.uavs[i].position_m))
            hint(entryPath("uavs", i) + ".position_m", advised::kUavOutside);
    if (turnRadius_m(m_uav.spec) <= m_turnView_m)
        return;
    if (m_s.reachRadius_m)
        hint("planner.reach_radius_m", advised::kReachInsideTurn);
    else
        hint("uavs[0].fov_m", advised::kWideTurn);
}

void Adviser::adviseEndurance()
{
    const double endurance_s = m_uav.spec.endurance_s;
    if (endurance_s == 0 && m_uav.home_m)
        hint("uavs[0].home_m", advised::kHomeUnused);
    if (endurance_s == 0)
        return;
    const Point& start_m = m_uav.position_m;
    const Point home_m = m_uav.home_m.value_or(start_m);
    const Motion motion = motionOf(m_s);
    const std::optional<Way> home = wayTo(startOf(m_uav), {.place_m = home_m}, motion, m_s.dt_s);
    if (!home || home->time_s + kHomeReserve_s > endurance_s)
        warn("uavs[0].endurance_s", advised::kNoWayHome);
    if (m_s.icebergs.empty())
        return;
    const bool returns =
        std::any_of(m_s.icebergs.begin(), m_s.icebergs.end(), [&](const Iceberg& iceberg) {
            return timeTo_s(start_m, iceberg.position_m, m_reach_m) +
                       timeTo_s(iceberg.position_m, home_m, m_reach_m) <=
                   endurance_s;
        });
    if (!returns)
        warn("uavs[0].endurance_s", advised::kNoRoundTrip);
}

void Adviser::adviseGeofence()
{
    if (!m_s.geofence)
        return;
    const Geofence fence(m_s.area_m, motionOf(m_s));
    if (fence.room_m(startOf(m_uav)) < 0)
        warn("uavs[0].position_m", advised::kStartNearFence);
    const Point home_m = m_uav.home_m.value_or(m_uav.position_m);
    if (m_uav.spec.endurance_s > 0 && distanceToEdges(m_s.area_m, home_m) < 2 * fence.radius_m())
        warn("uavs[0].home_m", advised::kHomeNearFence);
    if (m_s.planner.policy == PolicyKind::Coverage)
        hint("geofence", advised::kFenceUnplanned);
    if (turnRadius_m(m_uav.spec) <= m_turnView_m)
        return;
    for (std::size_t i = 0; i < m_s.icebergs.size(); ++i)
        if (!isOutside(m_s.icebergs[i].position_m) && fence.isShutOff(m_s.icebergs[i].position_m))
            warn(entryPath("icebergs", i) + ".position_m", advised::kShutOff);
}

void Adviser::adviseAsset()
{
    if (m_s.asset && std::any_of(m_s.icebergs.begin(), m_s.icebergs.end(), [&](const Iceberg& b) {
            return b.appears_s == 0 && (b.position_m - m_s.asset->position_m).norm() < b.radius_m;
        }))
        warn("asset.position_m", advised::kAssetInIce);
}

void Adviser::adviseIceberg(std::size_t i)
{
    const Iceberg& iceberg = m_s.icebergs[i];
    const std::string path = entryPath("icebergs", i);
    if (isOutside(iceberg.position_m))
        warn(path + ".position_m", advised::kOutsideArea);
    else if (comesInTime(iceberg) &&
             isOutside(iceberg.track.empty() ? endOf(iceberg) : iceberg.track.at(m_s.duration_s)))
        hint(path + ".velocity_mps", advised::kLeavesArea);
    if (iceberg.velocity_mps.norm() > kFastDrift_mps)
        hint(path + ".velocity_mps", advised::kFast);
    if (!iceberg.track.empty())
        adviseTrack(iceberg, path);
}

void Adviser::adviseTrack(const Iceberg& iceberg, const std::string& path)
{
    if (iceberg.track.time_s.back() < m_s.duration_s)
        hint(path + ".track", advised::kTrackShort);
    const Point gap_m = iceberg.track.at(iceberg.appears_s) - iceberg.position_m;
    if (gap_m.norm() > m_reach_m)
        warn(path + ".track", advised::kTrackFar);
}

void Adviser::adviseSamePlace()
{
    const std::vector<Iceberg>& all = m_s.icebergs;
    std::vector<std::size_t> byEast(all.size());
    std::iota(byEast.begin(), byEast.end(), std::size_t{0});
    std::sort(byEast.begin(), byEast.end(), [&](std::size_t a, std::size_t b) {
        return all[a].position_m.x() < all[b].position_m.x();
    });
    std::vector<bool> isSecond(all.size(), false);
    for (std::size_t i = 0; i < byEast.size(); ++i)
        for (std::size_t k = i + 1; k < byEast.size(); ++k) {
            const Point gap_m = all[byEast[k]].position_m - all[byEast[i]].position_m;
            if (gap_m.x() > kSamePlace_m)
                break;
            if (gap_m.norm() <= kSamePlace_m)
                isSecond[std::max(byEast[i], byEast[k])] = true;
        }
    for (std::size_t i = 0; i < all.size(); ++i)
        if (isSecond[i])
            warn(entryPath("icebergs", i) + ".position_m", advised::kSamePlace);
}

/** Of an iceberg that the UAV catches up with the end is the easiest instant to be there. */
void Adviser::adviseReach()
{
    std::vector<std::size_t> far;
    std::size_t coming = 0;
    for (std::size_t i = 0; i < m_s.icebergs.size(); ++i) {
        const Iceberg& iceberg = m_s.icebergs[i];
        if (!comesInTime(iceberg))
            continue;
        ++coming;
        const auto time_s = [&](const Point& place_m) {
            return timeTo_s(m_uav.position_m, place_m, m_reach_m);
        };
        if (std::min(time_s(iceberg.position_m), time_s(endOf(iceberg))) > m_s.duration_s)
            far.push_back(i);
    }
    if (coming > 0 && far.size() == coming) {
        warn("duration_s", advised::kTooShort);
        return;
    }
    for (const std::size_t i : far)
        warn(entryPath("icebergs", i) + ".position_m", advised::kOutOfReach);
}

void Adviser::advisePlanner()
{
    const std::size_t count = m_s.icebergs.size();
    const PlannerSettings& planner = m_s.planner;
    if (m_s.clusters && !plansClusters(planner.policy))
        hint("planner.clusters", advised::kClustersIgnored);
    if (planner.policy != PolicyKind::Visitation || count == 0)
        return;
    if (std::all_of(m_s.icebergs.begin(), m_s.icebergs.end(),
                    [](const Iceberg& iceberg) { return initialSigma_m2(iceberg) == 0; }))
        hint("icebergs", advised::kNoSigma);
    if (planner.tau == 0) // sorting proves itself
        return;
    const bool exact = planner.backend == Backend::Exact;
    if (count > kMostProven && exact)
        warn("planner.backend", advised::kSolverUnable);
    else if (count > kMostProven)
        hint("icebergs", advised::kBeyondProof);
    else if (count > kQuickProof && exact)
        hint("planner.backend", advised::kLongProof);
}

} // namespace

std::vector<Issue> advice(const Scenario& scenario)
{
    require(!scenario.uavs.empty(), "advice: the scenario has errors");
    return Adviser(scenario).findings();
}

} // namespace berg
