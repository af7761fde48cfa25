#pragma once

#include "core/checks/weather_gate.h"
#include "core/study/parallel.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace berg {

/** Start times of a scan. */
struct StartScanSpec
{
    double every_s = 3600;
    double span_s = 24 * 3600.0; ///< the last start is at most this later than the scenario's
    bool operator==(const StartScanSpec&) const = default;
};
/** Largest number of starts of a scan. */
inline constexpr std::size_t kMostStarts = 1000;

/** One start of a scan. */
struct StartOutcome
{
    double delay_s = 0; ///< after the start of the scenario
    std::string startUtc;
    /** Zeta of the flight; nullopt if the scenario cannot be flown from then on. */
    std::optional<double> zeta_m2s;
    int visits = 0;
    WeatherVerdict weather; ///< along the flight; without one, that of `weatherOfArea`
    bool operator==(const StartOutcome&) const = default;
};

/** Flights of one scenario at several start times. */
struct StartScan
{
    std::vector<StartOutcome> starts; ///< times rising
    std::vector<std::string> uavs;    ///< ids, by UAV
    /** Index of the best start: `bestStart`. */
    std::optional<std::size_t> best;
    bool operator==(const StartScan&) const = default;
};

/**
 * Returns the scenario as it is expected to be `delay_s` >= 0 later, without a sighting in between:
 *
 * - `startUtc` is later, so that the flight meets the forecast of that time;
 * - each iceberg has drifted to its expected place (`IcebergDrift`, to the end of the forecast and
 *   from there with its last velocity), its own velocity has faded, and its last observation is
 *   older: `observed_s` grows by the delay, from which `initialTrack` has the growth of sigma;
 * - times of recorded tracks and of icebergs that appear later come nearer by the delay;
 * - the protected asset has moved on.
 *
 * UAVs start where the scenario has them.
 */
[[nodiscard]] Scenario startingLater(const Scenario& scenario, double delay_s);

/**
 * Returns the start with the lowest zeta of those whose weather is Go, or else Marginal; of equal
 * ones the earliest. Returns nullopt if there is none.
 */
[[nodiscard]] std::optional<std::size_t> bestStart(const std::vector<StartOutcome>& starts);

/**
 * Flies the scenario from each start time (`startingLater`) with the same seed, and compares the
 * weather along the flight with the limits of the UAVs. The result is the same with any number of
 * threads. Returns nullopt if stopped. Throws `Error{InvalidInput}` if `startUtc` is empty, and as
 * the constructor of `Mission` for the scenario's own start; a later start that cannot be flown has
 * no zeta. Throws `std::logic_error` for more than `kMostStarts` starts.
 */
[[nodiscard]] std::optional<StartScan> scanStarts(const Scenario& scenario,
                                                  const StartScanSpec& spec = {},
                                                  const ParallelOptions& options = {});

} // namespace berg
