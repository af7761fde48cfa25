#pragma once

// Private to core/io: selects the sightings of a table that are used, their start and positions.

#include "core/io/import/scenario/import_icebergs.h"

namespace berg {

/** Returns the seconds from one instant to another, negative if `to` is earlier. */
[[nodiscard]] double secondsBetween(UtcTime from, UtcTime to);

/** Returns the sightings in the area and the time; counts and lists the others. */
[[nodiscard]] std::vector<const Sighting*>
selected(const SightingTable& table, const ImportOptions& options, ImportResult& result);

/** Removes the sightings after `at`; counts and lists them. */
void leaveOutLater(std::vector<const Sighting*>& sightings, UtcTime at, ImportResult& result);

/** Returns the instant t = 0 of the result, or nullopt if no time is known. */
[[nodiscard]] std::optional<UtcTime> startOf(const Scenario& base,
                                             const std::vector<const Sighting*>& sightings,
                                             const ImportOptions& options);

/**
 * Groups sightings by iceberg, in the order of the file; positions are not set yet. Throws
 * `Error{FileTooLarge}` for more than 50,000 icebergs (`readLimit`), and `Stopped`.
 */
[[nodiscard]] std::vector<SightedIceberg> grouped(const std::vector<const Sighting*>& sightings,
                                                  const SightingTable& table,
                                                  std::optional<UtcTime> start,
                                                  const std::stop_token& stop);

/**
 * Rejects the sightings without a time of icebergs that have sightings with one, because it is
 * unknown when the iceberg was there.
 */
void leaveOutUntimed(std::vector<SightedIceberg>& icebergs, Rejections& rejected);

/**
 * Sets the positions in the plane, in metres. Sightings too far away are rejected and counted, and
 * icebergs that are left without any are removed. Throws `Stopped` if a stop is requested.
 */
void place(std::vector<SightedIceberg>& icebergs, const LocalFrame& frame, ImportResult& result,
           const std::stop_token& stop);

} // namespace berg
