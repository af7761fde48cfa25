#pragma once

// Private to core/io: a feature of a map file, as the parser of each format gives it.

#include "core/base/issue.h"
#include "core/io/import/fields/area_centroid.h"
#include "core/io/import/fields/json_members.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

struct GeoJsonSystem;

/** A place of an iceberg, as text. */
struct FilePlace
{
    std::size_t line = 0; ///< 0 for that of the feature
    std::string longitude = {};
    std::string latitude = {};
    std::optional<std::string> time = {}; ///< replaces that of the feature
    std::optional<IssueId> fault = {};    ///< why there is no place
    std::string detail = {};              ///< of the fault
    bool mayHaveCommas = false;           ///< may have decimal commas, but can be read
};

/** Places of icebergs, which are read only where they are needed. */
struct FilePlaces
{
    std::size_t count = 0;
    std::function<FilePlace(std::size_t)> at = {};
    bool areTimed = false;  ///< points that are one track, because each has a time
    bool timesLeft = false; ///< whether there are more times than places
};

enum class ShapeKind : std::uint8_t
{
    Places,
    Line,
    Area,
    Track ///< a line of places with a time each
};

/** A geometry of a feature. */
struct FileShape
{
    ShapeKind kind = ShapeKind::Places;
    std::size_t parts = 1; ///< places; one line; or the outline and holes of an area, 0 if broken
    FilePlaces icebergs = {}; ///< of places, lines and tracks
    /** Returns the places of a part as `placesOf`; empty if they are those of `icebergs`. */
    std::function<std::optional<std::vector<LatLon>>(std::size_t)> readPart = {};
    /** Returns outline and holes in the plane of the file; those of `placesOf` if it is empty. */
    std::function<AreaRings()> rings = {};
};

/** The geometries of a feature; of areas, what only a reader of sightings needs. */
struct FileGeometry
{
    std::vector<FileShape> shapes = {};    ///< in the order in which they are drawn
    std::size_t broken = 0;                ///< number of others, which cannot be read
    std::string other = {};                ///< type of a geometry that holds no iceberg
    bool isRoute = false;                  ///< whether the corners of lines are icebergs
    bool hasIcebergAreas = true;           ///< whether areas are icebergs
    const GeoJsonSystem* system = nullptr; ///< of `rings`; null for degrees
};

/** A feature of a map file, valid while the parser hands it over. */
struct FileFeature
{
    std::size_t line = 0;  ///< or the number of the feature, from 1
    bool isOwn = false;    ///< whether the document is a Bergwatch export
    std::string kind = {}; ///< that of a feature of a Bergwatch export; empty for those of others
    std::string id = {};
    std::string name = {};
    std::string time = {};    ///< of the whole feature; empty if only its properties have one
    std::size_t timeRank = 0; ///< `FieldUse::rank`
    const Json* properties = nullptr; ///< may be null
    std::function<FileGeometry()> geometry = [] { return FileGeometry(); };
    std::optional<std::uint32_t> fill = {}; ///< 0xAARRGGBB of the feature itself
    std::optional<std::uint32_t> stroke = {};
    std::string style = {};  ///< of the document, for colours that the feature does not have itself
    std::string broken = {}; ///< text that is not a feature; nothing else is set then
};

/**
 * Returns the kind of a feature of a Bergwatch export: its property `kind`, or in files of older
 * versions that of `mark` (its style, type or id); empty for features of others.
 */
[[nodiscard]] std::string featureKind(const Json* properties, std::string_view mark);

/** Returns the places of a part of a shape, or nullopt if one of them is not a place. */
[[nodiscard]] std::optional<std::vector<LatLon>> placesOf(const FileShape& shape, std::size_t part);
/** Returns a property as a number, also from a text, or nullopt if it is none. */
[[nodiscard]] std::optional<double> numberIn(const Json* value);
/** Returns a value of JSON in the form of a table cell; empty for null and lists. */
[[nodiscard]] std::string cellText(const Json& value);

} // namespace berg
