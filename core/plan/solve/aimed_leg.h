#pragma once

#include "core/base/geometry.h"

#include <optional>
#include <vector>

namespace berg {

/**
 * One leg of a plan with aim points: a turn at the limit, then a line that passes an iceberg. Or a
 * hold: a turn or a line that is flown until `end_s`, to keep in view what is in view.
 */
struct AimedLeg
{
    int iceberg = -1;    ///< id of the one that the line passes, or that is flown to after a hold
    double turn_rad = 0; ///< left positive
    Point from_m = Point::Zero();  ///< where the line starts, over ground
    Point abeam_m = Point::Zero(); ///< where it passes the iceberg
    double sighting_s = 0;         ///< when the first sighting on this leg is predicted
    std::optional<double> end_s;   ///< of a hold: when it ends, whatever is seen by then
    bool operator==(const AimedLeg&) const = default;
};

/** A place where a lost iceberg may be comes into view. */
struct PlannedSearch
{
    int iceberg = -1; ///< id
    Point place_m = Point::Zero();
    double time_s = 0;
    double chance = 0; ///< that it is found there, as far as is known when the plan is made
    bool operator==(const PlannedSearch&) const = default;
};

/** What a plan with aim points is predicted to come to, flown to the end of the prediction. */
struct AimedOutlook
{
    double until_s = 0;  ///< the end of the run, or earlier in a long one
    double zeta_m2s = 0; ///< added until then
    /** When the first ones of the plan's order are seen, ascending; the plan does not see the rest.
     */
    std::vector<double> sightings_s;
    std::vector<PlannedSearch> searches; ///< ascending by time, each place once
    bool operator==(const AimedOutlook&) const = default;
};

} // namespace berg
