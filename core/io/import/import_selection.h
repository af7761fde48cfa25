#pragma once

// Private to core/io: which sightings of a table are taken, from when, and where they are.

#include "core/io/import/import_icebergs.h"

namespace berg {

[[nodiscard]] double secondsBetween(UtcTime from, UtcTime to);

/** Sightings in the area and the time; counts the others. */
[[nodiscard]] std::vector<const Sighting*>
selected(const SightingTable& table, const ImportOptions& options, ImportResult& result);

/** t = 0 of what comes out; none when nobody names a time. */
[[nodiscard]] std::optional<UtcTime> startOf(const Scenario& base,
                                             const std::vector<const Sighting*>& sightings,
                                             const ImportOptions& options);

/** Groups by iceberg, in the order of the file; positions are not set yet. */
[[nodiscard]] std::vector<SightedIceberg> grouped(const std::vector<const Sighting*>& sightings,
                                                  const SightingTable& table,
                                                  std::optional<UtcTime> start,
                                                  const std::stop_token& stop);

/**
 * The place in the middle of the last sightings, as a mean of directions from the earth's centre,
 * to 0.0001 degrees; none when there is no middle.
 */
[[nodiscard]] std::optional<LatLon> middleOf(const std::vector<SightedIceberg>& icebergs);

/** Sets the positions in the plane; what is too far off is rejected. */
void place(std::vector<SightedIceberg>& icebergs, const LocalFrame& frame, Rejections& rejected,
           const std::stop_token& stop);

} // namespace berg
