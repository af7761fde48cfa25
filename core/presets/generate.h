#pragma once

#include "core/scenario/scenario.h"

namespace berg {

/**
 * Request for a random field of icebergs. Defaults: Table 3 of the paper, with any direction of
 * drift.
 */
struct FieldRequest
{
    int icebergs = 25;
    std::vector<Point> area_m; ///< simple polygon in which they lie
    double speedMin_mps = 0;
    double speedMax_mps = 0.4;
    double towards_deg = 0;  ///< mean direction of drift, clockwise from north
    double spread_deg = 180; ///< range to either side of that direction; 180 means any direction
    double sigmaMin_m2 = 1;
    double sigmaMax_m2 = 10;
    double q_m2ps = 0.025;
    std::int64_t seed = 1;
    /** Unknown velocities as in `driftAsFitted`, in place of speeds and directions. */
    bool fittedDrift = false;
    /** Minimum distance to other icebergs, present ones included; 0 means no minimum. */
    double spacing_m = 0;
};

/**
 * Draws icebergs from the seed alone, uniformly in the area, with ids that `scenario` does not use.
 * In the rectangle of `FieldSpec` they equal those of `randomScenario`.
 * Throws `Error{InvalidInput}` with all members of the request that are out of range, or if the
 * scenario would exceed `kMostIcebergs`; names `spacing_m` or `area_m` if a bounded number of tries
 * does not place all icebergs.
 */
[[nodiscard]] std::vector<Iceberg> generateIcebergs(const Scenario& scenario,
                                                    const FieldRequest& request);

} // namespace berg
