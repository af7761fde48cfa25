#pragma once

// Private to core/io: one parser for each format of maps, from its text to `FileFeature`s.

#include "core/io/import/fields/file_feature.h"
#include "core/io/import/fields/geojson_places.h"
#include "core/io/import/maps/kml_geometry.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace berg {

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
                         const std::function<void(const FileFeature&)>& use);

/** Receives what a KML document holds. */
struct KmlSink
{
    std::function<void(const FileFeature&)> feature;
    std::function<void(const KmlText&)> link = {}; ///< of a NetworkLink, charged; may be empty
};

/** Colours of a style, 0xAARRGGBB; nullopt where it has none. */
struct KmlStyle
{
    std::optional<std::uint32_t> fill;
    std::optional<std::uint32_t> stroke;
};
/** The styles of a document by `FileFeature::style`. */
using KmlStyles = std::map<std::string, KmlStyle>;

/**
 * Reads a KML document and returns its styles, which may follow the features that use them. Throws
 * as `readXml`.
 */
KmlStyles readKmlFeatures(std::string_view text, ReadBudget& budget, const KmlSink& sink);

/**
 * Calls `use` with each packet of a CZML text but its document. Polylines that outline an area of a
 * Bergwatch export are areas. Throws `Error` as `parseJson`, and WrongFormat if it is no list.
 */
void readCzmlFeatures(std::string_view text, ReadBudget& budget,
                      const std::function<void(const FileFeature&)>& use);

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

/** Returns the property of an ice chart with this name in capitals or not, or null. */
[[nodiscard]] const Json* chartProperty(const Json* properties, std::string_view name);
/** Returns a code of SIGRID-3, which is a number or a text; nullopt if there is none. */
[[nodiscard]] std::optional<int> chartCode(const Json* properties, std::string_view name);
/** Code of the form `FA` of fast ice. */
inline constexpr int kFastIce = 8;

} // namespace berg
