#pragma once

#include "core/earth/forecast.h"
#include "core/earth/geodesy.h"
#include "core/tracking/wind_drift.h"

#include <functional>
#include <optional>
#include <vector>

namespace berg {

/**
 * Returns wind and current at a time, seconds on the clock of the caller, or nullopt if one of them
 * is unknown.
 */
using ForcingAt = std::function<std::optional<Forcing>(double time_s)>;

/**
 * Returns the forcing of a forecast, with times in seconds since 1970 UTC. A quantity that the
 * forecast never gives has the value of `constant`.
 */
[[nodiscard]] ForcingAt forcingOf(Forecast forecast, const Forcing& constant);

/** An instant of a drift. */
struct DriftPoint
{
    double time_s = 0;
    LatLon place;
    Point velocity_mps = Point::Zero(); ///< towards true east and north
};

/** Start and times of a drift. */
struct DriftSpan
{
    LatLon place;
    double start_s = 0;
    double duration_s = 0;   ///< at least 0
    double every_s = 3600.0; ///< above 0; time between two points of the result
};

/**
 * Returns the drift from the start, with a point at the start and then each `every_s`. It ends
 * early, after the last complete interval, where the forcing is unknown; it is empty if that is so
 * at the start. Steps of at most 15 minutes use the velocity at their middle, which is exact while
 * wind and current change linearly. East and north are those of each step's own place.
 */
[[nodiscard]] std::vector<DriftPoint> driftPath(const DriftSpan& span, const DriftLaw& law,
                                                const ForcingAt& forcing);

} // namespace berg
