#pragma once

#include "core/sim/mission_event.h"

#include <utility>

namespace berg {

/** Why a plan is needed at this instant. */
enum class PlanReason
{
    None,
    Start,
    TargetReached,
    OutOfView,
    Appeared,
    Intervention,
    Sighted,     ///< on a leg with an aim: another iceberg than the target came into view
    Overdue,     ///< on such a leg: the sighting predicted has not come
    Left,        ///< an iceberg has left the area
    Lost,        ///< one was not where it should have been
    Found,       ///< a lost one is in view
    GivenUp,     ///< the search for one has ended without it
    TakeOff,     ///< the next sortie begins
    HoldFlown,   ///< a hold has come to its end
    SeenByOther, ///< another UAV has the target in view
    Fleet        ///< another UAV needs one
};

/** What has happened: for the log, and whether every UAV aloft needs a plan at the end of the step.
 */
struct StepReport
{
    std::vector<MissionEvent> events;      ///< without times; kept until the log takes them
    PlanReason trigger = PlanReason::None; ///< of this step: the first there was

    void add(MissionEvent event, PlanReason reason = PlanReason::None)
    {
        events.push_back(std::move(event));
        if (trigger == PlanReason::None)
            trigger = reason;
    }
};

} // namespace berg
