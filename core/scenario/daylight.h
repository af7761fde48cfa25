#pragma once

#include "core/base/issue.h"
#include "core/base/sun.h"

#include <optional>
#include <vector>

namespace berg {

/** When and where a flight begins and ends. */
struct FlightHours
{
    std::optional<SunTime> takeOff; ///< nullopt: it is aloft already
    SunTime landing;
    LatLon from;
    LatLon to;
};

/** Warnings of UAV number `index` of the scenario if it takes off or lands outside of daylight and
 * civil twilight, with the end of the dark that is nearer to the day. */
[[nodiscard]] std::vector<Issue> daylightIssues(std::size_t index, const FlightHours& flight);

} // namespace berg
