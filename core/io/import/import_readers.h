#pragma once

// Private to core/io: the readers of sightings, and what their files are told by.

#include "core/io/import/import_formats.h"

namespace berg {

/** Any table with a header: columns by their names, or as mapped. */
[[nodiscard]] SightingTable readAnyCsv(const ImportText& source);
[[nodiscard]] bool isAnyCsv(std::string_view text);

/**
 * IIP sightings, NSIDC G00807: season, number, date, time, latitude, longitude, method, size,
 * shape, source, by position because the header's words vary; with or without header. An iceberg's
 * id is `season-number`; the time is HHMM without leading zeros; a date must lie in the season,
 * October of the year before to September, give or take a month.
 */
[[nodiscard]] SightingTable readIip(const ImportText& source);
[[nodiscard]] bool isIip(std::string_view text);

/** Standardised beacons of the Canadian Ice Service: beacon_id, datetime_data, position. */
[[nodiscard]] SightingTable readCisBeacon(const ImportText& source);
[[nodiscard]] bool isCisBeacon(std::string_view text);

/** Antarctic list of the US National Ice Center; "grounded" among the remarks is kept. */
[[nodiscard]] SightingTable readUsnic(const ImportText& source);
[[nodiscard]] bool isUsnic(std::string_view text);

/**
 * KML: Placemarks with a Point (time from TimeStamp or TimeSpan) and gx:Tracks with one sighting
 * for each `when`. An iceberg's id is that of ExtendedData, else the Placemark's name, else its id.
 * Placemarks of any other shape are rejected rows. Of an export of our own the icebergs are taken
 * with their drift, and area, asset and UAVs as the scene; visits are
 * passed over.
 */
[[nodiscard]] SightingTable readKml(const ImportText& source);
[[nodiscard]] bool isKml(std::string_view text);

/**
 * GPX: waypoints, points of routes (whose times say nothing of when an iceberg was seen) and points
 * of tracks with their times; the iceberg is the name of the point or the track. Of an export of
 * our own the icebergs are taken with their drift, and asset and UAVs as the scene; routes and
 * tracks are passed over.
 */
[[nodiscard]] SightingTable readGpx(const ImportText& source);
[[nodiscard]] bool isGpx(std::string_view text);

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

/**
 * CZML: packets with a place, and those that move with one sighting for each sample. The iceberg is
 * the packet's name, else its id; a sighting's line is the number of its packet, from 1. Of an
 * export of our own the icebergs are taken with their drift, and area, asset and UAVs as the scene;
 * ways are passed over.
 */
[[nodiscard]] SightingTable readCzml(const ImportText& source);
[[nodiscard]] bool isCzml(std::string_view text);

/**
 * QGroundControl's JSON: every place to fly to is an iceberg. Survey patterns and other complex
 * items are rejected rows; landing patterns are passed over. `line` of a sighting is the number of
 * its item, from 1. The polygon of the geofence is the area, a single rally point the place to
 * land, the planned home where the UAV starts. Throws `Error` InvalidInput that names the field of
 * what is no such mission, UnsupportedVersion for other versions of the file.
 */
[[nodiscard]] SightingTable readPlan(const ImportText& source);
[[nodiscard]] bool isPlan(std::string_view text);

/**
 * `QGC WPL 110` (the first row is the home) and `120` (no home): rows of twelve columns set apart
 * by tabs or blanks. The UAV starts at home. An iceberg has the name that follows a `#` behind its
 * row or fills the line above it. Throws `Error` SyntaxError with the line where a row is not of
 * that kind, also for decimal commas.
 */
[[nodiscard]] SightingTable readWpl(const ImportText& source);
[[nodiscard]] bool isWpl(std::string_view text);

} // namespace berg
