#include "core/sim/autopilot.h"

// Steps of the UAV: its new pose, crossings of the fence and landings.

namespace berg {

void Autopilot::move(int uav, const ExternalPose* measured, StepReport& report)
{
    m_before_m = m_pose.position_m;
    const double dt_s = m_guard.uav().clock.dt_s;
    if (!isOnGround()) {
        m_pose = measured != nullptr
                     ? measured->pose
                     : step(m_pose, motion().airspeed_mps, m_u_radps, dt_s, motion().wind_mps);
        const Point path_m = m_pose.position_m - m_before_m - motion().wind_mps * dt_s;
        const bool isFlownPath = measured != nullptr && !measured->isJump;
        m_flown_m += isFlownPath ? path_m.norm() : motion().airspeed_mps * dt_s;
    }
    watchFence(uav, report);
    if (!m_guard.uav().sortie)
        return;
    if (m_guard.tick())
        report.add({.kind = EventKind::LateHome, .uav = uav});
    if (mode() != FlightMode::Home || !m_guard.isLanding(m_before_m, m_pose.position_m) ||
        (measured != nullptr && isFlying(*measured)))
        return;
    m_guard.land();
    m_mode = Ground{};
    m_u_radps = 0;
    m_crossTrack_m = 0;
    report.add({.kind = EventKind::Landed, .uav = uav});
}

/**
 * A real aircraft may pass over its home, or circle there, before it lands: it flies as long as it
 * is faster over ground than half of what the wind leaves of its airspeed.
 */
bool Autopilot::isFlying(const ExternalPose& measured) const
{
    const double slowest_mps = motion().airspeed_mps - motion().wind_mps.norm();
    const double over_m = (measured.pose.position_m - m_before_m).norm();
    return measured.isJump || over_m > slowest_mps / 2 * m_guard.uav().clock.dt_s;
}

bool Autopilot::isInsideFence() const
{
    const Geofence* fence = m_guard.uav().fence.get();
    return fence == nullptr || fence->contains(m_pose.position_m);
}

/**
 * Reports crossings of the fence. An autopilot crosses it only after a start too close to it; wind
 * and telemetry may lead across.
 */
void Autopilot::watchFence(int uav, StepReport& report) const
{
    const Geofence* fence = m_guard.uav().fence.get();
    if (fence == nullptr)
        return;
    const bool isInside = isInsideFence();
    if (isInside != fence->contains(m_before_m))
        report.add({.kind = isInside ? EventKind::BackInside : EventKind::LeftFence, .uav = uav});
}

} // namespace berg
