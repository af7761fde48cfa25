#pragma once

#include "core/plan/policy/plan_reason.h"
#include "core/world/mission_event.h"

#include <utility>

namespace berg {

/**
 * Events of a step for the log, and the reason for which every UAV aloft needs a plan at its end.
 */
struct StepReport
{
    std::vector<MissionEvent> events;      ///< without times; stored until the log collects them
    PlanReason trigger = PlanReason::None; ///< first reason of this step

    /** Appends the event. The first reason other than None becomes the trigger. */
    void add(MissionEvent event, PlanReason reason = PlanReason::None)
    {
        events.push_back(std::move(event));
        if (trigger == PlanReason::None)
            trigger = reason;
    }
};

} // namespace berg
