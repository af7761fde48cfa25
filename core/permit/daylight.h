#pragma once

#include "core/base/issue.h"
#include "core/earth/sun.h"

#include <optional>
#include <vector>

namespace berg {

/** Times and places of the start and end of a flight. */
struct FlightHours
{
    std::optional<SunTime> takeOff; ///< nullopt if it is already aloft
    SunTime landing;
    LatLon from;
    LatLon to;
};

/**
 * Returns warnings for UAV number `index` of the scenario if it takes off or lands outside daylight
 * and civil twilight: for take-off with the next time of sufficient light, for landing with the
 * last one before. There is no warning if no such time exists within a year.
 */
[[nodiscard]] std::vector<Issue> daylightIssues(std::size_t index, const FlightHours& flight);

} // namespace berg
