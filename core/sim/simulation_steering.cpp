// What the autopilot commands: the part of `Simulation` that steers.

#include "core/base/angles.h"
#include "core/sim/simulation.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

/** Circle flown while every iceberg is in view: this much wider than the tightest turn. */
constexpr double kCircleMargin = 1.2;

} // namespace

double Simulation::commanded()
{
    if ((m_state.step - 1) % m_autopilotSteps != 0)
        return m_state.u_radps;
    const double u_radps = guarded(steer());
    if (!m_sortie || m_state.mode == FlightMode::Home || homeInTimeAfter(u_radps))
        return u_radps;
    goHome();
    return guarded(steerHome());
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
    case FlightMode::Search:
        return steerSearch();
    case FlightMode::Home:
        return steerHome();
    case FlightMode::Ground:
        return 0;
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
    if (!m_state.members.empty())
        return steerCluster();
    const Point end_m = estimate_m(m_state.target);
    if (const std::optional<double> u_radps = steerRoundFence(end_m))
        return *u_radps;
    LosGuidance::Command command =
        m_state.guidance.steer(m_state.uav, end_m, m_motion, m_command_s);
    if (command.passedEnd) {
        ++m_state.misses;
        if (m_needsRunOut) {
            // Each further miss gets more room, so that in the end the leg is straight.
            m_state.runOut_m = 2 * m_turnRadius_m * m_state.misses;
            m_state.mode = FlightMode::RunOut;
            return steerRunOut();
        }
        m_state.guidance.startLeg(m_state.uav.position_m);
        command = m_state.guidance.steer(m_state.uav, end_m, m_motion, m_command_s);
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
            std::clamp(aim.turn_rad / m_command_s, -m_motion.limit_radps, m_motion.limit_radps);
        const bool last = std::abs(u_radps) < m_motion.limit_radps;
        aim.turn_rad = last ? 0 : aim.turn_rad - u_radps * m_command_s;
        m_state.crossTrack_m = 0;
        return u_radps;
    }
    const LosGuidance::Command command =
        m_state.guidance.steer(m_state.uav, aim.abeam_m, m_motion, m_command_s);
    m_state.crossTrack_m = command.crossTrack_m;
    return command.u_radps;
}

double Simulation::steerRunOut()
{
    m_state.crossTrack_m = 0;
    m_state.runOut_m -= m_motion.airspeed_mps * m_command_s;
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

} // namespace berg
