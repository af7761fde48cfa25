#pragma once

#include "core/scenario/scenario.h"

namespace berg {

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
