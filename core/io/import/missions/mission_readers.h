#pragma once

// Private to core/io: readers of missions and the detection of their formats. The readers throw as
// `readSightingRows`. Each `is...` returns true if the content looks like the format; it may still
// turn out to be broken.

#include "core/io/import/fields/import_source.h"

namespace berg {

/**
 * Reads QGroundControl's JSON: every place to fly to is an iceberg. Survey patterns and other
 * complex items are rejected rows; landing patterns are ignored. `line` of a sighting is the number
 * of its item, from 1. The first inclusion polygon or circle of the geofence is the area,
 * exclusions are no-fly areas; a single rally point is the landing place, the planned home the
 * start of the UAV. Multirotors fly at the hover speed, as VTOLs do in missions without a
 * transition. Also reads missions of versions 1 and 2, which preceded plans. Throws `Error`
 * SyntaxError for broken JSON, WrongFormat for another `fileType`, InvalidInput with the faulty
 * fields, UnsupportedVersion for other versions of the file.
 */
[[nodiscard]] SightingTable readPlan(const ImportText& source);
[[nodiscard]] bool isPlan(std::string_view text);

/**
 * Reads `QGC WPL 110` (the first row is the home) and `120` (no home): rows of twelve columns
 * separated by tabs or blanks. The UAV starts at home. An iceberg has the name that follows a `#`
 * behind its row or fills the line above it. Throws `Error` SyntaxError with the line if a row has
 * another form, also for decimal commas, WrongFormat for another first line and UnsupportedVersion
 * for other versions.
 */
[[nodiscard]] SightingTable readWpl(const ImportText& source);
[[nodiscard]] bool isWpl(std::string_view text);

} // namespace berg
