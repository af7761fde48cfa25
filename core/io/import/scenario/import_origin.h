#pragma once

// Private to core/io: origin of the plane for the sightings of a file.

#include "core/io/import/scenario/import_icebergs.h"

#include <optional>
#include <stop_token>
#include <vector>

namespace berg {

/**
 * Returns the origin for icebergs that belong to no scenario yet, rounded to 0.0001 degrees: the
 * mean of their last places, as directions from the Earth's centre, if none is farther than 500 km
 * from it. Otherwise it is the middle of a dense group, so that as many icebergs as possible are
 * within the plane; a place at 0 N 0 E, which programs write for none, or in an office on land has
 * no effect. A last place that an iceberg cannot have reached from its earlier ones does not count.
 * Returns nullopt without icebergs, and if they have no middle. Throws `Stopped` if a stop is
 * requested. Deterministic. Cost: linear in the sightings.
 */
[[nodiscard]] std::optional<LatLon> originOf(const std::vector<SightedIceberg>& icebergs,
                                             const std::stop_token& stop);

} // namespace berg
