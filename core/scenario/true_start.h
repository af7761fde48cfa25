#pragma once

#include "core/scenario/scenario.h"

namespace berg {

/** Where an iceberg truly is at t = 0, and its true mean velocity without the current. */
struct TrueStart
{
    Point position_m = Point::Zero();
    Point velocity_mps = Point::Zero();
};

/**
 * As the scenario gives them with the simple observer, without noise, and where a recorded track
 * says where the iceberg is. Else drawn about them with variance `initialSigma_m2` and standard
 * deviation `velocitySd_mps`, from the stream (seed, id): the same in every flight.
 */
[[nodiscard]] TrueStart trueStart(const Iceberg& iceberg, const ObserverSpec& observer,
                                  std::uint64_t seed, bool noise);

/**
 * How the simulation moves it from `trueStart` at `start_s` on, over a current that carries all.
 * With the simple observer the velocity is constant: the one that is known.
 */
[[nodiscard]] DriftSpec trueDrift(const Iceberg& iceberg, const ObserverSpec& observer,
                                  std::uint64_t seed, bool noise, const Point& current_mps,
                                  double start_s = 0);

} // namespace berg
