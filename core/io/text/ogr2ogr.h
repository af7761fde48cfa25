#pragma once

// Private to core/io: GIS files through ogr2ogr of GDAL, a program that may be missing.

#include "core/io/text/child_process.h"

#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** Returns the absolute path of ogr2ogr by the variable PATH; empty if it is not installed. */
[[nodiscard]] std::filesystem::path ogr2ogrPath();

/**
 * Returns true if the first bytes of a file (at least 64 kB, if it is as long) are those of a
 * Shapefile, GeoPackage or FlatGeobuf, which no other reader accepts.
 */
[[nodiscard]] bool hasGisContent(std::string_view head);
/** Returns true if the file name ends as those of GIS formats that ogr2ogr reads; also .zip. */
[[nodiscard]] bool hasGisEnding(std::string_view name);

/**
 * Returns the features of a GIS file as a GeoJSON collection in degrees of WGS 84. A zip archive
 * holds one such file, or several Shapefiles in one folder. Features of a file without a coordinate
 * system keep their coordinates.
 *
 * ogr2ogr runs as a process of its own with limits, a minimal environment and without drivers for
 * networks, databases and files that name other files; it sees the file only under a name that is
 * ours, so that no name can be read as a connection. Throws `Error`: Unsupported without ogr2ogr;
 * FileTooLarge for more output than `readLimit(kLargestFile)`; WrongFormat with the last lines of
 * ogr2ogr if it fails or reports an error; InvalidInput if there is no feature; FileUnreadable if
 * the system refuses the process or a temporary folder. Throws `Stopped` if a stop is requested.
 */
[[nodiscard]] std::string geoJsonOfGisFile(const std::string& path, const std::string& subject,
                                           const std::stop_token& stop = {},
                                           const ChildLimits& limits = {});

/** Formats that ogr2ogr writes. */
enum class GisFormat : std::uint8_t
{
    Shapefile,
    GeoPackage,
    Gml,
    Dxf,
    FlatGeobuf
};

/**
 * Returns the file of a GeoJSON collection. A Shapefile is a zip archive with one Shapefile for
 * each of points, lines and areas, because it holds one type of geometry only. `epsg` is the
 * coordinate system of the file. Throws `Error` as `geoJsonOfGisFile`, with FileUnwritable if
 * ogr2ogr fails, and `Stopped` if a stop is requested in the `StopScope` of this thread.
 */
[[nodiscard]] std::string gisFileOfGeoJson(std::string_view geoJson, GisFormat format, int epsg,
                                           const std::string& subject,
                                           const ChildLimits& limits = {});

} // namespace berg
