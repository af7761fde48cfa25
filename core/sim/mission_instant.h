#pragma once

#include "core/sim/mission.h"

namespace berg {

/** A mission as it was at one instant, after the plan that was made there if one was. */
struct MissionInstant
{
    Simulation simulation;
    PlannerSettings planner;       ///< in force, interventions applied
    std::size_t plans = 0;         ///< so many of the mission's plans had been made,
    std::size_t events = 0;        ///< events had come
    std::size_t interventions = 0; ///< and interventions
    Metrics metrics;
};

/**
 * The instant at `time_s`, rounded to a step and kept inside what was flown: the nearest keyframe
 * before, flown on with the plans on record, so no solver runs. Its state equals that of the
 * flight bit for bit. Cost: a keyframe interval of flight at most, which is longer in long flights
 * (`Recorder`).
 */
[[nodiscard]] MissionInstant instantAt(const Mission& mission, double time_s);

} // namespace berg
