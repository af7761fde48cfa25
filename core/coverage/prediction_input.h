#pragma once

#include "core/tracking/lost_search.h"
#include "core/vehicle/los_guidance.h"
#include "core/vehicle/path_home.h"
#include "core/vehicle/wind_series.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace berg {

/** The sorties of a UAV with a limited endurance after the one under way. */
struct LaterSorties
{
    SortieSpec spec;
    double runEnd_s = 0;
};

/**
 * All that may be known of a UAV's flight at one instant, from which the rest of the flight is
 * predicted.
 */
struct PredictionInput
{
    double time_s = 0;
    double until_s = 0; ///< End of the run, or of the sortie if that is earlier.
    /** Later sorties; nullopt if the endurance outlasts the run. */
    std::optional<LaterSorties> laterSorties;
    DubinsState uav;
    Motion motion;
    /** Wind from `time_s` on; where it never changes, that of `motion` counts. */
    WindAhead wind = {};
    SensorSpec sensor;
    /** Acceptance radius; if it is nullopt, an iceberg in view is reached. */
    std::optional<double> reachRadius_m;
    ObserverSpec observer;
    std::vector<Track> tracks; ///< Tracks, one per id of the `PlanRequest` in its order.
    /** Weight of the sigma of each track in the search for a plan; an empty list means 1 each. */
    std::vector<double> weights;
    /** Probability, for each track, that a lost iceberg is found at its estimate; an empty list
     * means that no search for it has failed yet. */
    std::vector<double> chances;
    /** Places, for each track, where a lost iceberg may be, likeliest first; one without places is
     * searched for at its estimate with its chance. */
    std::vector<std::vector<SearchPlace>> places;
    std::uint64_t seed = 0; ///< Seed of the scenario.
    /** Step of the flight; with `seed` it selects the random numbers of a search. */
    std::int64_t step = 0;
};

/** Returns the mean wind of the next `duration_s`; exactly that of `motion` if it is constant. */
[[nodiscard]] inline Point meanWind_mps(const PredictionInput& input, double duration_s)
{
    return input.wind.nextChange_s(0) < duration_s ? input.wind.mean_mps(duration_s)
                                                   : input.motion.wind_mps;
}

} // namespace berg
