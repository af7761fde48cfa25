#include "core/sim/simulation.h"

#include "core/base/angles.h"
#include "core/scenario/true_start.h"
#include "core/vehicle/geofence.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace berg {

namespace {

/** Memory for noise drawn at once. */
constexpr std::size_t kMostNoise_bytes = 32'000'000;
/** Icebergs farther out of reach than this are out of view in spite of all rounding. */
constexpr double kReachMargin_m = 1;
/** A sighting later than predicted by this is overdue. */
constexpr double kOverdue_s = 2;

bool turnsInsideReach(const Uav& uav, const std::optional<double>& reachRadius_m)
{
    const double reach_m = reachRadius_m ? *reachRadius_m : uav.fov_m.minCoeff() / 2;
    return reach_m < turnRadius_m(uav.spec);
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

Simulation::Simulation(const Scenario& scenario, std::span<const DriftNoise> noise)
    : m_motion{.airspeed_mps = scenario.uavs.at(0).spec.airspeed_mps,
               .limit_radps = maxTurnRate_radps(scenario.uavs[0].spec),
               .wind_mps = scenario.wind_mps}
    , m_sensor{.fov_m = scenario.uavs[0].fov_m, .shape = scenario.fovShape}
    , m_reachRadius_m(scenario.reachRadius_m)
    , m_clusters(scenario.clusters)
    , m_asset(scenario.asset)
    , m_area_m(scenario.area_m)
    , m_observer(scenario.observer)
    , m_current_mps(scenario.current_mps)
    , m_dt_s(scenario.dt_s)
    , m_autopilotSteps(
          std::max<std::int64_t>(1, std::llround(scenario.uavs[0].spec.autopilot_s / m_dt_s)))
    , m_command_s(static_cast<double>(m_autopilotSteps) * m_dt_s)
    , m_lastStep(std::max<std::int64_t>(1, std::llround(scenario.duration_s / scenario.dt_s)))
    , m_stepsPerSecond(std::max<std::int64_t>(1, std::llround(1 / scenario.dt_s)))
    , m_seed(static_cast<std::uint64_t>(scenario.seed))
    , m_noise(scenario.noise)
    , m_reach_m(FieldOfView::reach_m(m_sensor))
    , m_turnRadius_m(turnRadius_m(scenario.uavs[0].spec))
    , m_needsRunOut(turnsInsideReach(scenario.uavs[0], scenario.reachRadius_m))
    , m_lookSteps(std::max<std::int64_t>(1, std::llround(scenario.observer.interval_s / m_dt_s)))
{
    require(noise.empty() || noise.size() == scenario.icebergs.size(),
            "Simulation: noise of another scenario");
    m_state.uav = {.position_m = scenario.uavs[0].position_m,
                   .psi_rad = psiFromHeading(scenario.uavs[0].heading_deg)};
    m_state.guidance.startLeg(m_state.uav.position_m);
    if (const Uav& uav = scenario.uavs[0]; uav.spec.endurance_s > 0)
        m_sortie = {.endurance_s = uav.spec.endurance_s,
                    .turnaround_s = uav.turnaround_s,
                    .home_m = uav.home_m.value_or(uav.position_m)};
    if (scenario.geofence)
        buildFence();
    for (std::size_t i = 0; i < scenario.icebergs.size(); ++i) {
        const Iceberg& iceberg = scenario.icebergs[i];
        require(noise.empty() || noise[i].isOf(m_seed, iceberg.id),
                "Simulation: noise of another scenario");
        insert(iceberg, noise.empty() ? DriftNoise(m_seed, iceberg.id) : noise[i], 0,
               std::llround(iceberg.appears_s / m_dt_s));
    }
    observe(0);
    m_newlyAppeared.clear(); // those that are there from the start are no news
    m_news.clear();
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
    if (m_observer.model == ObserverModel::Simple && fieldOfView().contains(truth_m(added)))
        m_state.tracks.back().seen(truth_m(added), time_s());
    needPlan(PlanReason::Appeared);
}

void Simulation::reportSighting(int iceberg)
{
    require(active(iceberg), "reportSighting: the iceberg has not appeared");
    Track& track = m_state.tracks[index(iceberg)];
    const bool inView = track.inView;
    if (m_observer.model == ObserverModel::Simple)
        track.seen(truth_m(iceberg), time_s());
    else
        measure(index(iceberg), truth_m(iceberg), time_s());
    track.inView = inView;
    requestPlan();
}

void Simulation::setWind(const Point& wind_mps)
{
    m_motion.wind_mps = wind_mps;
    // It may come to icebergs sooner now.
    for (std::size_t i = 0; i < m_lookStep.size(); ++i)
        m_lookStep[i] = std::max(m_appearsStep[i], m_state.step + 1);
    m_nextLookStep = m_state.step + 1;
    if (m_fence)
        buildFence();
    if (const std::optional<double> margin_s = homeMargin_s(); margin_s && *margin_s < 0) {
        m_news.push_back({.kind = EventKind::LateHome});
        if (!homeward())
            goHome();
    }
    requestPlan();
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

bool Simulation::withinReach(int iceberg) const
{
    return m_reachRadius_m &&
           (truth_m(iceberg) - m_state.uav.position_m).norm() <= *m_reachRadius_m;
}

bool Simulation::visitable(int iceberg) const
{
    return active(iceberg) && track(iceberg).status == TrackStatus::Tracked &&
           !track(iceberg).inView && !withinReach(iceberg) &&
           !(m_fence && m_needsRunOut && m_fence->isShutOff(estimate_m(iceberg)));
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

FieldOfView Simulation::fieldOfView() const
{
    SensorSpec sensor = m_sensor;
    if (m_state.mode == FlightMode::Ground) // switched off: nothing is within these extents
        sensor.fov_m.setConstant(std::numeric_limits<double>::quiet_NaN());
    return {sensor, m_state.uav.position_m, m_state.uav.psi_rad};
}

void Simulation::setTarget(int iceberg, const std::optional<AimedLeg>& aim,
                           std::span<const int> members)
{
    m_planReason = PlanReason::None;
    m_state.target = iceberg;
    m_state.aim = aim;
    m_state.misses = 0;
    setMembers(members);
    if (iceberg >= 0) {
        m_state.mode = FlightMode::Leg;
        m_state.guidance.startLeg(aim ? aim->from_m : m_state.uav.position_m);
        beginOrEndSearch();
        return;
    }
    if (m_state.lastReached < 0)
        m_state.lastReached = nearest(&Simulation::active);
    m_state.mode = m_state.lastReached < 0 ? FlightMode::Idle : FlightMode::Circle;
    beginOrEndSearch();
    if (m_state.mode != FlightMode::Search && nothingAffordable())
        goHome();
}

int Simulation::nearest(bool (Simulation::*counts)(int) const) const
{
    int nearest = -1;
    double nearest_m = 0;
    for (int i = 0; i < icebergCount(); ++i) {
        const double distance_m = (estimate_m(i) - m_state.uav.position_m).norm();
        if ((this->*counts)(i) && (nearest < 0 || distance_m < nearest_m)) {
            nearest = i;
            nearest_m = distance_m;
        }
    }
    return nearest;
}

int Simulation::nearestAvailable() const
{
    return nearest(&Simulation::available);
}

void Simulation::advanceStep()
{
    require(m_planReason == PlanReason::None, "advanceStep: a plan is needed first");
    require(!finished(), "advanceStep: the run is over");
    ++m_state.step; // the estimates steered at are those at the end of the step
    const Point from_m = m_state.uav.position_m;
    if (m_state.mode != FlightMode::Ground) {
        m_state.u_radps = commanded();
        m_state.uav = berg::step(m_state.uav, m_motion.airspeed_mps, m_state.u_radps, m_dt_s,
                                 m_motion.wind_mps);
        m_state.flown_m += m_motion.airspeed_mps * m_dt_s;
    }
    if (m_sortie)
        advanceSortie(from_m);
    m_newlySeen.clear();
    m_newlyAppeared.clear();
    observe(m_dt_s);
    m_state.zeta_m2s += m_state.sigmaSum_m2 * m_dt_s;
    updatePlanReason();
    updateClusters();
}

void Simulation::observe(double dt_s)
{
    const double now_s = time_s();
    // Icebergs out of reach are left alone for long; so `truth_m` has at most a second to make up.
    if (m_state.step % m_stepsPerSecond == 0)
        for (std::size_t i = 0; i < m_drift.size(); ++i)
            if (m_appearsStep[i] <= m_state.step)
                m_drift[i].advanceTo(now_s);
    const bool isFiltered = m_observer.model == ObserverModel::Kalman;
    if (isFiltered)
        observeFiltered(now_s, dt_s);
    else if (m_nextLookStep <= m_state.step)
        lookAround(now_s);
    if (!m_area_m.empty() && m_state.step % m_stepsPerSecond == 0)
        watchArea();
    double sigmaSum_m2 = 0;
    for (std::size_t i = 0; i < m_state.tracks.size(); ++i) {
        const std::int64_t age = m_state.step - m_appearsStep[i];
        if (age < 0)
            continue;
        Track& track = m_state.tracks[i];
        if (!isFiltered && !track.inView)
            track.unseen(age == 0 ? 0 : dt_s);
        if (!track.left)
            sigmaSum_m2 += track.sigma_m2;
    }
    m_state.sigmaSum_m2 = sigmaSum_m2;
}

void Simulation::lookAround(double now_s)
{
    std::optional<FieldOfView> view;
    m_nextLookStep = m_lastStep + 1;
    for (std::size_t i = 0; i < m_lookStep.size(); ++i) {
        if (m_lookStep[i] <= m_state.step)
            look(i, now_s, view);
        m_nextLookStep = std::min(m_nextLookStep, m_lookStep[i]);
    }
}

/** Whether the iceberg is in view now. The view is made when it is first needed: it costs a sine.
 */
void Simulation::look(std::size_t iceberg, double now_s, std::optional<FieldOfView>& view)
{
    if (m_appearsStep[iceberg] == m_state.step)
        m_newlyAppeared.push_back(static_cast<int>(iceberg));
    Track& track = m_state.tracks[iceberg];
    const Point truth_m = m_drift[iceberg].position_m(now_s);
    const double away_m = (truth_m - m_state.uav.position_m).norm() - m_reach_m - kReachMargin_m;
    if (away_m > 0) {
        m_lookStep[iceberg] = firstStepInReach(m_drift[iceberg], away_m);
        track.inView = false;
        return;
    }
    m_lookStep[iceberg] = m_state.step + 1;
    if (!view)
        view = fieldOfView();
    if (!view->contains(truth_m)) {
        track.inView = false;
        return;
    }
    if (!track.inView)
        m_newlySeen.push_back(static_cast<int>(iceberg));
    track.seen(truth_m, now_s);
}

/** The next step at which an iceberg may be in view that is so far out of reach now, UAV and it
 * being as fast as they can. */
std::int64_t Simulation::firstStepInReach(const DriftModel& drift, double away_m) const
{
    const double closing_mps =
        m_motion.airspeed_mps + m_motion.wind_mps.norm() + drift.speedLimit_mps();
    const auto steps = static_cast<std::int64_t>(away_m / closing_mps / m_dt_s);
    return m_state.step + std::max<std::int64_t>(1, steps);
}

void Simulation::updatePlanReasonOfAim()
{
    if (!m_newlySeen.empty()) {
        const bool reached = track(m_state.target).inView;
        if (reached)
            m_state.lastReached = m_state.target;
        m_planReason = reached ? PlanReason::TargetReached : PlanReason::Sighted;
    } else if (!m_newlyAppeared.empty()) {
        m_planReason = PlanReason::Appeared;
    } else if (time_s() > m_state.aim->sighting_s + kOverdue_s) {
        m_planReason = PlanReason::Overdue;
    }
}

void Simulation::updatePlanReason()
{
    if (homeward()) {
        takeOffWhenDue();
        return;
    }
    m_planReason = reasonOfNews();
    if (m_planReason != PlanReason::None)
        return;
    if (m_state.target >= 0 && m_state.aim && m_state.mode != FlightMode::Search) {
        updatePlanReasonOfAim();
        return;
    }
    if (m_state.target >= 0) {
        if (targetReached()) {
            m_state.lastReached = m_state.target;
            m_planReason = PlanReason::TargetReached;
            return;
        }
    }
    if (!m_newlyAppeared.empty()) {
        m_planReason = PlanReason::Appeared;
        return;
    }
    if (m_state.target >= 0)
        return;
    for (int i = 0; i < icebergCount(); ++i)
        if (visitable(i)) {
            m_planReason = PlanReason::OutOfView;
            return;
        }
}

} // namespace berg
