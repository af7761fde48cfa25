#pragma once

#include "core/base/index.h"
#include "core/geometry/geometry.h"

#include <optional>
#include <vector>

namespace berg {

/**
 * One leg of a plan with aim points: a turn at the limit, then a line that passes an iceberg. A leg
 * may also be a hold: a turn or a line flown until `end_s`, which keeps icebergs in view.
 */
struct AimedLeg
{
    IcebergIndex iceberg;          ///< the line passes it, or it is flown to after a hold
    double turn_rad = 0;           ///< positive to the left
    Point from_m = Point::Zero();  ///< start of the line, over ground
    Point abeam_m = Point::Zero(); ///< place where the line passes the iceberg
    double sighting_s = 0;         ///< predicted time of the first sighting on this leg
    std::optional<double> end_s;   ///< end of a hold, whether or not anything is seen by then
    bool operator==(const AimedLeg&) const = default;
};

/** A planned view of a place where a lost iceberg may be. */
struct PlannedSearch
{
    IcebergIndex iceberg;
    Point place_m = Point::Zero();
    double time_s = 0;
    double chance = 0; ///< probability, at the time of planning, of finding it there
    bool operator==(const PlannedSearch&) const = default;
};

/** Prediction for a plan with aim points, flown to the end of the prediction. */
struct AimedOutlook
{
    double until_s = 0;  ///< end of the run, or earlier in a long run
    double zeta_m2s = 0; ///< zeta added until then
    /**
     * Predicted times of sighting of the first icebergs of the order, ascending; the plan does not
     * reach the rest.
     */
    std::vector<double> sightings_s;
    std::vector<PlannedSearch> searches; ///< ascending by time, each place once
    bool operator==(const AimedOutlook&) const = default;
};

} // namespace berg
