#include "core/sim/simulation.h"

#include "core/base/angles.h"

#include <algorithm>
#include <cmath>

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
    , m_asset(scenario.asset)
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
{
    require(noise.empty() || noise.size() == scenario.icebergs.size(),
            "Simulation: noise of another scenario");
    m_state.uav = {.position_m = scenario.uavs[0].position_m,
                   .psi_rad = psiFromHeading(scenario.uavs[0].heading_deg)};
    m_state.guidance.startLeg(m_state.uav.position_m);
    for (std::size_t i = 0; i < scenario.icebergs.size(); ++i) {
        const Iceberg& iceberg = scenario.icebergs[i];
        require(noise.empty() || noise[i].isOf(m_seed, iceberg.id),
                "Simulation: noise of another scenario");
        insert(iceberg, noise.empty() ? DriftNoise(m_seed, iceberg.id) : noise[i], 0,
               std::llround(iceberg.appears_s / m_dt_s));
    }
    observe(0);
    m_newlyAppeared.clear(); // those that are there from the start are no news
}

void Simulation::insert(const Iceberg& iceberg, DriftNoise noise, double start_s,
                        std::int64_t appearsStep)
{
    const Point velocity_mps = iceberg.velocity_mps + m_current_mps;
    m_drift.emplace_back(
        DriftSpec{.position_m = iceberg.position_m,
                  .start_s = start_s,
                  .velocity_mps = velocity_mps,
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
    m_state.tracks.push_back(
        {.anchor_m = iceberg.position_m,
         .anchor_s = start_s,
         .velocity_mps = velocity_mps,
         .sigma_m2 = initialSigma_m2(iceberg) + iceberg.q_m2ps * std::max(0.0, unseen_s),
         .q_m2ps = iceberg.q_m2ps});
}

void Simulation::addIceberg(const Iceberg& iceberg)
{
    insert(iceberg, DriftNoise(m_seed, iceberg.id), time_s(), m_state.step);
    const int added = icebergCount() - 1;
    if (fieldOfView().contains(truth_m(added)))
        m_state.tracks.back().seen(truth_m(added), time_s());
    m_planReason = PlanReason::Appeared;
}

void Simulation::reportSighting(int iceberg)
{
    require(active(iceberg), "reportSighting: the iceberg has not appeared");
    Track& track = m_state.tracks[index(iceberg)];
    const bool inView = track.inView;
    track.seen(truth_m(iceberg), time_s());
    track.inView = inView;
    m_planReason = PlanReason::Intervention;
}

void Simulation::setWind(const Point& wind_mps)
{
    m_motion.wind_mps = wind_mps;
    // It may come to icebergs sooner now.
    for (std::size_t i = 0; i < m_lookStep.size(); ++i)
        m_lookStep[i] = std::max(m_appearsStep[i], m_state.step + 1);
    m_nextLookStep = m_state.step + 1;
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

bool Simulation::active(int iceberg) const
{
    return m_appearsStep[index(iceberg)] <= m_state.step;
}

bool Simulation::withinReach(int iceberg) const
{
    return m_reachRadius_m &&
           (truth_m(iceberg) - m_state.uav.position_m).norm() <= *m_reachRadius_m;
}

bool Simulation::available(int iceberg) const
{
    return active(iceberg) && !track(iceberg).inView && !withinReach(iceberg);
}

Point Simulation::truth_m(int iceberg) const
{
    const DriftModel& drift = m_drift[index(iceberg)];
    return drift.at(active(iceberg) ? time_s() : drift.start_s());
}

Point Simulation::estimate_m(int iceberg) const
{
    return track(iceberg).estimate_m(time_s());
}

FieldOfView Simulation::fieldOfView() const
{
    return {m_sensor, m_state.uav.position_m, m_state.uav.psi_rad};
}

PlanRequest Simulation::planRequest() const
{
    PlanRequest request{.speed_mps = m_motion.airspeed_mps};
    FlightPicture picture{.time_s = time_s(),
                          .until_s = static_cast<double>(m_lastStep) * m_dt_s,
                          .uav = m_state.uav,
                          .motion = m_motion,
                          .sensor = m_sensor,
                          .seed = m_seed,
                          .step = m_state.step};
    std::vector<Point> nodes_m{m_state.uav.position_m};
    request.problem.sigma_m2.push_back(0);
    for (int i = 0; i < icebergCount(); ++i) {
        if (!active(i))
            continue;
        request.ids.push_back(i);
        request.available.push_back(available(i));
        const double weight = priority(i);
        request.problem.sigma_m2.push_back(weight * track(i).sigma_m2);
        nodes_m.push_back(estimate_m(i));
        picture.tracks.push_back(track(i));
        picture.weights.push_back(weight);
    }
    request.picture = std::make_shared<const FlightPicture>(std::move(picture));
    const auto n = static_cast<Eigen::Index>(nodes_m.size());
    request.problem.distance_m.resize(n, n);
    const bool calm = m_motion.wind_mps.isZero(0);
    for (Eigen::Index j = 0; j < n; ++j)
        for (Eigen::Index i = 0; i < n; ++i) {
            const Point leg_m =
                nodes_m[static_cast<std::size_t>(j)] - nodes_m[static_cast<std::size_t>(i)];
            // Air distance U t_ij: what a leg costs when the wind helps or hinders.
            request.problem.distance_m(i, j) =
                calm ? leg_m.norm()
                     : m_motion.airspeed_mps *
                           flightTime_s(leg_m, m_motion.airspeed_mps, m_motion.wind_mps);
        }
    return request;
}

void Simulation::setTarget(int iceberg, const std::optional<AimedLeg>& aim)
{
    m_planReason = PlanReason::None;
    m_state.target = iceberg;
    m_state.aim = aim;
    m_state.misses = 0;
    if (iceberg >= 0) {
        m_state.mode = FlightMode::Leg;
        m_state.guidance.startLeg(aim ? aim->from_m : m_state.uav.position_m);
        return;
    }
    if (m_state.lastReached < 0)
        m_state.lastReached = nearest(&Simulation::active);
    m_state.mode = m_state.lastReached < 0 ? FlightMode::Idle : FlightMode::Circle;
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
    m_state.u_radps = commanded();
    m_state.uav =
        berg::step(m_state.uav, m_motion.airspeed_mps, m_state.u_radps, m_dt_s, m_motion.wind_mps);
    m_state.flown_m += m_motion.airspeed_mps * m_dt_s;
    m_newlySeen.clear();
    m_newlyAppeared.clear();
    observe(m_dt_s);
    m_state.zeta_m2s += m_state.sigmaSum_m2 * m_dt_s;
    updatePlanReason();
}

void Simulation::observe(double dt_s)
{
    const double now_s = time_s();
    // Icebergs out of reach are left alone for long; so `truth_m` has at most a second to make up.
    if (m_state.step % m_stepsPerSecond == 0)
        for (std::size_t i = 0; i < m_drift.size(); ++i)
            if (m_appearsStep[i] <= m_state.step)
                m_drift[i].advanceTo(now_s);
    if (m_nextLookStep <= m_state.step)
        lookAround(now_s);
    double sigmaSum_m2 = 0;
    for (std::size_t i = 0; i < m_state.tracks.size(); ++i) {
        const std::int64_t age = m_state.step - m_appearsStep[i];
        if (age < 0)
            continue;
        Track& track = m_state.tracks[i];
        if (!track.inView)
            track.unseen(age == 0 ? 0 : dt_s);
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
    if (m_state.target >= 0 && m_state.aim) {
        updatePlanReasonOfAim();
        return;
    }
    if (m_state.target >= 0) {
        const bool reached =
            m_reachRadius_m ? withinReach(m_state.target) : track(m_state.target).inView;
        if (reached) {
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
        if (available(i)) {
            m_planReason = PlanReason::OutOfView;
            return;
        }
}

} // namespace berg
