#pragma once

// Private to core/io: sightings in XML.

#include "core/io/import_formats.h"

namespace berg {

/**
 * KML: Placemarks with a Point (time from TimeStamp or TimeSpan) and gx:Tracks with one sighting
 * for each `when`. An iceberg's id is that of ExtendedData, else the Placemark's name, else its id.
 * Placemarks of any other shape are rejected rows.
 */
[[nodiscard]] SightingTable readKml(const ImportText& source);
[[nodiscard]] bool isKml(std::string_view text);

/** GPX: waypoints and points of tracks with their times; the iceberg is the name of either. */
[[nodiscard]] SightingTable readGpx(const ImportText& source);
[[nodiscard]] bool isGpx(std::string_view text);

} // namespace berg
