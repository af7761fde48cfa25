#pragma once

// Private to core/io: one parser for each format of maps, from its text to `FileFeature`s.

#include "core/io/import/fields/file_feature.h"
#include "core/io/import/fields/geojson_places.h"
#include "core/io/import/maps/kml_geometry.h"
#include "core/io/import/maps/kml_styles.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace berg {

/** A feature of GeoJSON with what only a reader of sightings needs. */
struct GeoJsonFeature : FileFeature
{
    const Json* geometry = nullptr; ///< may be null
    GeoJsonSystem system = {};      ///< of the coordinates
    bool isRoute = false;           ///< whether no feature of the file has a point or an area
};

/** Whether a member `crs` counts. */
enum class CrsUse : std::uint8_t
{
    Needed, ///< a system that is not known is a fault
    Ignored ///< coordinates are degrees
};

/**
 * Calls `use` with each feature of a GeoJSON text: those of collections, lists and text sequences
 * (RFC 8142, or an object on each line), nested or not, or a bare geometry. Throws `Error` as
 * `parseJson` and `systemOf`; a broken text of a sequence becomes a broken feature instead.
 */
void readGeoJsonFeatures(std::string_view text, CrsUse crs, ReadBudget& budget,
                         const std::function<void(const GeoJsonFeature&)>& use);

/** A Placemark with what only a reader of sightings needs. */
struct KmlFeature : FileFeature
{
    const KmlGeometry* geometry = nullptr;
};

/** Receives what a KML document holds. */
struct KmlSink
{
    std::function<void(const KmlFeature&)> feature;
    std::function<void(const KmlText&)> link = {}; ///< of a NetworkLink, charged; may be empty
};

/**
 * Reads a KML document and returns its styles, which may follow the features that use them. Throws
 * as `readXml`.
 */
KmlStyles readKmlFeatures(std::string_view text, ReadBudget& budget, const KmlSink& sink);

/** A packet of CZML with what only a reader of sightings needs. */
struct CzmlFeature : FileFeature
{
    const Json* position = nullptr; ///< may be null
};

/** Returns the list of longitude, latitude and height, or of a time before each; may be null. */
[[nodiscard]] const Json* czmlDegrees(const Json* positions);

/**
 * Calls `use` with each packet of a CZML text but its document. Polylines that outline an area of a
 * Bergwatch export are areas. Throws `Error` as `parseJson`, and WrongFormat if it is no list.
 */
void readCzmlFeatures(std::string_view text, ReadBudget& budget,
                      const std::function<void(const CzmlFeature&)>& use);

/** Formats whose features may have areas. */
enum class MapFormat : std::uint8_t
{
    GeoJson,
    Kml,
    Czml
};

/**
 * Returns the document of a KMZ archive, or bytes that are not UTF-8 as UTF-8; empty if the bytes
 * are read as they are. Throws as `unzipped` and `textOfXml`.
 */
[[nodiscard]] std::string textOfMap(std::string_view bytes, ReadBudget& budget);
/** Returns the format of a text, or nullopt if it is none of these. */
[[nodiscard]] std::optional<MapFormat> mapFormatOf(std::string_view text);
/** Returns the unit of `FileFeature::line`, as in `Rejections::place`. */
[[nodiscard]] std::string_view placeIn(MapFormat format);

/**
 * Calls `use` with each feature of a map, whose coordinates are degrees, and returns the styles of
 * the document. Throws as the parser of the format.
 */
KmlStyles readMapFeatures(std::string_view text, MapFormat format, ReadBudget& budget,
                          const std::function<void(const FileFeature&)>& use);

} // namespace berg
