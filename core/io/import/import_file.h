#pragma once

#include <stop_token>
#include <string>

namespace berg {

/**
 * Returns the bytes of a file for import. A file that only GIS programs read (Shapefile, also
 * zipped, GeoPackage, GML, DXF, FlatGeobuf, MapInfo, ...) becomes GeoJSON by ogr2ogr; its content
 * or its ending decides, and only if none of our own formats matches. Throws as `readFile`, and for
 * such files as `geoJsonOfGisFile`.
 */
[[nodiscard]] std::string readImportFile(const std::string& path, const std::string& subject,
                                         const std::stop_token& stop = {});

/** Returns true if `readImportFile` converts files with this ending. */
[[nodiscard]] bool isGisFileName(const std::string& name);

} // namespace berg
