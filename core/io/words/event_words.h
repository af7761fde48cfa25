#pragma once

#include "core/world/mission_event.h"

#include <functional>
#include <string>
#include <string_view>

namespace berg {

/** Names and quantities of an event as they are written in a sentence. */
struct EventNames
{
    std::string iceberg;  ///< empty if the event has no iceberg
    std::string uav;      ///< empty if the event concerns no single UAV, or if there is only one
    std::string otherUav; ///< empty if unknown
    std::string distance;
    std::string entry;   ///< time until the iceberg enters the inner ring
    std::string planner; ///< policy and tau in force
};

/**
 * Returns a sentence that describes the event. `said` translates an English text of context
 * EventText; the names are filled in unchanged.
 */
[[nodiscard]] std::string eventSentence(const MissionEvent& event, const EventNames& names,
                                        const std::function<std::string(std::string_view)>& said);

} // namespace berg
