#pragma once

#include "core/sim/mission_event.h"

#include <functional>
#include <string>
#include <string_view>

namespace berg {

/** How what an event speaks of is written. */
struct EventNames
{
    std::string iceberg;  ///< empty: none
    std::string uav;      ///< empty: of nobody in particular, or there is one UAV
    std::string otherUav; ///< empty: unknown
    std::string distance;
    std::string entry;   ///< time until it is in the ring
    std::string planner; ///< policy and tau in force
};

/**
 * What happened, in a sentence. `said` gives the translation of an English text of context
 * EventText; the names are put in as they are.
 */
[[nodiscard]] std::string eventSentence(const MissionEvent& event, const EventNames& names,
                                        const std::function<std::string(std::string_view)>& said);

} // namespace berg
