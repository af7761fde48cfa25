#pragma once

#include "core/io/export/content/export_content.h"

#include <vector>

namespace berg {

// Access to the UAVs of a fleet in plans and recordings, for all exports.

/**
 * Returns what UAV `row` of the scenario flies from now on; its order is empty if the UAV has no
 * plan. Times of its legs count from now, those of its outlook from the start of the mission.
 */
[[nodiscard]] UavPlan presentPlan(const ExportSource& source, std::size_t row);

/**
 * Returns the present estimate as a scenario that starts now, with UAV `row` only: estimates
 * instead of true positions, no noise, no recorded tracks, and the remaining endurance. Indices of
 * icebergs are unchanged. Throws `std::out_of_range` if there is no such UAV.
 */
[[nodiscard]] Scenario presentScene(const ExportSource& source, std::size_t row);

/** Returns the recorded samples of a UAV, none if nothing was recorded. Throws as `TrackPoints`. */
[[nodiscard]] TrackPoints flownTrack(const Mission& mission, std::size_t row);

} // namespace berg
