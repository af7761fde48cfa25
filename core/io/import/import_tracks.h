#pragma once

#include "core/io/import/fields/import_table.h"
#include "core/tracking/drift_errors.h"

#include <string>
#include <vector>

namespace berg {

/**
 * Returns the recorded positions of each iceberg of a table, in the order of the file, with times
 * in seconds since 1970 UTC. Sightings without a time, and positions that an iceberg cannot have
 * reached (`consistentFixes`), are left out.
 */
[[nodiscard]] std::vector<PlacedTrack> tracksOf(const SightingTable& table);

/**
 * Reads the tracks of a file of sightings in any import format. If nothing in the file tells which
 * rows are one iceberg, all of them are. Throws what `readFile` and `readSightings` do, and
 * `Error{InvalidInput}` if no sighting has a time.
 */
[[nodiscard]] std::vector<PlacedTrack> loadTracks(const std::string& path);

} // namespace berg
