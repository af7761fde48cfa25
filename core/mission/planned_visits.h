#pragma once

#include "core/mission/recorder.h"
#include "core/tracking/observer.h"

#include <optional>
#include <span>
#include <vector>

namespace berg {

/**
 * Predicted visits of each iceberg, by index, in mission time and ascending: the sightings along
 * the aimed legs of the plans in force and the later visits of their patrols, of all UAVs together.
 * `plans` holds the plan of each UAV, or null. Visits before `now_s` are left out. All lists are
 * empty if no plan is a patrol.
 */
[[nodiscard]] std::vector<std::vector<double>> plannedVisits(std::span<const PlanPointer> plans,
                                                             std::size_t icebergs, double now_s);

/** The longest time that a patrol leaves one iceberg unseen. */
struct RevisitGap
{
    IcebergIndex iceberg; ///< index
    double gap_s = 0;
    bool operator==(const RevisitGap&) const = default;
};

/**
 * The longest time between two sightings of one iceberg, from its last sighting so far
 * (`Track::seen_s`) to its last planned visit. `visits` are those of `plannedVisits`. Returns
 * nullopt if nothing is visited.
 */
[[nodiscard]] std::optional<RevisitGap> longestGap(std::span<const std::vector<double>> visits,
                                                   std::span<const Track> tracks);

} // namespace berg
