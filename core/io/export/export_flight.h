#pragma once

#include "core/io/export/export_content.h"
#include "core/sim/flyable_path.h"

#include <vector>

namespace berg {

// The one place that knows how plans and recordings hold the UAVs of a fleet.

/** The plan that the mission began with, as far as exports read it; nothing is solved again. */
[[nodiscard]] PlanAnswer startPlan(const Mission& mission);

/** What UAV `row` of the scenario is to fly from now on. */
[[nodiscard]] UavOrder presentOrder(const ExportSource& source, std::size_t row);

/**
 * What is known now as a scenario that starts now, with that UAV alone: estimates in place of
 * icebergs, no noise, no recorded tracks, the endurance that is left. Indices of icebergs stay.
 */
[[nodiscard]] Scenario presentScene(const ExportSource& source, std::size_t row);

/** Samples on record; empty when the mission kept none. */
[[nodiscard]] TrackPoints flownTrack(const Mission& mission, std::size_t row);

} // namespace berg
