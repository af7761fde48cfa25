#pragma once

#include "core/plan/solve/names.h"
#include "core/scenario/scenario.h"

#include <array>

namespace berg {

/** Knowledge of drift, and quality of observations. */
enum class FieldRegime
{
    Published,       ///< as in the paper: known velocities and exact sightings
    Measured,        ///< noisy measurements, known velocities
    UnknownVelocity, ///< noisy measurements; velocities uncertain by 0.1 m/s along each axis
    FittedDrift      ///< noisy measurements; drift as in `withFittedDrift`
};
inline constexpr std::array<Named<FieldRegime>, 4> kFieldRegimeNames{{
    {FieldRegime::Published, "published"},
    {FieldRegime::Measured, "measured"},
    {FieldRegime::UnknownVelocity, "unknown-velocity"},
    {FieldRegime::FittedDrift, "fitted-drift"},
}};

/**
 * Distributions of a random field of icebergs. Defaults: Table 3 of the paper and our choices where
 * it is silent.
 */
struct FieldSpec
{
    int icebergs = 12;
    Point size_m = Point(5000, 4000); ///< positions are uniform in [0, x] x [0, y]
    double speedMax_mps = 0.4;        ///< speeds are uniform in [0, max] with any direction
    double sigmaMin_m2 = 1;
    double sigmaMax_m2 = 10;
    double q_m2ps = 0.025;
    FieldRegime regime = FieldRegime::Published;
    bool operator==(const FieldSpec&) const = default;
};

/**
 * Returns a random scenario whose icebergs depend on `seed` and `field` alone; the same seed sets
 * the noise of the run. The observer is the simple one with `FieldRegime::Published`, else Kalman.
 * The UAV starts at (-500, 500) m with psi 45 degrees; duration 1000 s, dt 0.1 s. Throws
 * `std::logic_error` if the seed or the number of icebergs is negative.
 */
[[nodiscard]] Scenario randomScenario(std::int64_t seed, const FieldSpec& field = {});

/**
 * Makes the iceberg's velocity unknown and variable, with the statistics of real drift
 * (`kFittedDrift`); its known velocity becomes 0.
 */
void driftAsFitted(Iceberg& iceberg);
/**
 * Applies `driftAsFitted` to every iceberg and sets the Kalman observer, since the simple one knows
 * velocities.
 */
[[nodiscard]] Scenario withFittedDrift(Scenario scenario);

/**
 * Returns the scenario with which the program opens: `randomScenario(1)` on the Grand Banks, with
 * ids and a name.
 */
[[nodiscard]] Scenario defaultScenario();

} // namespace berg
