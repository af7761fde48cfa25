// What the autopilot commands: the part of `Simulation` that steers.

#include "core/base/angles.h"
#include "core/sim/simulation.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

/** Circle flown while every iceberg is in view: this much wider than the tightest turn. */
constexpr double kCircleMargin = 1.2;
/** Between two searches for a path home, while none is known. */
constexpr std::int64_t kNextSearch_s = 10;

} // namespace

double Simulation::commanded(int uav)
{
    UavState& me = m_state.uavs[index(uav)];
    const Craft& craft = m_crafts[index(uav)];
    if ((m_state.step - 1) % craft.autopilotSteps != 0)
        return me.u_radps;
    const SafetyGuard guard = guardOf(uav);
    if (me.mode == FlightMode::Home)
        return commandedHome(uav);
    const double u_radps = guard.limitedToFence_radps(me.pose, steer(uav));
    if (guard.provesReturn())
        return commandedWithReturn(uav, u_radps);
    if (!craft.sortie || guard.homeInTimeAfter(me.pose, u_radps, enduranceLeft_s(uav)))
        return u_radps;
    goHome(uav);
    return commandedHome(uav);
}

/** Along the proven path; without one, which only a new wind or a bad start leaves, as well as it
 * goes. */
double Simulation::commandedHome(int uav)
{
    UavState& me = m_state.uavs[index(uav)];
    const SafetyGuard guard = guardOf(uav);
    const bool isDue = (m_state.step - 1) % (kNextSearch_s * m_stepsPerSecond) == 0;
    if (guard.provesReturn() && !me.returnPath && isDue)
        me.returnPath = guard.returnPath(me.pose);
    me.crossTrack_m = 0;
    return me.returnPath ? me.returnPath->takeNext_radps()
                         : guard.limitedToFence_radps(me.pose, steerHome(uav));
}

/**
 * The command wished for, where a path home is proven after it. Else the next one of the path that
 * is proven now: on the way home for good when time is what lacks.
 */
double Simulation::commandedWithReturn(int uav, double wished_radps)
{
    UavState& me = m_state.uavs[index(uav)];
    const SafetyGuard guard = guardOf(uav);
    const double left_s = enduranceLeft_s(uav);
    Outlook outlook = guard.outlookAfter(me.pose, wished_radps, left_s);
    if (outlook.back == Return::InTime) {
        me.returnPath = std::move(outlook.path);
        return wished_radps;
    }
    const bool isProven = me.returnPath && !me.returnPath->parts.empty();
    const bool mayFlyOn = isProven ? outlook.back == Return::Unknown
                                   : guard.homeInTimeAfter(me.pose, wished_radps, left_s);
    if (!mayFlyOn) {
        if (!isProven)
            me.returnPath = guard.returnPath(me.pose);
        goHome(uav);
        return commandedHome(uav);
    }
    if (!isProven)
        me.returnPath.reset();
    return isProven ? me.returnPath->takeNext_radps() : wished_radps;
}

double Simulation::steer(int uav)
{
    UavState& me = m_state.uavs[index(uav)];
    const Craft& craft = m_crafts[index(uav)];
    switch (me.mode) {
    case FlightMode::Leg:
        return steerLeg(uav);
    case FlightMode::RunOut:
        return steerRunOut(uav);
    case FlightMode::Circle:
        return steerCircle(uav);
    case FlightMode::Search:
        return steerSearch(uav);
    case FlightMode::Home:
        return steerHome(uav);
    case FlightMode::Ground:
        return 0;
    case FlightMode::Idle:
        me.crossTrack_m = 0;
        return craft.motion.limit_radps / kCircleMargin; // nothing to fly to: hold where it is
    }
    throw std::logic_error("Simulation: unknown flight mode");
}

double Simulation::steerLeg(int uav)
{
    UavState& me = m_state.uavs[index(uav)];
    const Craft& craft = m_crafts[index(uav)];
    if (me.aim)
        return steerAim(uav);
    if (!me.members.empty())
        return steerCluster(uav);
    const Point end_m = estimate_m(me.target);
    if (const std::optional<double> u_radps = steerRoundFence(uav, end_m))
        return *u_radps;
    LosGuidance::Command command = me.guidance.steer(me.pose, end_m, craft.motion, craft.command_s);
    if (command.passedEnd) {
        ++me.misses;
        if (craft.needsRunOut) {
            // Each further miss gets more room, so that in the end the leg is straight.
            me.runOut_m = 2 * craft.turnRadius_m * me.misses;
            me.mode = FlightMode::RunOut;
            return steerRunOut(uav);
        }
        me.guidance.startLeg(me.pose.position_m);
        command = me.guidance.steer(me.pose, end_m, craft.motion, craft.command_s);
    }
    me.crossTrack_m = command.crossTrack_m;
    return command.u_radps;
}

double Simulation::steerAim(int uav)
{
    UavState& me = m_state.uavs[index(uav)];
    const Craft& craft = m_crafts[index(uav)];
    AimedLeg& aim = *me.aim;
    if (aim.turn_rad != 0) {
        // The side of the turn is part of the plan; the last step ends it exactly.
        const double u_radps = std::clamp(aim.turn_rad / craft.command_s, -craft.motion.limit_radps,
                                          craft.motion.limit_radps);
        const bool last = std::abs(u_radps) < craft.motion.limit_radps;
        aim.turn_rad = last ? 0 : aim.turn_rad - u_radps * craft.command_s;
        me.crossTrack_m = 0;
        return u_radps;
    }
    const LosGuidance::Command command =
        me.guidance.steer(me.pose, aim.abeam_m, craft.motion, craft.command_s);
    me.crossTrack_m = command.crossTrack_m;
    return command.u_radps;
}

double Simulation::steerRunOut(int uav)
{
    UavState& me = m_state.uavs[index(uav)];
    const Craft& craft = m_crafts[index(uav)];
    me.crossTrack_m = 0;
    me.runOut_m -= craft.motion.airspeed_mps * craft.command_s;
    if (me.runOut_m <= 0) {
        me.mode = FlightMode::Leg;
        me.guidance.startLeg(me.pose.position_m);
    }
    return 0;
}

/** Of the circle flown while every iceberg is in view. */
double Simulation::circleRadius_m(int uav) const
{
    const Motion& air = motion(uav);
    return kCircleMargin * (air.airspeed_mps + air.wind_mps.norm()) / air.limit_radps;
}

double Simulation::steerCircle(int uav)
{
    UavState& me = m_state.uavs[index(uav)];
    const Craft& craft = m_crafts[index(uav)];
    me.crossTrack_m = 0;
    const Point from_m = me.pose.position_m - estimate_m(me.lastReached);
    const double radius_m = circleRadius_m(uav);
    // Counter-clockwise tangent, turned inwards outside the circle and outwards inside it.
    const double bearing_rad = std::atan2(from_m.y(), from_m.x());
    const double course_rad =
        bearing_rad + kPi / 2 + std::atan((from_m.norm() - radius_m) / (radius_m / 2));
    return turnRateForCourse(me.pose.psi_rad, course_rad, craft.motion, me.guidance.gains.turn_1ps);
}

} // namespace berg
