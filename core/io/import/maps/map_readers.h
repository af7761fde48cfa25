#pragma once

// Private to core/io: readers of maps and the detection of their formats. The readers throw as
// `readSightingRows`. From a Bergwatch export they read the icebergs with their drift, and UAVs,
// area, no-fly areas and asset as the scene; other features are ignored. Each `is...` returns true
// if the content looks like the format; it may still turn out to be broken.

#include "core/io/import/fields/import_source.h"

namespace berg {

/**
 * Reads KML, or every document of a KMZ archive (`KmzDocuments`). A Placemark is at its Points or
 * Models, at the centroids of its Polygons if it has none, or on its gx:Tracks with a sighting for
 * each `when`. Several places of one Placemark are an iceberg each; `separateSharedIds` decides how
 * many icebergs tracks of one name are. The time is that of TimeStamp or TimeSpan (its begin, else
 * its end) of the Placemark, else of the folder or document around it. An iceberg's id is that of
 * ExtendedData, else the Placemark's name, else its id. Rejected rows: Placemarks of any other
 * shape, places that may have decimal commas, links out of the archive.
 */
[[nodiscard]] SightingTable readKml(const ImportText& source);
[[nodiscard]] bool isKml(std::string_view text);

/**
 * Reads GPX 1.0 and 1.1: waypoints, points of routes (whose times do not say when an iceberg was
 * seen) and points of tracks with their times; the iceberg is the name of the point or the track.
 * All segments of a track are one track; `separateSharedIds` decides how many icebergs tracks of
 * one name are. Speed and course of a point are not used, because the track is more informative.
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
 * `separateSharedIds`. `line` of a sighting is the number of its feature, from 1.
 */
[[nodiscard]] SightingTable readGeoJson(const ImportText& source);
[[nodiscard]] bool isGeoJson(std::string_view text);

/**
 * Returns true if the text is GeoJSON of icebergs seen by radar satellites, as MET Norway and
 * Copernicus publish it, with BRGARE (area, m^2) or IA_BLN (largest length, m). Each feature is an
 * iceberg of its own.
 */
[[nodiscard]] bool isMetno(std::string_view text);

/**
 * Reads CZML: packets with a place, and moving packets with one sighting for each sample. The
 * iceberg is the packet's name, else its id; a sighting's line is the number of its packet, from 1.
 */
[[nodiscard]] SightingTable readCzml(const ImportText& source);
[[nodiscard]] bool isCzml(std::string_view text);

} // namespace berg
