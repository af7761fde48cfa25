#pragma once

// Private to core/io: a feature of a map file, as the parser of each format gives it.

#include "core/io/import/fields/json_members.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** A geometry of a feature, whose places are read only where they are needed. */
struct FileShape
{
    enum class Kind : std::uint8_t
    {
        Places,
        Line,
        Area
    };
    Kind kind = Kind::Places;
    std::size_t parts = 1; ///< places; one line; or the outline and holes of an area, 0 if broken
    /** Returns the places of a part, or nullopt if one of them is not a place. */
    std::function<std::optional<std::vector<LatLon>>(std::size_t)> placesOf;
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
    /** Returns the geometries in the order in which they are drawn. */
    std::function<std::vector<FileShape>()> shapes = [] { return std::vector<FileShape>(); };
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

/** Returns a property as a number, also from a text, or nullopt if it is none. */
[[nodiscard]] std::optional<double> numberIn(const Json* value);
/** Returns a value of JSON in the form of a table cell; empty for null and lists. */
[[nodiscard]] std::string cellText(const Json& value);

} // namespace berg
