#pragma once

#include "core/mission/mission.h"

namespace berg {

/** State of a mission at one instant, after any plan made at that instant. */
struct MissionInstant
{
    Simulation simulation;
    PlannerSettings planner;       ///< settings in force, interventions applied
    std::size_t plans = 0;         ///< number of plans made so far
    std::size_t events = 0;        ///< number of events so far
    std::size_t interventions = 0; ///< number of interventions so far
    Metrics metrics;
};

/**
 * Restores the mission at `time_s`, rounded to a step and limited to the time flown. It flies on
 * from the nearest keyframe before with the recorded plans and interventions, so no solver runs,
 * and the state equals that of the flight bit for bit. Throws `std::logic_error` if the mission was
 * flown without a record. Cost: at most the flight between two keyframes, which are farther apart
 * in long flights (`Recorder`).
 */
[[nodiscard]] MissionInstant instantAt(const Mission& mission, double time_s);

} // namespace berg
