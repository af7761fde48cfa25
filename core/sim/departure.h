#pragma once

#include "core/vehicle/safety_guard.h"

#include <functional>

namespace berg {

/** A UAV aloft that is too close to another for each to have a clear disc. */
struct Departing
{
    const SafetyGuard& guard;
    DubinsState pose;
    double radius_m = 0; ///< radius of its reserved disc: `Separation`
};

/** Commands that lead one UAV to a disc clear of all others. */
struct Departure
{
    std::vector<double> rates_radps; ///< turn rates by command
    std::vector<Point> path_m;       ///< positions by time step, the start first
    Point middle_m = Point::Zero();  ///< centre of the disc at the end of the path
    double side = 1;                 ///< side of the UAV on which the disc lies: 1 left, -1 right

    /**
     * Removes and returns the first turn rate, rad/s, with the `steps` positions it covers. Returns
     * nullopt if every command has been flown.
     */
    std::optional<double> takeNext_radps(std::int64_t steps);
};

/** Returns true if departing UAV number `uav` may fly the departure, whatever the others fly. */
using MayDepart = std::function<bool(std::size_t uav, const Departure&)>;

/**
 * Finds departures for UAVs that start at the same time. Each consists of straight lines and one
 * turn, and all have the same duration. They end in discs `separation_m` apart, and two UAVs that
 * have once been that far apart stay so, except pairs that start towards each other and cannot.
 * Returns the shortest set, by UAV, or an empty list if none was found. Takes milliseconds, or
 * seconds when there is none.
 */
[[nodiscard]] std::vector<Departure> departuresOf(std::span<const Departing> uavs,
                                                  double separation_m, const MayDepart& mayDepart);

} // namespace berg
