// The geofence: the part of `Simulation` that stays inside it.

#include "core/sim/simulation.h"
#include "core/vehicle/geofence.h"

#include <cmath>

namespace berg {

void Simulation::buildFence(int uav)
{
    Craft& craft = m_crafts[index(uav)];
    craft.fence = std::make_shared<const Geofence>(m_area_m, craft.motion);
}

std::optional<double> Simulation::steerRoundFence(int uav, const Point& end_m)
{
    UavState& me = m_state.uavs[index(uav)];
    const Craft& craft = m_crafts[index(uav)];
    if (!craft.fence)
        return std::nullopt;
    const std::vector<Point> corners_m = craft.fence->cornersBetween(me.pose.position_m, end_m);
    const std::optional<Point> via_m =
        corners_m.empty() ? std::nullopt : std::optional(corners_m.front());
    if (via_m != me.via_m) {
        me.via_m = via_m;
        me.guidance.startLeg(me.pose.position_m);
    }
    if (!via_m)
        return std::nullopt;
    const LosGuidance::Command command =
        me.guidance.steer(me.pose, *via_m, craft.motion, craft.command_s);
    me.crossTrack_m = command.crossTrack_m;
    if (!command.passedEnd)
        return command.u_radps;
    const Point back_m = *via_m - me.pose.position_m;
    return turnRateForCourse(me.pose.psi_rad, std::atan2(back_m.y(), back_m.x()), craft.motion,
                             me.guidance.gains.turn_1ps);
}

} // namespace berg
