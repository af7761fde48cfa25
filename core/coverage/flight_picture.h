#pragma once

#include "core/tracking/lost_search.h"
#include "core/vehicle/los_guidance.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace berg {

/** All that may be known of a flight at one instant: what its rest is predicted from. */
struct FlightPicture
{
    double time_s = 0;
    double until_s = 0; ///< end of the run
    DubinsState uav;
    Motion motion;
    SensorSpec sensor;
    std::optional<double> reachRadius_m; ///< an iceberg in view is reached if nullopt
    ObserverSpec observer;
    std::vector<Track> tracks; ///< one per id of the `PlanRequest`, in its order
    /** By track: so much its sigma counts in the search for a plan. Empty: 1 each. */
    std::vector<double> weights;
    /** By track: chance that it is found where it is believed to be if it is lost. Empty: as when
     * nobody has looked for it yet. */
    std::vector<double> chances;
    /** By track: where one that is lost may be, likeliest first. Empty: searched for at its
     * estimate with its chance. */
    std::vector<std::vector<SearchPlace>> places;
    std::uint64_t seed = 0; ///< of the scenario
    std::int64_t step = 0;  ///< with `seed`, names the random numbers of a search made now
};

} // namespace berg
