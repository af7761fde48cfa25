#pragma once

#include "core/scenario/scenario.h"

namespace berg {

/** A field of icebergs to be drawn. Defaults: those of Table 3 of the paper, in any direction. */
struct FieldRequest
{
    int icebergs = 25;
    std::vector<Point> area_m; ///< simple polygon they lie in
    double speedMin_mps = 0;
    double speedMax_mps = 0.4;
    double towards_deg = 0;  ///< middle of the directions of drift, clockwise from north
    double spread_deg = 180; ///< to either side of it; 180: any direction
    double sigmaMin_m2 = 1;
    double sigmaMax_m2 = 10;
    double q_m2ps = 0.025;
    std::int64_t seed = 1;
    bool fittedDrift = false; ///< velocities are not known, `driftAsFitted`, in place of the above
    double spacing_m = 0;     ///< least distance between two, and to those there are; 0: any
};

/**
 * Icebergs drawn from the seed alone, uniform in the area, with ids that `scenario` does not have.
 * In the rectangle of `FieldSpec` they are those of `randomScenario`. Throws `Error{InvalidInput}`
 * with the members of the request at fault (all of them) when one is out of range or the scenario
 * would hold more than `kMostIcebergs`, and with `spacing_m` or `area_m` when not all of them are
 * placed after a bounded number of tries.
 */
[[nodiscard]] std::vector<Iceberg> generateIcebergs(const Scenario& scenario,
                                                    const FieldRequest& request);

} // namespace berg
