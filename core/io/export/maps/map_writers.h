#pragma once

#include "core/io/export/content/export_content.h"
#include "core/io/text/text_sink.h"

namespace berg {

// Writers of map formats. Each writes every feature of `mapFeatures` with its kind and properties,
// and throws as `TrackPoints`. Dates need a start time of the scenario.

/**
 * Writes an RFC 7946 FeatureCollection. Lines have `coordinateProperties` with `times` (ISO 8601)
 * if the scenario has a start time, else `times_s`, one per position. Positions are longitude,
 * latitude; altitudes are properties. A home at the start of its UAV is left out.
 */
void writeGeoJson(const ExportContent& content, const TextSink& put);

/** Properties of features for programs that hold only numbers and texts. */
enum class FlatProperties
{
    Values, ///< those of `flatProperties`
    Layer   ///< the kind alone, as property `Layer`
};
/** Writes GeoJSON as `writeGeoJson`, but without times of positions and with flat properties. */
void writeFlatGeoJson(const ExportContent& content, FlatProperties properties, const TextSink& put);

// Writers through ogr2ogr. They throw as `gisFileOfGeoJson`.

/** Writes a zip archive of Shapefiles of points, lines and areas. */
void writeShapefiles(const ExportContent& content, const TextSink& put);
/** Writes a GeoPackage with one layer. */
void writeGeoPackage(const ExportContent& content, const TextSink& put);
/** Writes GML 3.2 without a schema. */
void writeGml(const ExportContent& content, const TextSink& put);
/**
 * Writes a DXF drawing in metres of UTM (`utmEpsg`) whose layers are the kinds of features, without
 * names and properties.
 */
void writeDxf(const ExportContent& content, const TextSink& put);
/** Writes a FlatGeobuf with one layer. */
void writeFlatGeobuf(const ExportContent& content, const TextSink& put);
/**
 * Returns the EPSG code of the projection in metres around a place: the UTM zone of WGS 84, or UPS
 * in the polar caps.
 */
[[nodiscard]] int utmEpsg(const LatLon& place);

/**
 * Writes KML 2.2 with folders for the icebergs, each UAV, airspace and the operation volume. A path
 * or track is a `gx:Track` with times if the scenario has a start time, else a line. Lines and
 * areas are cut at the antimeridian. The style of a feature is named after its kind.
 */
void writeKml(const ExportContent& content, const TextSink& put);

/** Writes the KML as `doc.kml` in a zip archive. Throws as `writeZip`. */
void writeKmz(const ExportContent& content, const TextSink& put);

/**
 * Writes GPX 1.1: a waypoint for each iceberg, home and the asset (distinguished by `type`), a
 * route with the future visits of each UAV, and a track for each path or flown track, in segments
 * that do not cross the antimeridian. Areas are left out. Properties are in `extensions`, in
 * Bergwatch's own namespace.
 */
void writeGpx(const ExportContent& content, const TextSink& put);

/**
 * Writes CZML 1.0 for Cesium: a packet for each feature. A UAV moves along its path if the scenario
 * has a start time; otherwise its path is a line.
 */
void writeCzml(const ExportContent& content, const TextSink& put);

} // namespace berg
