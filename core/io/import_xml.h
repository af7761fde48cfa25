#pragma once

// Private to core/io: sightings in XML.

#include "core/io/import_formats.h"

namespace berg {

/**
 * KML: Placemarks with a Point (time from TimeStamp or TimeSpan) and gx:Tracks with one sighting
 * for each `when`. An iceberg's id is that of ExtendedData, else the Placemark's name, else its id.
 * Placemarks of any other shape are rejected rows. Of an export of our own the icebergs are taken
 * with their drift, and the home of the first aircraft; its plan, track, area and asset are not.
 */
[[nodiscard]] SightingTable readKml(const ImportText& source);
[[nodiscard]] bool isKml(std::string_view text);

/**
 * GPX: waypoints, points of routes (whose times say nothing of when an iceberg was seen) and points
 * of tracks with their times; the iceberg is the name of the point or the track. Of an export of
 * our own the icebergs are taken with their drift, and where the first aircraft starts and lands;
 * its plan, track and asset are not.
 */
[[nodiscard]] SightingTable readGpx(const ImportText& source);
[[nodiscard]] bool isGpx(std::string_view text);

} // namespace berg
