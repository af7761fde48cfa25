#include "core/sim/simulation.h"

#include "core/base/angles.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

/** Circle flown while every iceberg is in view: this much wider than the tightest turn. */
constexpr double kCircleMargin = 1.2;
/** A sighting later than predicted by this is overdue. */
constexpr double kOverdue_s = 2;

bool turnsInsideReach(const Uav& uav, const std::optional<double>& reachRadius_m)
{
    const double reach_m = reachRadius_m ? *reachRadius_m : uav.fov_m.minCoeff() / 2;
    return reach_m < turnRadius_m(uav.spec);
}

} // namespace

Simulation::Simulation(const Scenario& scenario)
    : m_motion{.airspeed_mps = scenario.uavs.at(0).spec.airspeed_mps,
               .limit_radps = maxTurnRate_radps(scenario.uavs[0].spec),
               .wind_mps = scenario.wind_mps}
    , m_sensor{.fov_m = scenario.uavs[0].fov_m, .shape = scenario.fovShape}
    , m_reachRadius_m(scenario.reachRadius_m)
    , m_current_mps(scenario.current_mps)
    , m_dt_s(scenario.dt_s)
    , m_lastStep(std::max<std::int64_t>(1, std::llround(scenario.duration_s / scenario.dt_s)))
    , m_seed(static_cast<std::uint64_t>(scenario.seed))
    , m_noise(scenario.noise)
    , m_turnRadius_m(turnRadius_m(scenario.uavs[0].spec))
    , m_needsRunOut(turnsInsideReach(scenario.uavs[0], scenario.reachRadius_m))
{
    m_state.uav = {.position_m = scenario.uavs[0].position_m,
                   .psi_rad = psiFromHeading(scenario.uavs[0].heading_deg)};
    m_state.guidance.startLeg(m_state.uav.position_m);
    for (const Iceberg& iceberg : scenario.icebergs)
        insert(iceberg, 0, std::llround(iceberg.appears_s / m_dt_s));
    observe(0);
    m_newlyAppeared.clear(); // those that are there from the start are no news
}

void Simulation::insert(const Iceberg& iceberg, double start_s, std::int64_t appearsStep)
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
        m_seed, iceberg.id, m_noise);
    m_appearsStep.push_back(appearsStep);
    m_truth_m.push_back(m_drift.back().position_m(start_s));
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
    insert(iceberg, time_s(), m_state.step);
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
        request.problem.sigma_m2.push_back(track(i).sigma_m2);
        nodes_m.push_back(estimate_m(i));
        picture.tracks.push_back(track(i));
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
        m_state.lastReached = nearestActive();
    m_state.mode = m_state.lastReached < 0 ? FlightMode::Idle : FlightMode::Circle;
}

int Simulation::nearestActive() const
{
    int nearest = -1;
    double nearest_m = 0;
    for (int i = 0; i < icebergCount(); ++i) {
        const double distance_m = (estimate_m(i) - m_state.uav.position_m).norm();
        if (active(i) && (nearest < 0 || distance_m < nearest_m)) {
            nearest = i;
            nearest_m = distance_m;
        }
    }
    return nearest;
}

void Simulation::advanceStep()
{
    require(m_planReason == PlanReason::None, "advanceStep: a plan is needed first");
    require(!finished(), "advanceStep: the run is over");
    ++m_state.step; // the estimates steered at are those at the end of the step
    m_state.u_radps = steer();
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
    const FieldOfView view = fieldOfView();
    const double now_s = time_s();
    m_state.sigmaSum_m2 = 0;
    for (std::size_t i = 0; i < m_state.tracks.size(); ++i) {
        if (m_appearsStep[i] > m_state.step)
            continue;
        Track& track = m_state.tracks[i];
        const bool appears = m_appearsStep[i] == m_state.step;
        if (appears)
            m_newlyAppeared.push_back(static_cast<int>(i));
        m_truth_m[i] = m_drift[i].position_m(now_s);
        if (view.contains(m_truth_m[i])) {
            if (!track.inView)
                m_newlySeen.push_back(static_cast<int>(i));
            track.seen(m_truth_m[i], now_s);
        } else {
            track.unseen(appears ? 0 : dt_s);
            m_state.sigmaSum_m2 += track.sigma_m2;
        }
    }
}

double Simulation::steer()
{
    switch (m_state.mode) {
    case FlightMode::Leg:
        return steerLeg();
    case FlightMode::RunOut:
        return steerRunOut();
    case FlightMode::Circle:
        return steerCircle();
    case FlightMode::Idle:
        m_state.crossTrack_m = 0;
        return m_motion.limit_radps / kCircleMargin; // nothing to fly to: hold where it is
    }
    throw std::logic_error("Simulation: unknown flight mode");
}

double Simulation::steerLeg()
{
    if (m_state.aim)
        return steerAim();
    const Point end_m = estimate_m(m_state.target);
    LosGuidance::Command command = m_state.guidance.steer(m_state.uav, end_m, m_motion, m_dt_s);
    if (command.passedEnd) {
        ++m_state.misses;
        if (m_needsRunOut) {
            // Each further miss gets more room, so that in the end the leg is straight.
            m_state.runOut_m = 2 * m_turnRadius_m * m_state.misses;
            m_state.mode = FlightMode::RunOut;
            return steerRunOut();
        }
        m_state.guidance.startLeg(m_state.uav.position_m);
        command = m_state.guidance.steer(m_state.uav, end_m, m_motion, m_dt_s);
    }
    m_state.crossTrack_m = command.crossTrack_m;
    return command.u_radps;
}

double Simulation::steerAim()
{
    AimedLeg& aim = *m_state.aim;
    if (aim.turn_rad != 0) {
        // The side of the turn is part of the plan; the last step ends it exactly.
        const double u_radps =
            std::clamp(aim.turn_rad / m_dt_s, -m_motion.limit_radps, m_motion.limit_radps);
        const bool last = std::abs(u_radps) < m_motion.limit_radps;
        aim.turn_rad = last ? 0 : aim.turn_rad - u_radps * m_dt_s;
        m_state.crossTrack_m = 0;
        return u_radps;
    }
    const LosGuidance::Command command =
        m_state.guidance.steer(m_state.uav, aim.abeam_m, m_motion, m_dt_s);
    m_state.crossTrack_m = command.crossTrack_m;
    return command.u_radps;
}

double Simulation::steerRunOut()
{
    m_state.crossTrack_m = 0;
    m_state.runOut_m -= m_motion.airspeed_mps * m_dt_s;
    if (m_state.runOut_m <= 0) {
        m_state.mode = FlightMode::Leg;
        m_state.guidance.startLeg(m_state.uav.position_m);
    }
    return 0;
}

double Simulation::steerCircle()
{
    m_state.crossTrack_m = 0;
    const Point from_m = m_state.uav.position_m - estimate_m(m_state.lastReached);
    const double wind_mps = m_motion.wind_mps.norm();
    const double radius_m =
        kCircleMargin * (m_motion.airspeed_mps + wind_mps) / m_motion.limit_radps;
    // Counter-clockwise tangent, turned inwards outside the circle and outwards inside it.
    const double bearing_rad = std::atan2(from_m.y(), from_m.x());
    const double course_rad =
        bearing_rad + kPi / 2 + std::atan((from_m.norm() - radius_m) / (radius_m / 2));
    return turnRateForCourse(m_state.uav.psi_rad, course_rad, m_motion,
                             m_state.guidance.gains.turn_1ps);
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
