#pragma once

#include "core/world/mission_event.h"

#include <utility>

namespace berg {

/** Why a plan is needed at this instant. */
enum class PlanReason
{
    None,
    /** The run starts. */
    Start,
    TargetReached,
    /** The UAV without a target can fly to an iceberg again. */
    OutOfView,
    Appeared,
    Intervention,
    Sighted, ///< on an aimed leg: an iceberg other than the target came into view
    /** On an aimed leg: the predicted sighting has not come; also an overdue cluster. */
    Overdue,
    Left,        ///< an iceberg has left the area
    Lost,        ///< an iceberg is not where it should be
    Found,       ///< a lost iceberg is in view
    GivenUp,     ///< the search for an iceberg has ended without success
    TakeOff,     ///< the next sortie begins
    HoldFlown,   ///< a planned hold has ended
    SeenByOther, ///< another UAV has the target in view
    Fleet        ///< another UAV needs a plan
};

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
