#pragma once

#include "core/scenario/flight_weather.h"

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
 * Returns the drift from `initialTruth` at `start_s` on, above a constant mean velocity or, if
 * `forcing` is not null, above one that changes. With the simple observer the velocity above the
 * mean is constant and known.
 */
[[nodiscard]] DriftSpec trueDrift(const Iceberg& iceberg, const ObserverSpec& observer,
                                  std::uint64_t seed, bool noise, const Point& mean_mps,
                                  double start_s = 0,
                                  std::shared_ptr<const DriftForcing> forcing = nullptr);

/**
 * Returns the drift of an iceberg of the scenario in its weather (`weatherOf`, which may be null):
 * that of every flight, whatever is done in it.
 */
[[nodiscard]] DriftSpec trueDrift(const ScenarioWorld& scenario, const Iceberg& iceberg,
                                  const std::shared_ptr<const FlightWeather>& weather,
                                  double start_s = 0);

/** Returns `initialTrack` of an iceberg that starts at `start_s` in the scenario's weather. */
[[nodiscard]] Track trackAtStart(const ScenarioWorld& scenario, const Iceberg& iceberg,
                                 const std::shared_ptr<const FlightWeather>& weather,
                                 double start_s = 0);

/**
 * Predicts a track without sightings until `until_s`, in a mean velocity that changes unless
 * `forcing` is null.
 */
void growUnseen(Track& track, const DriftForcing* forcing, double from_s, double until_s);

} // namespace berg
