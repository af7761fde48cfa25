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

void Simulation::buildFence(int uav)
{
    Craft& craft = m_crafts[index(uav)];
    craft.fence = std::make_shared<const Geofence>(m_area_m, craft.motion);
}

/** What the fence has left after one command; negative when the fence can be left. */
double Simulation::roomAfter_m(int uav, double u_radps) const
{
    const UavState& me = m_state.uavs[index(uav)];
    const Craft& craft = m_crafts[index(uav)];
    DubinsState at = me.pose;
    for (std::int64_t i = 0; i < craft.autopilotSteps; ++i) {
        at = berg::step(at, craft.motion.airspeed_mps, u_radps, m_dt_s, craft.motion.wind_mps);
        if (craft.autopilotSteps > 1 && !craft.fence->contains(at.position_m))
            return -craft.fence->radius_m();
    }
    return craft.fence->room_m(at);
}

/**
 * The command, or the one nearest to it that leaves room: as there was room before, there is one,
 * round the circle that was inside. When rounding has used it up, the one that leaves most.
 */
double Simulation::guarded(int uav, double u_radps) const
{
    const UavState& me = m_state.uavs[index(uav)];
    const Craft& craft = m_crafts[index(uav)];
    if (!craft.fence || roomAfter_m(uav, u_radps) >= kRoom_m)
        return u_radps;
    std::vector<double> rates{craft.fence->circlingRate_radps(me.pose, 1),
                              craft.fence->circlingRate_radps(me.pose, -1)};
    for (const double part : kRates)
        rates.push_back(part * craft.motion.limit_radps);
    double best_radps = u_radps;
    double best_m = roomAfter_m(uav, u_radps);
    for (const double rate_radps : rates) {
        const double room_m = roomAfter_m(uav, rate_radps);
        const bool nearer = std::abs(rate_radps - u_radps) < std::abs(best_radps - u_radps);
        if (best_m < kRoom_m ? room_m > best_m : room_m >= kRoom_m && nearer) {
            best_m = room_m;
            best_radps = rate_radps;
        }
    }
    return best_radps;
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
