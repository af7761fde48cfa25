#pragma once

#include "core/vehicle/safety_guard.h"

#include <functional>

namespace berg {

/** A UAV that is aloft too near another one to have a disc of its own. */
struct Departing
{
    const SafetyGuard& guard;
    DubinsState pose;
    double radius_m = 0; ///< of its disc: `Separation`
};

/** How it flies to a disc that is clear of all others. */
struct Departure
{
    std::vector<double> rates_radps; ///< by command
    std::vector<Point> path_m;       ///< by time step, the place it starts from first
    Point middle_m = Point::Zero();  ///< of the disc that the path ends on
    double side = 1;                 ///< where the UAV has it: 1 left, -1 right

    /** Takes the first of the commands off, with the steps that it lasts; none: all are flown. */
    std::optional<double> takeNext_radps(std::int64_t steps);
};

/** Whether UAV number `uav` of those that depart may fly this, whatever the others of them fly. */
using MayDepart = std::function<bool(std::size_t uav, const Departure&)>;

/**
 * Departures of UAVs that start at one time, a turn and straight lines each, all of one length:
 * they end in discs that are the separation apart, and any two that have been so far apart on the
 * way stay so, but for those that start towards each other and cannot. The shortest ones; empty:
 * none were found. Takes milliseconds, seconds when there are none.
 */
[[nodiscard]] std::vector<Departure> departuresOf(std::span<const Departing> uavs,
                                                  double separation_m, const MayDepart& mayDepart);

} // namespace berg
