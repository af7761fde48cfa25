#pragma once

// Private to core/io: sightings in GeoJSON (RFC 7946).

#include "core/io/import/import_formats.h"

namespace berg {

/**
 * Features of a FeatureCollection, one Feature or one geometry: Points, the middle of the corners
 * of Polygons, and LineStrings with a time for each corner (`coordinateProperties.times`,
 * `coordTimes` or `times`, as converters of tracks write them). Properties are taken by their
 * names, as columns are; a feature's `id` serves when no property names the iceberg. `line` of a
 * sighting is the number of its feature, from 1. In a file with neither points nor polygons, lines
 * without times are routes: each corner is a place. Of an export of our own the icebergs are taken
 * with their drift, and the UAVs, the area and the asset as the scene; plans and tracks are passed
 * over.
 */
[[nodiscard]] SightingTable readGeoJson(const ImportText& source);
[[nodiscard]] bool isGeoJson(std::string_view text);
/** Whether the text begins as a JSON object. */
[[nodiscard]] bool isJsonObject(std::string_view text);

/**
 * Icebergs seen by radar satellites as MET Norway and Copernicus publish them: GeoJSON with
 * BRGARE (area, m^2) and IA_BLN (largest length, m). Each feature is an iceberg of its own.
 */
[[nodiscard]] bool isMetno(std::string_view text);

} // namespace berg
