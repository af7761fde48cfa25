#include "core/checks/scenario_warnings.h"

#include "core/base/angles.h"
#include "core/checks/drift_advice.h"
#include "core/checks/findings.h"
#include "core/checks/forecast_findings.h"
#include "core/checks/weather.h"
#include "core/permit/airspace.h"
#include "core/plan/solve/engine.h"
#include "core/scenario/fence.h"
#include "core/scenario/flight_weather.h"
#include "core/scenario/recovery.h"
#include "core/scenario/text_checks.h"
#include "core/vehicle/safety_guard.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace berg {

namespace {

/**
 * 99 of 100 returns to one pad wait less than this time for each other UAV of the layer, measured
 * with two to six UAVs over fields with hardly room for them (`tests/bench/RESULTS.md`).
 */
constexpr double kWaitForOne_s = 55;

/** Icebergs closer than this are one iceberg, entered or imported twice. */
constexpr double kSamePlace_m = 1;
/** Icebergs drift at some tenths of a metre per second; more suggests a wrong unit or sign. */
constexpr double kFastDrift_mps = 2;
/** With more icebergs the exact back end may take a minute. */
constexpr std::size_t kQuickProof = 80;
constexpr auto kMostProven = static_cast<std::size_t>(kMostProvenByEngine);

Motion motionOf(const Scenario& scenario, const Uav& uav)
{
    return {.airspeed_mps = uav.spec.airspeed_mps,
            .limit_radps = maxTurnRate_radps(uav.spec),
            .wind_mps = scenario.wind_mps};
}

DubinsState startOf(const Uav& uav)
{
    return {.position_m = uav.position_m, .psi_rad = psiFromHeading(uav.heading_deg)};
}

/** One UAV with the distances at which it reaches or sees an iceberg. */
struct Flyer
{
    const Uav& uav;
    std::string path;    ///< path in the file
    double reach_m = 0;  ///< largest distance that counts as reached
    double seen_m = 0;   ///< distance at which an iceberg is in view at any heading
    double surely_m = 0; ///< distance at which it is reached at any heading
    bool isWide = false; ///< true if its turn radius exceeds `surely_m`
    std::shared_ptr<const Geofence> fence; ///< null if it may fly anywhere
};

Flyer flyerOf(const Scenario& scenario, std::size_t i)
{
    const Uav& uav = scenario.uavs[i];
    const SensorSpec sensor{.fov_m = uav.fov_m, .shape = scenario.fovShape};
    const double surely_m = scenario.reachRadius_m.value_or(surelySeen_m(sensor));
    return {.uav = uav,
            .path = entryPath("uavs", i),
            .reach_m = scenario.reachRadius_m.value_or(FieldOfView::reach_m(sensor)),
            .seen_m = surelySeen_m(sensor),
            .surely_m = surely_m,
            .isWide = turnRadius_m(uav.spec) > surely_m};
}

/** Collects the findings about one scenario without errors. */
class ScenarioWarnings
{
public:
    explicit ScenarioWarnings(const Scenario& scenario) : m_s(scenario)
    {
        for (std::size_t i = 0; i < m_s.uavs.size(); ++i) {
            Flyer flyer = flyerOf(m_s, i);
            const UavSpec& spec = flyer.uav.spec;
            // A fence with many corners takes long to build, so UAVs of one kind share it.
            const auto alike = std::find_if(m_flyers.begin(), m_flyers.end(), [&](const Flyer& f) {
                return f.uav.spec.airspeed_mps == spec.airspeed_mps &&
                       f.uav.spec.maxBank_deg == spec.maxBank_deg &&
                       f.uav.spec.altitude_m == spec.altitude_m;
            });
            flyer.fence = alike == m_flyers.end()
                              ? fenceOf(m_s, spec.altitude_m, motionOf(m_s, flyer.uav))
                              : alike->fence;
            m_flyers.push_back(std::move(flyer));
        }
    }

    [[nodiscard]] std::vector<Issue> findings()
    {
        adviseUnused();
        adviseUavs();
        adviseLayers();
        for (const Flyer& flyer : m_flyers)
            adviseEndurance(flyer);
        adviseRecovery();
        for (Issue& issue : airspaceIssues(m_s))
            m_found.warn(std::move(issue.field), issue.reason.id,
                         std::move(issue.reason.arguments));
        adviseIceChart(m_s, m_found);
        adviseWeather(m_s, m_found);
        adviseForecast(m_s, m_found);
        adviseFences();
        adviseAsset();
        for (std::size_t i = 0; i < m_s.icebergs.size(); ++i)
            adviseIceberg(i);
        adviseDrift(m_s, m_found);
        adviseSamePlace();
        adviseReach();
        advisePlanner();
        return m_found.take();
    }

private:
    [[nodiscard]] bool isOutside(const Point& p_m) const
    {
        return !m_s.area_m.empty() && !insidePolygon(m_s.area_m, p_m);
    }
    [[nodiscard]] bool comesInTime(const Iceberg& iceberg) const
    {
        return iceberg.appears_s <= m_s.duration_s;
    }
    /** Returns the estimate, which drifts from time 0 on, even before the iceberg appears. */
    [[nodiscard]] Point estimateAt(const Iceberg& iceberg, double time_s) const
    {
        return iceberg.position_m + (iceberg.velocity_mps + meanDrift_mps(m_s, iceberg)) * time_s;
    }
    [[nodiscard]] Point endOf(const Iceberg& iceberg) const
    {
        return estimateAt(iceberg, std::max(iceberg.appears_s, m_s.duration_s));
    }
    /**
     * Returns the time of a straight flight until the place is reached or in view, without the
     * first turn.
     */
    [[nodiscard]] double timeOf_s(const Flyer& flyer, const Point& from_m, const Point& to_m) const
    {
        const Point path_m = to_m - from_m;
        const double distance_m = path_m.norm();
        if (distance_m <= flyer.reach_m)
            return 0;
        return flightTime_s(path_m * ((distance_m - flyer.reach_m) / distance_m),
                            flyer.uav.spec.airspeed_mps, m_s.wind_mps);
    }
    /** Returns true if the test holds for every UAV that may visit the iceberg. */
    template <class Test>
    [[nodiscard]] bool allVisitors(const Iceberg& iceberg, const Test& test) const
    {
        return std::all_of(m_flyers.begin(), m_flyers.end(), [&](const Flyer& flyer) {
            return !mayVisit(flyer, iceberg) || test(flyer);
        });
    }
    [[nodiscard]] static bool mayVisit(const Flyer& flyer, const Iceberg& iceberg)
    {
        return iceberg.uav.empty() || iceberg.uav == flyer.uav.id;
    }

    void adviseUnused();
    void adviseUavs();
    void adviseLayers();
    void adviseRecovery();
    void adviseEndurance(const Flyer& flyer);
    void adviseFences();
    void adviseReturn(const Flyer& flyer, const SortieSpec& sortie);
    void adviseShutOff();
    void adviseAsset();
    void adviseIceberg(std::size_t i);
    void adviseTrack(const Iceberg& iceberg, const std::string& path);
    void adviseSamePlace();
    void adviseReach();
    void advisePlanner();

    const Scenario& m_s;
    std::vector<Flyer> m_flyers;
    Findings m_found{Findings::Kind::All};
};

void ScenarioWarnings::adviseUnused()
{
    std::optional<Issue> unknown; // first one found
    const auto inspect = [&unknown](const std::string& extraJson) {
        if (!unknown)
            unknown = unknownMembers({}, extraJson);
    };
    const auto inspectAll = [&inspect](const auto& parts) {
        for (const auto& part : parts)
            inspect(part.extraJson);
    };
    for (const std::string* extraJson :
         {&m_s.extraJson, &m_s.plannerExtraJson, &m_s.originExtraJson, &m_s.observerExtraJson,
          &m_s.weather.extraJson})
        inspect(*extraJson);
    if (m_s.asset)
        inspect(m_s.asset->extraJson);
    if (m_s.operation)
        inspect(m_s.operation->extraJson);
    if (m_s.groundStation)
        inspect(m_s.groundStation->extraJson);
    if (m_s.iceChart) {
        inspect(m_s.iceChart->extraJson);
        inspectAll(m_s.iceChart->areas);
    }
    inspectAll(m_s.airspace);
    inspectAll(m_s.noFly);
    inspectAll(m_s.uavs);
    inspectAll(m_s.icebergs);
    for (const Iceberg& iceberg : m_s.icebergs)
        inspect(iceberg.trackExtraJson);
    if (unknown)
        m_found.hint({}, IssueId::UnknownMembers, unknown->reason.arguments);
    if (!m_s.area_m.empty() && !m_s.geofence)
        m_found.hint("area_m", IssueId::AreaNoFence);
    if (m_s.observer.model == ObserverModel::Simple)
        for (std::size_t i = 0; i < m_s.icebergs.size(); ++i)
            if (m_s.icebergs[i].velocitySd_mps > 0 || m_s.icebergs[i].velocityTime_s > 0)
                m_found.hint(entryPath("icebergs", i) + ".velocity_sd_mps",
                             IssueId::VelocitySdUnused);
}

void ScenarioWarnings::adviseUavs()
{
    for (const Flyer& flyer : m_flyers) {
        if (isOutside(flyer.uav.position_m))
            m_found.hint(flyer.path + ".position_m", IssueId::UavOutside);
        if (flyer.isWide && !m_s.reachRadius_m)
            m_found.hint(flyer.path + ".fov_m", IssueId::WideTurn);
        if (flyer.uav.spec.autopilot_s * flyer.uav.spec.airspeed_mps > LosGains().lookahead_m)
            m_found.warn(flyer.path + ".autopilot_s", IssueId::SlowAutopilot);
    }
    if (m_s.reachRadius_m && std::any_of(m_flyers.begin(), m_flyers.end(),
                                         [](const Flyer& flyer) { return flyer.isWide; }))
        m_found.hint("planner.reach_radius_m", IssueId::ReachInsideTurn);
    if (std::any_of(m_flyers.begin(), m_flyers.end(),
                    [&](const Flyer& flyer) { return m_s.reachRadius_m > flyer.seen_m; }))
        m_found.warn("planner.reach_radius_m", IssueId::ReachBeyondView);
}

/** Reports each UAV that starts near an earlier one; at the same place this is a warning. */
void ScenarioWarnings::adviseLayers()
{
    for (auto flyer = m_flyers.begin(); flyer != m_flyers.end(); ++flyer) {
        double nearest_m = m_s.separation_m;
        for (auto before = m_flyers.begin(); before != flyer; ++before)
            if (std::abs(before->uav.spec.altitude_m - flyer->uav.spec.altitude_m) < kLayerHeight_m)
                nearest_m =
                    std::min(nearest_m, (before->uav.position_m - flyer->uav.position_m).norm());
        if (nearest_m >= m_s.separation_m)
            continue;
        if (nearest_m <= kLandingRadius_m)
            m_found.warn(flyer->path + ".altitude_m", IssueId::SameLayer,
                         {Amount{kLayerHeight_m, Quantity::Height}});
        else
            m_found.hint(flyer->path + ".altitude_m", IssueId::SameLayer,
                         {Amount{kLayerHeight_m, Quantity::Height}});
    }
}

void ScenarioWarnings::adviseRecovery()
{
    const std::vector<double> withheld_s = withheldAtStart_s(m_s);
    for (std::size_t i = 0; i < m_flyers.size(); ++i)
        if (withheld_s[i] > 0)
            m_found.warn(m_flyers[i].path + ".endurance_s", IssueId::RecoverySlot,
                         {Amount{std::round(withheld_s[i]), Quantity::Seconds}});
}

void ScenarioWarnings::adviseEndurance(const Flyer& flyer)
{
    const Uav& uav = flyer.uav;
    const std::optional<SortieSpec> sortie = sortieOf(uav);
    if (!sortie && uav.home_m)
        m_found.hint(flyer.path + ".home_m", IssueId::HomeUnused);
    if (!sortie)
        return;
    const std::optional<Path> home =
        pathTo(startOf(uav), {.place_m = sortie->home_m}, motionOf(m_s, uav), m_s.dt_s);
    if (!flyer.fence && (!home || home->time_s + kHomeReserve_s > sortie->endurance_s))
        m_found.warn(flyer.path + ".endurance_s", IssueId::NoPathHome);
    const auto sharesLayer = [&](const Flyer& other) {
        return &other != &flyer && m_s.separation_m > 0 &&
               std::abs(other.uav.spec.altitude_m - uav.spec.altitude_m) < kLayerHeight_m;
    };
    const double wait_s =
        kWaitForOne_s * static_cast<double>(std::ranges::count_if(m_flyers, sharesLayer));
    if (reserve_s(uav.spec) < wait_s)
        m_found.warn(flyer.path + ".endurance_s", IssueId::CrowdedReturn,
                     {Amount{wait_s, Quantity::Seconds}});
    bool visits = false;
    bool returns = false;
    for (const Iceberg& iceberg : m_s.icebergs) {
        if (!mayVisit(flyer, iceberg))
            continue;
        visits = true;
        returns = returns || timeOf_s(flyer, uav.position_m, iceberg.position_m) +
                                     timeOf_s(flyer, iceberg.position_m, sortie->home_m) <=
                                 sortie->endurance_s;
    }
    if (visits && !returns)
        m_found.warn(flyer.path + ".endurance_s", IssueId::NoRoundTrip);
}

void ScenarioWarnings::adviseFences()
{
    bool isFenced = false;
    for (const Flyer& flyer : m_flyers) {
        if (!flyer.fence)
            continue;
        isFenced = true;
        if (flyer.fence->turnClearance_m(startOf(flyer.uav)) < 0)
            m_found.warn(flyer.path + ".position_m", IssueId::StartNearFence);
        if (const std::optional<SortieSpec> sortie = sortieOf(flyer.uav))
            adviseReturn(flyer, *sortie);
    }
    if (isFenced && traitsOf(m_s.planner.policy).method == PolicyMethod::PredictedZeta)
        m_found.hint(m_s.geofence        ? "geofence"
                     : m_s.noFly.empty() ? "asset.standoff_m"
                                         : "no_fly",
                     IssueId::FenceUnplanned);
    adviseShutOff();
}

/** Checks the paths home inside the fence: from the start, and from home on the next sortie. */
void ScenarioWarnings::adviseReturn(const Flyer& flyer, const SortieSpec& sortie)
{
    const Uav& uav = flyer.uav;
    const CommandClock clock{
        .dt_s = m_s.dt_s,
        .steps = std::max<std::int64_t>(1, std::llround(uav.spec.autopilot_s / m_s.dt_s))};
    const SafetyGuard guard(
        {.motion = motionOf(m_s, uav), .sortie = sortie, .fence = flyer.fence, .clock = clock});
    const std::optional<ReturnPath> path = guard.returnPath(startOf(uav));
    if (!path)
        m_found.warn(flyer.path + ".position_m", IssueId::NoSafeReturn);
    else if (guard.time_s(*path) + kHomeReserve_s > sortie.endurance_s)
        m_found.warn(flyer.path + ".endurance_s", IssueId::NoPathHome);
    if (!guard.safeHeading_rad({.position_m = sortie.home_m}, sortie.endurance_s))
        m_found.warn(flyer.path + ".home_m", IssueId::HomeNearFence);
}

void ScenarioWarnings::adviseShutOff()
{
    const auto isShutOffFrom = [](const Flyer& flyer, const Point& place_m) {
        return flyer.fence && (flyer.fence->isOutOfReach(place_m, flyer.surely_m) ||
                               (flyer.isWide && flyer.fence->isShutOff(place_m)));
    };
    for (std::size_t i = 0; i < m_s.icebergs.size(); ++i) {
        const Iceberg& iceberg = m_s.icebergs[i];
        if (isOutside(iceberg.position_m))
            continue;
        if (allVisitors(iceberg, [&](const Flyer& flyer) {
                return isShutOffFrom(flyer, iceberg.position_m);
            }))
            m_found.warn(entryPath("icebergs", i) + ".position_m", IssueId::ShutOff);
    }
}

void ScenarioWarnings::adviseAsset()
{
    if (m_s.asset && std::any_of(m_s.icebergs.begin(), m_s.icebergs.end(), [&](const Iceberg& b) {
            return b.appears_s == 0 && (b.position_m - m_s.asset->position_m).norm() < b.radius_m;
        }))
        m_found.warn("asset.position_m", IssueId::AssetInIce);
}

void ScenarioWarnings::adviseIceberg(std::size_t i)
{
    const Iceberg& iceberg = m_s.icebergs[i];
    const std::string path = entryPath("icebergs", i);
    if (isOutside(estimateAt(iceberg, iceberg.appears_s)))
        m_found.warn(path + ".position_m", IssueId::OutsideArea);
    else if (comesInTime(iceberg) &&
             isOutside(iceberg.track.empty() ? endOf(iceberg) : iceberg.track.at(m_s.duration_s)))
        m_found.hint(path + ".velocity_mps", IssueId::LeavesArea);
    if (iceberg.velocity_mps.norm() > kFastDrift_mps)
        m_found.hint(path + ".velocity_mps", IssueId::Fast);
    if (!iceberg.track.empty())
        adviseTrack(iceberg, path);
}

void ScenarioWarnings::adviseTrack(const Iceberg& iceberg, const std::string& path)
{
    if (iceberg.track.time_s.back() < m_s.duration_s)
        m_found.hint(path + ".track", IssueId::TrackShort);
    const Point gap_m = iceberg.track.at(iceberg.appears_s) - iceberg.position_m;
    if (allVisitors(iceberg, [&](const Flyer& f) { return gap_m.norm() > f.reach_m; }))
        m_found.warn(path + ".track", IssueId::TrackFar);
}

void ScenarioWarnings::adviseSamePlace()
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
            m_found.warn(entryPath("icebergs", i) + ".position_m", IssueId::SamePlace);
}

/**
 * Compares only start and end: if a UAV can catch up with an iceberg, it can be there at the end.
 */
void ScenarioWarnings::adviseReach()
{
    std::vector<std::size_t> far;
    std::size_t coming = 0;
    for (std::size_t i = 0; i < m_s.icebergs.size(); ++i) {
        const Iceberg& iceberg = m_s.icebergs[i];
        if (!comesInTime(iceberg))
            continue;
        ++coming;
        const auto isLate = [&](const Flyer& flyer) {
            const auto time_s = [&](const Point& place_m) {
                return timeOf_s(flyer, flyer.uav.position_m, place_m);
            };
            return std::min(time_s(iceberg.position_m), time_s(endOf(iceberg))) > m_s.duration_s;
        };
        if (allVisitors(iceberg, isLate))
            far.push_back(i);
    }
    if (coming > 0 && far.size() == coming) {
        m_found.warn("duration_s", IssueId::TooShort);
        return;
    }
    for (const std::size_t i : far)
        m_found.warn(entryPath("icebergs", i) + ".position_m", IssueId::OutOfReach);
}

void ScenarioWarnings::advisePlanner()
{
    const std::size_t count = m_s.icebergs.size();
    const PlannerSettings& planner = m_s.planner;
    if (m_s.clusters && !traitsOf(planner.policy).plansClusters)
        m_found.hint("planner.clusters", IssueId::ClustersIgnored);
    if (!traitsOf(planner.policy).usesTau || count == 0)
        return;
    if (std::all_of(m_s.icebergs.begin(), m_s.icebergs.end(),
                    [](const Iceberg& iceberg) { return initialSigma_m2(iceberg) == 0; }))
        m_found.hint("icebergs", IssueId::NoSigma);
    if (planner.tau == 0) // sorting gives the optimum
        return;
    const bool exact = planner.backend == Backend::Exact;
    if (count > kMostProven && exact)
        m_found.warn("planner.backend", IssueId::SolverUnable);
    else if (count > kMostProven)
        m_found.hint("icebergs", IssueId::BeyondProof);
    else if (count > kQuickProof && exact)
        m_found.hint("planner.backend", IssueId::LongProof);
}

} // namespace

std::optional<Issue> unknownMembers(const std::string& field, const std::string& extraJson)
{
    const std::size_t open = extraJson.find('"');
    if (open == std::string::npos)
        return std::nullopt;
    const std::string first = extraJson.substr(open + 1, extraJson.find('"', open + 1) - open - 1);
    return Issue{Severity::Hint, field, {.id = IssueId::UnknownMembers, .arguments = {first}}};
}

std::vector<Issue> scenarioWarnings(const Scenario& scenario)
{
    require(!scenario.uavs.empty(), "scenarioWarnings: the scenario has errors");
    if (!scenario.forecast)
        return ScenarioWarnings(scenario).findings();
    Scenario atStart = scenario; // starts and first legs are flown in the wind of the start
    atStart.wind_mps = windAtStart_mps(scenario);
    return ScenarioWarnings(atStart).findings();
}

} // namespace berg
