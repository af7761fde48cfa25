// The geofence: the part of `Simulation` that stays inside it.

#include "core/sim/simulation.h"
#include "core/vehicle/geofence.h"

#include <array>
#include <cmath>

namespace berg {

namespace {

/** Left of the fence by commands that are not made for it. */
constexpr double kRoom_m = 2;
/** Turn rates tried instead, in parts of the limit. */
constexpr std::array<double, 9> kRates{-1, -0.75, -0.5, -0.25, 0, 0.25, 0.5, 0.75, 1};

} // namespace

void Simulation::buildFence()
{
    m_fence = std::make_shared<const Geofence>(m_area_m, m_motion);
}

/** What the fence has left after one command; negative when the fence can be left. */
double Simulation::roomAfter_m(double u_radps) const
{
    DubinsState uav = m_state.uav;
    for (std::int64_t i = 0; i < m_autopilotSteps; ++i) {
        uav = berg::step(uav, m_motion.airspeed_mps, u_radps, m_dt_s, m_motion.wind_mps);
        if (m_autopilotSteps > 1 && !m_fence->contains(uav.position_m))
            return -m_fence->radius_m();
    }
    return m_fence->room_m(uav);
}

/**
 * The command, or the one nearest to it that leaves room: as there was room before, there is one,
 * round the circle that was inside. When rounding has used it up, the one that leaves most.
 */
double Simulation::guarded(double u_radps) const
{
    if (!m_fence || roomAfter_m(u_radps) >= kRoom_m)
        return u_radps;
    std::vector<double> rates{m_fence->circlingRate_radps(m_state.uav, 1),
                              m_fence->circlingRate_radps(m_state.uav, -1)};
    for (const double part : kRates)
        rates.push_back(part * m_motion.limit_radps);
    double best_radps = u_radps;
    double best_m = roomAfter_m(u_radps);
    for (const double rate_radps : rates) {
        const double room_m = roomAfter_m(rate_radps);
        const bool nearer = std::abs(rate_radps - u_radps) < std::abs(best_radps - u_radps);
        if (best_m < kRoom_m ? room_m > best_m : room_m >= kRoom_m && nearer) {
            best_m = room_m;
            best_radps = rate_radps;
        }
    }
    return best_radps;
}

std::optional<double> Simulation::steerRoundFence(const Point& end_m)
{
    if (!m_fence)
        return std::nullopt;
    const std::vector<Point> corners_m = m_fence->cornersBetween(m_state.uav.position_m, end_m);
    const std::optional<Point> via_m =
        corners_m.empty() ? std::nullopt : std::optional(corners_m.front());
    if (via_m != m_state.via_m) {
        m_state.via_m = via_m;
        m_state.guidance.startLeg(m_state.uav.position_m);
    }
    if (!via_m)
        return std::nullopt;
    const LosGuidance::Command command =
        m_state.guidance.steer(m_state.uav, *via_m, m_motion, m_command_s);
    m_state.crossTrack_m = command.crossTrack_m;
    if (!command.passedEnd)
        return command.u_radps;
    const Point back_m = *via_m - m_state.uav.position_m;
    return turnRateForCourse(m_state.uav.psi_rad, std::atan2(back_m.y(), back_m.x()), m_motion,
                             m_state.guidance.gains.turn_1ps);
}

} // namespace berg
