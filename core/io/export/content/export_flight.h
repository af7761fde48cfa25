#pragma once

#include "core/io/export/content/export_content.h"
#include "core/mission/flyable_path.h"

#include <vector>

namespace berg {

// Access to the UAVs of a fleet in plans and recordings, for all exports.

/**
 * Returns the plan with which the mission began, with the members that exports read; nothing is
 * solved again.
 */
[[nodiscard]] PlanAnswer startPlan(const Mission& mission);

/**
 * Returns the order that UAV `row` of the scenario flies from now on; it is empty if the UAV has
 * none. Times of its legs count from now, those of its searches from the start of the mission.
 */
[[nodiscard]] UavOrder presentOrder(const ExportSource& source, std::size_t row);

/**
 * Returns the present estimate as a scenario that starts now, with UAV `row` only: estimates
 * instead of true positions, no noise, no recorded tracks, and the remaining endurance. Indices of
 * icebergs are unchanged. Throws `std::out_of_range` if there is no such UAV.
 */
[[nodiscard]] Scenario presentScene(const ExportSource& source, std::size_t row);

/** Returns the recorded samples of a UAV, none if nothing was recorded. Throws as `TrackPoints`. */
[[nodiscard]] TrackPoints flownTrack(const Mission& mission, std::size_t row);

} // namespace berg
