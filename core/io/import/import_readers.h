#pragma once

// Private to core/io: readers of sightings and the detection of their formats. The readers throw as
// `readSightingRows`. Each `is...` returns true if the content looks like the format; it may still
// turn out to be broken.

#include "core/io/import/import_formats.h"

namespace berg {

/** Reads any table with a header, with columns by their names or as mapped. */
[[nodiscard]] SightingTable readAnyCsv(const ImportText& source);
[[nodiscard]] bool isAnyCsv(std::string_view text);

/**
 * Reads IIP sightings, NSIDC G00807: season, number, date, time, latitude, longitude, method, size,
 * shape, source, by position because the words of the header vary; with or without header. An
 * iceberg's id is `season-number`; the time is HHMM without leading zeros; a date must lie in the
 * season, October of the previous year to September, with a margin of a month.
 */
[[nodiscard]] SightingTable readIip(const ImportText& source);
[[nodiscard]] bool isIip(std::string_view text);

/** Reads standardised beacons of the Canadian Ice Service: beacon_id, datetime_data, position. */
[[nodiscard]] SightingTable readCisBeacon(const ImportText& source);
[[nodiscard]] bool isCisBeacon(std::string_view text);

/**
 * Reads the Antarctic list of the US National Ice Center, including "grounded" among the remarks.
 */
[[nodiscard]] SightingTable readUsnic(const ImportText& source);
[[nodiscard]] bool isUsnic(std::string_view text);

/**
 * Reads KML, or every document of a KMZ archive (`KmzDocuments`). A Placemark is at its Points or
 * Models, at the centroids of its Polygons if it has none, or on its gx:Tracks with a sighting for
 * each `when`. Several places of one Placemark are an iceberg each; `separateSharedIds` decides how
 * many icebergs tracks of one name are. The time is that of TimeStamp or TimeSpan (its begin, else
 * its end) of the Placemark, else of the folder or document around it. An iceberg's id is that of
 * ExtendedData, else the Placemark's name, else its id. Rejected rows: Placemarks of any other
 * shape, places that may have decimal commas, links out of the archive. From a Bergwatch export the
 * icebergs are read with their drift, and area, asset and UAVs as the scene; visits are ignored.
 */
[[nodiscard]] SightingTable readKml(const ImportText& source);
[[nodiscard]] bool isKml(std::string_view text);

/**
 * Reads GPX 1.0 and 1.1: waypoints, points of routes (whose times do not say when an iceberg was
 * seen) and points of tracks with their times; the iceberg is the name of the point or the track.
 * All segments of a track are one track; `separateSharedIds` decides how many icebergs tracks of
 * one name are. Speed and course of a point are not used, because the track is more informative.
 * From a Bergwatch export the icebergs are read with their drift, and asset and UAVs as the scene;
 * routes and tracks are ignored.
 */
[[nodiscard]] SightingTable readGpx(const ImportText& source);
[[nodiscard]] bool isGpx(std::string_view text);

/**
 * Reads GeoJSON: features of collections, lists and text sequences (RFC 8142, or an object on each
 * line), nested or not, or bare geometries. A feature is at its points, at the centroids of its
 * polygons if it has none, or on its lines if the properties have a time for each corner
 * (`coordinateProperties.times`, `coordTimes` or `times`, as converters of tracks write them).
 * Several places of one feature are an iceberg each, since an iceberg is never at two places at
 * once; places with a time each are a track. In a file with neither points nor polygons, lines
 * without times are routes: each corner is a place.
 *
 * Coordinates are degrees of WGS 84, or metres if a `crs` names a projection (`systemOf`).
 * Properties are read by their names, as columns are; for ids see `FeatureIds` and
 * `separateSharedIds`. `line` of a sighting is the number of its feature, from 1. From a Bergwatch
 * export the icebergs are read with their drift, and the UAVs, the area and the asset as the scene;
 * plans and tracks are ignored.
 */
[[nodiscard]] SightingTable readGeoJson(const ImportText& source);
[[nodiscard]] bool isGeoJson(std::string_view text);
/** Returns true if the text begins as JSON with an object: { is among its first 16 bytes. */
[[nodiscard]] bool isJsonObject(std::string_view text);

/**
 * Returns true if the text is GeoJSON of icebergs seen by radar satellites, as MET Norway and
 * Copernicus publish it, with BRGARE (area, m^2) or IA_BLN (largest length, m). Each feature is an
 * iceberg of its own.
 */
[[nodiscard]] bool isMetno(std::string_view text);

/**
 * Reads CZML: packets with a place, and moving packets with one sighting for each sample. The
 * iceberg is the packet's name, else its id; a sighting's line is the number of its packet, from 1.
 * From a Bergwatch export the icebergs are read with their drift, and area, asset and UAVs as the
 * scene; paths are ignored.
 */
[[nodiscard]] SightingTable readCzml(const ImportText& source);
[[nodiscard]] bool isCzml(std::string_view text);

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
