#pragma once

#include "core/sim/policy_forecast.h"
#include "core/study/parallel.h"

#include <optional>
#include <span>

namespace berg {

/** What zeta a flight with a policy is predicted to come to, by flights in drawn worlds. */
struct ZetaPrediction
{
    double mean_m2s = 0;
    double least_m2s = 0; ///< 5 % of the flights are below
    double most_m2s = 0;  ///< 5 % of the flights are above
    bool operator==(const ZetaPrediction&) const = default;
};

/** `drawn_m2s`: zeta of each flight (`drawnZeta_m2s`), at least one. */
[[nodiscard]] ZetaPrediction predictionOf(std::span<const double> drawn_m2s);

/**
 * The prediction for a scenario with the policy of its planner: the same wherever it is made. Cost:
 * `kDrawnFlights` missions, on several threads. Returns nullopt if stopped. Throws as the
 * constructor of `Mission`.
 */
[[nodiscard]] std::optional<ZetaPrediction> predictZeta(const Scenario& scenario,
                                                        const ParallelOptions& options = {});

} // namespace berg
