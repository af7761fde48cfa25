#pragma once

#include "core/scenario/scenario.h"

namespace berg {

/** True position of an iceberg at t = 0 and its true mean velocity, current excluded. */
struct InitialTruth
{
    Point position_m = Point::Zero();
    Point velocity_mps = Point::Zero();
};

/**
 * Returns the true start of an iceberg. With the simple observer, without noise or with a recorded
 * track it equals the scenario's values. Otherwise it is drawn with the variances that
 * `initialTrack` has at t = 0, from the stream (seed, id), and is the same in every flight.
 */
[[nodiscard]] InitialTruth initialTruth(const Iceberg& iceberg, const ObserverSpec& observer,
                                        std::uint64_t seed, bool noise);

/**
 * Returns the drift from `initialTruth` at `start_s` on, in a current that carries all icebergs.
 * With the simple observer the velocity is constant and known.
 */
[[nodiscard]] DriftSpec trueDrift(const Iceberg& iceberg, const ObserverSpec& observer,
                                  std::uint64_t seed, bool noise, const Point& current_mps,
                                  double start_s = 0);

} // namespace berg
