#pragma once

#include "core/mission/policy_forecast.h"
#include "core/study/parallel.h"

#include <optional>
#include <span>

namespace berg {

/** Predicted zeta of a flight with a policy, from flights in randomly drawn worlds. */
struct ZetaPrediction
{
    double mean_m2s = 0;
    double least_m2s = 0; ///< 5 % of the flights are below
    double most_m2s = 0;  ///< 5 % of the flights are above
    bool operator==(const ZetaPrediction&) const = default;
};

/**
 * Summarises the zeta of each flight (`drawnZeta_m2s`). Throws `std::logic_error` without flights.
 */
[[nodiscard]] ZetaPrediction predictionOf(std::span<const double> drawn_m2s);

/**
 * Predicts zeta for a scenario with the policy of its planner; the result is the same on every
 * machine. Cost: `kDrawnFlights` missions, on several threads. Returns nullopt if stopped. Throws
 * as the constructor of `Mission`.
 */
[[nodiscard]] std::optional<ZetaPrediction> predictZeta(const Scenario& scenario,
                                                        const ParallelOptions& options = {});

} // namespace berg
