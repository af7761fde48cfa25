#pragma once

#include "core/base/geodesy.h"

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** Something that a file of a map program draws. */
struct MapShape
{
    enum class Kind : std::uint8_t
    {
        Place,
        Line,
        Polygon
    };
    Kind kind = Kind::Line;
    std::vector<std::vector<LatLon>> parts; ///< one place; one line; outer and inner rings
    std::string name;                       ///< of a place; may be empty
    std::optional<std::uint32_t> fill;      ///< 0xAARRGGBB; none: the file tells no colour
    std::optional<std::uint32_t> line;      ///< likewise
    bool operator==(const MapShape&) const = default;
};

/**
 * Places, lines and polygons of GeoJSON, KML and KMZ. Colours are those of the file: KML styles,
 * `fill` and `stroke` of simplestyle; polygons of an ice chart (`CT` and `FA` of SIGRID-3) have the
 * colours of the WMO for the total concentration. Shapes with a place that is none on the Earth are
 * left out. Throws `Error`: FileTooLarge (`ReadBudget`); WrongFormat for what is none of these;
 * SyntaxError for broken JSON or XML; `Stopped` when asked to stop. Cost: linear.
 */
[[nodiscard]] std::vector<MapShape>
readMapShapes(std::string_view bytes, const std::string& subject, const std::stop_token& stop = {});

} // namespace berg
