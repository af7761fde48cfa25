#include "core/sim/simulation.h"

#include "core/base/angles.h"
#include "core/scenario/advice.h"
#include "core/scenario/true_start.h"
#include "core/sim/clusters.h"
#include "core/vehicle/geofence.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

/** Memory for noise drawn at once. */
constexpr std::size_t kMostNoise_bytes = 32'000'000;
bool turnsInsideReach(const Uav& uav, const SensorSpec& sensor,
                      const std::optional<double>& reachRadius_m)
{
    return reachRadius_m.value_or(surelySeen_m(sensor)) < turnRadius_m(uav.spec);
}

} // namespace

std::vector<DriftNoise> drawNoise(const Scenario& scenario)
{
    const std::size_t share =
        kMostNoise_bytes / sizeof(Point) / std::max<std::size_t>(1, scenario.icebergs.size());
    const auto seconds = static_cast<std::size_t>(std::ceil(scenario.duration_s)) + 1;
    std::vector<DriftNoise> noise;
    for (const Iceberg& iceberg : scenario.icebergs)
        noise.emplace_back(static_cast<std::uint64_t>(scenario.seed), iceberg.id,
                           scenario.noise && iceberg.track.empty() ? std::min(seconds, share) : 0);
    return noise;
}

double WorldState::flown_m() const
{
    double sum_m = 0;
    for (const UavState& uav : uavs)
        sum_m += uav.flown_m;
    return sum_m;
}

Simulation::Simulation(const Scenario& scenario, std::span<const DriftNoise> noise)
    : m_reachRadius_m(scenario.reachRadius_m)
    , m_clusters(scenario.clusters && scenario.uavs.size() == 1)
    , m_asset(scenario.asset)
    , m_area_m(scenario.area_m)
    , m_geofence(scenario.geofence)
    , m_separation_m(scenario.separation_m)
    , m_observer(scenario.observer)
    , m_current_mps(scenario.current_mps)
    , m_dt_s(scenario.dt_s)
    , m_lastStep(std::max<std::int64_t>(1, std::llround(scenario.duration_s / scenario.dt_s)))
    , m_stepsPerSecond(std::max<std::int64_t>(1, std::llround(1 / scenario.dt_s)))
    , m_seed(static_cast<std::uint64_t>(scenario.seed))
    , m_noise(scenario.noise)
    , m_lookSteps(std::max<std::int64_t>(1, std::llround(scenario.observer.interval_s / m_dt_s)))
{
    require(noise.empty() || noise.size() == scenario.icebergs.size(),
            "Simulation: noise of another scenario");
    require(!scenario.uavs.empty(), "Simulation: no UAV");
    setPolicy(scenario.planner.policy);
    for (const Uav& uav : scenario.uavs)
        addUav(uav, scenario);
    for (std::size_t i = 0; i < scenario.icebergs.size(); ++i) {
        const Iceberg& iceberg = scenario.icebergs[i];
        require(noise.empty() || noise[i].isOf(m_seed, iceberg.id),
                "Simulation: noise of another scenario");
        insert(iceberg, noise.empty() ? DriftNoise(m_seed, iceberg.id) : noise[i], 0,
               std::llround(iceberg.appears_s / m_dt_s));
    }
    observe(0);
    m_newlyAppeared.clear(); // those that are there from the start are no news
    m_events.clear();
}

void Simulation::addUav(const Uav& uav, const Scenario& scenario)
{
    const SensorSpec sensor{.fov_m = uav.fov_m, .shape = scenario.fovShape};
    Craft craft{.id = uav.id,
                .motion = {.airspeed_mps = uav.spec.airspeed_mps,
                           .limit_radps = maxTurnRate_radps(uav.spec),
                           .wind_mps = scenario.wind_mps},
                .sensor = sensor,
                .altitude_m = uav.spec.altitude_m,
                .reach_m = FieldOfView::reach_m(sensor),
                .turnRadius_m = turnRadius_m(uav.spec),
                .needsRunOut = turnsInsideReach(uav, sensor, scenario.reachRadius_m),
                .autopilotSteps =
                    std::max<std::int64_t>(1, std::llround(uav.spec.autopilot_s / m_dt_s))};
    craft.command_s = static_cast<double>(craft.autopilotSteps) * m_dt_s;
    if (uav.spec.endurance_s > 0)
        craft.sortie = {.endurance_s = uav.spec.endurance_s,
                        .turnaround_s = uav.turnaround_s,
                        .home_m = uav.home_m.value_or(uav.position_m)};
    m_crafts.push_back(std::move(craft));
    if (m_geofence)
        buildFence(uavCount() - 1);
    m_planReasons.push_back(PlanReason::Start);
    UavState state{
        .pose = {.position_m = uav.position_m, .psi_rad = psiFromHeading(uav.heading_deg)}};
    state.guidance.startLeg(uav.position_m);
    // A turn rate is held for so long: more than the whole error at a time makes it swing.
    state.guidance.gains.turn_1ps =
        std::min(state.guidance.gains.turn_1ps, 1 / m_crafts.back().command_s);
    m_state.uavs.push_back(std::move(state));
    proveReturn(uavCount() - 1);
}

/** -1: no UAV is of that name. */
int Simulation::uavOf(const std::string& id) const
{
    const auto it = std::ranges::find(m_crafts, id, &Craft::id);
    return it == m_crafts.end() ? -1 : static_cast<int>(it - m_crafts.begin());
}

void Simulation::insert(const Iceberg& iceberg, DriftNoise noise, double start_s,
                        std::int64_t appearsStep)
{
    const Point velocity_mps = iceberg.velocity_mps + m_current_mps;
    const TrueStart truth = trueStart(iceberg, m_observer, m_seed, m_noise);
    m_drift.emplace_back(
        DriftSpec{.position_m = truth.position_m,
                  .start_s = start_s,
                  .velocity_mps = truth.velocity_mps + m_current_mps,
                  .q_m2ps = iceberg.q_m2ps,
                  .track = iceberg.track.empty()
                               ? nullptr
                               : std::make_shared<const RecordedTrack>(iceberg.track)},
        std::move(noise), m_noise);
    m_appearsStep.push_back(appearsStep);
    m_lookStep.push_back(appearsStep);
    m_nextLookStep = std::min(m_nextLookStep, appearsStep);
    // An iceberg that appears later has drifted unseen until then.
    const double unseen_s = static_cast<double>(appearsStep) * m_dt_s - start_s;
    Track track{.anchor_m = iceberg.position_m,
                .anchor_s = start_s,
                .velocity_mps = velocity_mps,
                .sigma_m2 = initialSigma_m2(iceberg),
                .q_m2ps = iceberg.q_m2ps};
    if (m_observer.model == ObserverModel::Kalman)
        track.velocity_m2ps2 = iceberg.velocitySd_mps * iceberg.velocitySd_mps;
    m_assigned.push_back(iceberg.uav.empty() ? -1 : uavOf(iceberg.uav));
    m_bodies.push_back({.stream = stableHash(iceberg.id + "/look"),
                        .radius_m = iceberg.radius_m,
                        .velocity_mps = velocity_mps,
                        .velocity_m2ps2 = track.velocity_m2ps2});
    track.grow(std::max(0.0, unseen_s));
    m_state.tracks.push_back(std::move(track));
}

void Simulation::addIceberg(const Iceberg& iceberg)
{
    insert(iceberg, DriftNoise(m_seed, iceberg.id), time_s(), m_state.step);
    const int added = icebergCount() - 1;
    Views views(m_crafts.size());
    if (m_observer.model == ObserverModel::Simple && viewer(truth_m(added), views) >= 0)
        m_state.tracks.back().seen(truth_m(added), time_s());
    needPlans(PlanReason::Appeared);
}

void Simulation::reportSighting(int iceberg)
{
    require(active(iceberg), "reportSighting: the iceberg has not appeared");
    Track& track = m_state.tracks[index(iceberg)];
    const bool inView = track.inView;
    if (m_observer.model == ObserverModel::Simple)
        track.seen(truth_m(iceberg), time_s());
    else
        measure(index(iceberg), truth_m(iceberg), time_s(), -1);
    track.inView = inView;
    requestPlan();
}

void Simulation::setWind(const Point& wind_mps)
{
    // It may come to icebergs sooner now.
    for (std::size_t i = 0; i < m_lookStep.size(); ++i)
        m_lookStep[i] = std::max(m_appearsStep[i], m_state.step + 1);
    m_nextLookStep = m_state.step + 1;
    for (int uav = 0; uav < uavCount(); ++uav) {
        Craft& craft = m_crafts[index(uav)];
        craft.motion.wind_mps = wind_mps;
        if (craft.fence)
            buildFence(uav);
        proveReturn(uav);
        if (const std::optional<double> margin_s = homeMargin_s(uav); margin_s && *margin_s < 0) {
            m_events.push_back({.kind = EventKind::LateHome, .uav = uav});
            if (!this->uav(uav).homeward())
                goHome(uav);
        }
    }
    requestPlan();
}

void Simulation::assign(int iceberg, int uav)
{
    require(iceberg >= 0 && iceberg < icebergCount() && uav >= -1 && uav < uavCount(),
            "assign: no such iceberg or UAV");
    m_assigned[index(iceberg)] = uav;
    requestPlan();
}

void Simulation::setPolicy(PolicyKind policy)
{
    m_plansIdleAlone = !traitsOf(policy).keepsRoute();
}

void Simulation::setAsset(const Asset& asset)
{
    m_asset = asset;
    requestPlan();
}

std::optional<RelativeMotion> Simulation::relativeToAsset(int iceberg) const
{
    if (!m_asset)
        return std::nullopt;
    return berg::relativeToAsset(*m_asset, time_s(), estimate_m(iceberg),
                                 track(iceberg).velocity_mps);
}

double Simulation::priority(int iceberg) const
{
    const std::optional<RelativeMotion> motion = relativeToAsset(iceberg);
    return motion ? berg::priority(*m_asset, *motion) : 1;
}

bool Simulation::appeared(int iceberg) const
{
    return m_appearsStep[index(iceberg)] <= m_state.step;
}

bool Simulation::active(int iceberg) const
{
    return appeared(iceberg) && !track(iceberg).left;
}

bool Simulation::withinReach(int uav, int iceberg) const
{
    return m_reachRadius_m &&
           (truth_m(iceberg) - this->uav(uav).pose.position_m).norm() <= *m_reachRadius_m;
}

bool Simulation::withinReachOfAny(int iceberg) const
{
    for (int uav = 0; m_reachRadius_m && uav < uavCount(); ++uav)
        if (withinReach(uav, iceberg))
            return true;
    return false;
}

bool Simulation::visitable(int uav, int iceberg) const
{
    const Craft& craft = m_crafts[index(uav)];
    const int assigned = m_assigned[index(iceberg)];
    return active(iceberg) && track(iceberg).status == TrackStatus::Tracked &&
           !track(iceberg).inView && (assigned < 0 || assigned == uav) &&
           !withinReachOfAny(iceberg) &&
           !(craft.fence && craft.needsRunOut && craft.fence->isShutOff(estimate_m(iceberg)));
}

Point Simulation::truth_m(int iceberg) const
{
    const DriftModel& drift = m_drift[index(iceberg)];
    return drift.at(appeared(iceberg) ? time_s() : drift.start_s());
}

Point Simulation::estimate_m(int iceberg) const
{
    return track(iceberg).estimate_m(time_s());
}

void Simulation::setTarget(int uav, int iceberg, const std::optional<AimedLeg>& aim,
                           std::span<const int> members)
{
    UavState& me = m_state.uavs[index(uav)];
    // A plan that another UAV asked for, and that leaves this one its target: it flies on.
    const bool sameLeg = planReason(uav) == PlanReason::Fleet && iceberg >= 0 &&
                         iceberg == me.target && !aim && !me.aim && !me.homeward();
    m_planReasons[index(uav)] = PlanReason::None;
    if (sameLeg) {
        if (me.mode != FlightMode::Search) // another UAV may have left it its search
            beginOrEndSearch(uav);
        return;
    }
    me.target = iceberg;
    me.aim = aim;
    me.misses = 0;
    setMembers(uav, members);
    if (iceberg >= 0) {
        me.mode = FlightMode::Leg;
        me.guidance.startLeg(aim ? aim->from_m : me.pose.position_m);
        beginOrEndSearch(uav);
        return;
    }
    if (me.lastReached < 0)
        me.lastReached = nearest(uav, [this](int i) { return active(i); });
    me.mode = me.lastReached < 0 ? FlightMode::Idle : FlightMode::Circle;
    beginOrEndSearch(uav);
    if (me.mode != FlightMode::Search && nothingAffordable(uav))
        goHome(uav);
}

template <class Counts>
int Simulation::nearest(int uav, const Counts& counts) const
{
    const Point& from_m = m_state.uavs[index(uav)].pose.position_m;
    int nearest = -1;
    double nearest_m = 0;
    for (int i = 0; i < icebergCount(); ++i) {
        const double distance_m = (estimate_m(i) - from_m).norm();
        if (counts(i) && (nearest < 0 || distance_m < nearest_m)) {
            nearest = i;
            nearest_m = distance_m;
        }
    }
    return nearest;
}

int Simulation::nearestAvailable(int uav) const
{
    return nearest(uav, [this, uav](int iceberg) { return available(uav, iceberg); });
}

/** There is something to be visited, but not in this sortie. */
bool Simulation::nothingAffordable(int uav) const
{
    return sortie(uav) &&
           nearest(uav, [this, uav](int iceberg) { return visitable(uav, iceberg); }) >= 0 &&
           nearestAvailable(uav) < 0;
}

void Simulation::advanceStep()
{
    require(planReason() == PlanReason::None, "advanceStep: a plan is needed first");
    require(!finished(), "advanceStep: the run is over");
    ++m_state.step; // the estimates steered at are those at the end of the step
    m_trigger = PlanReason::None;
    std::vector<Point> before_m;
    if (uavCount() > 1)
        for (const UavState& uav : m_state.uavs)
            before_m.push_back(uav.pose.position_m);
    for (int uav = 0; uav < uavCount(); ++uav)
        fly(uav);
    if (uavCount() > 1)
        watchSeparation(before_m);
    m_newlySeen.clear();
    m_newlyAppeared.clear();
    observe(m_dt_s);
    m_state.zeta_m2s += m_state.sigmaSum_m2 * m_dt_s;
    updatePlanReasons();
    for (int uav = 0; uav < uavCount(); ++uav)
        updateClusters(uav);
}

void Simulation::fly(int uav)
{
    UavState& me = m_state.uavs[index(uav)];
    const Craft& craft = m_crafts[index(uav)];
    const Point from_m = me.pose.position_m;
    if (me.mode != FlightMode::Ground) {
        me.u_radps = commanded(uav);
        me.pose = berg::step(me.pose, craft.motion.airspeed_mps, me.u_radps, m_dt_s,
                             craft.motion.wind_mps);
        me.flown_m += craft.motion.airspeed_mps * m_dt_s;
    }
    if (craft.sortie)
        advanceSortie(uav, from_m);
}

/** Whether it was on the ground, or nowhere, before this step. */
bool Simulation::isJustAloft(int uav) const
{
    return m_state.step == 1 || (sortie(uav) && this->uav(uav).aloft_s < 1.5 * m_dt_s);
}

/** Of the pairs aloft in one altitude layer; `before_m`: the places before the step. */
void Simulation::watchSeparation(std::span<const Point> before_m)
{
    for (int a = 0; a < uavCount(); ++a)
        for (int b = a + 1; b < uavCount(); ++b) {
            const double layers_m =
                std::abs(m_crafts[index(a)].altitude_m - m_crafts[index(b)].altitude_m);
            if (layers_m >= kLayerHeight_m || uav(a).mode == FlightMode::Ground ||
                uav(b).mode == FlightMode::Ground)
                continue;
            const double distance_m = (uav(a).pose.position_m - uav(b).pose.position_m).norm();
            m_state.closest_m = std::min(m_state.closest_m.value_or(distance_m), distance_m);
            const bool wasApart =
                isJustAloft(a) || isJustAloft(b) ||
                (before_m[index(a)] - before_m[index(b)]).norm() >= m_separation_m;
            if (wasApart && distance_m < m_separation_m)
                m_events.push_back(
                    {.kind = EventKind::Close, .uav = a, .otherUav = b, .distance_m = distance_m});
        }
}

} // namespace berg
