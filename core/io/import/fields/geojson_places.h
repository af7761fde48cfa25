#pragma once

// Private to core/io: places of GeoJSON geometries and their coordinate systems.

#include "core/earth/map_projection.h"
#include "core/io/import/fields/file_feature.h"
#include "core/io/import/fields/import_fields.h"
#include "core/io/import/fields/json_members.h"

#include <optional>
#include <string>
#include <vector>

namespace berg {

/** Coordinate system of a file: longitude and latitude, or those of a map projection. */
struct GeoJsonSystem
{
    std::string name; ///< e.g. "EPSG:3413"; empty if the file names no system
    std::optional<Unprojection> unprojected; ///< set if the coordinates are metres
};

/**
 * Returns the system that the member `crs` of an object names, or `outer` if it has none. Throws
 * `Error` InvalidInput with its name if it is neither WGS 84 in degrees nor has an
 * `unprojectionOf`.
 */
[[nodiscard]] GeoJsonSystem systemOf(const Json& object, const GeoJsonSystem& outer,
                                     const std::string& subject);

/**
 * Returns the place of an iceberg at x, y. It is a fault if the numbers are degrees where the
 * system has metres, or the reverse; the range of degrees is checked when the texts are read.
 */
[[nodiscard]] FilePlace filePlace(const Point& position, const GeoJsonSystem& system);

/** Returns the type of an object (may be null); empty if it has none. */
[[nodiscard]] std::string typeOf(const Json* object);
/** Returns x and y of a position, or nullopt if it is not one. */
[[nodiscard]] std::optional<Point> positionOf(const Json& position);

/** Parts of a geometry, including those of nested collections. */
struct GeometryParts
{
    std::vector<const Json*> points;   ///< positions
    std::vector<const Json*> polygons; ///< lists of rings
    std::vector<const Json*> lines;    ///< lists of positions
    std::size_t broken = 0;            ///< number of geometries without coordinates
    std::size_t brokenAreas = 0;       ///< those of them that should be polygons
    std::string other; ///< type of a geometry of another kind; empty if there is none
};
/** Splits a geometry into its parts; null is a broken one. */
[[nodiscard]] GeometryParts geometryParts(const Json* geometry);
/** Returns the rings of a polygon; none if a corner is not a position. */
[[nodiscard]] AreaRings ringsOf(const Json& polygon);

/** Returns true if a geometry (may be null) contains a point or an area. */
[[nodiscard]] bool hasPlaces(const Json* geometry);

/**
 * Returns the JSON texts of a file: a single one, those of a text sequence (RFC 8142), or lines
 * with an object each.
 */
[[nodiscard]] std::vector<std::string_view> jsonTextsOf(std::string_view text);

} // namespace berg
