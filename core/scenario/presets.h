#pragma once

#include "core/plan/solve/names.h"
#include "core/scenario/scenario.h"

#include <array>

namespace berg {

/** What is known of how icebergs drift, and how they are seen. */
enum class FieldRegime
{
    Published,       ///< as in the paper: in view all is known, velocities always
    Measured,        ///< measurements with noise, velocities known
    UnknownVelocity, ///< likewise, velocities not known by 0.1 m/s along each axis
    FittedDrift      ///< likewise, as icebergs drift: `withFittedDrift`
};
inline constexpr std::array<Named<FieldRegime>, 4> kFieldRegimeNames{{
    {FieldRegime::Published, "published"},
    {FieldRegime::Measured, "measured"},
    {FieldRegime::UnknownVelocity, "unknown-velocity"},
    {FieldRegime::FittedDrift, "fitted-drift"},
}};

/** How a random field of icebergs is drawn. Defaults: Table 3 of the paper and what it leaves open.
 */
struct FieldSpec
{
    int icebergs = 12;
    Point size_m = Point(5000, 4000); ///< icebergs uniform in [0, x] x [0, y]
    double speedMax_mps = 0.4;        ///< uniform in [0, max], any direction
    double sigmaMin_m2 = 1;
    double sigmaMax_m2 = 10;
    double q_m2ps = 0.025;
    FieldRegime regime = FieldRegime::Published;
    bool operator==(const FieldSpec&) const = default;
};

/**
 * A random scenario: icebergs drawn from `seed` alone, the noise of the run from the same seed;
 * UAV at (-500, 500) m with psi 45 degrees, 1000 s, dt 0.1 s.
 */
[[nodiscard]] Scenario randomScenario(std::int64_t seed, const FieldSpec& field = {});

/** Its velocity is not known and changes, as real ones do: `kFittedDrift`. */
void driftAsFitted(Iceberg& iceberg);
/** The same of all, measured in flight: with the simple observer velocities are known. */
[[nodiscard]] Scenario withFittedDrift(Scenario scenario);

/** What the program opens with: `randomScenario(1)` on the Grand Banks, with ids and a name. */
[[nodiscard]] Scenario defaultScenario();

} // namespace berg
