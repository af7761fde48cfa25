#pragma once

#include "core/earth/geodesy.h"

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** A shape drawn by a file of a map program. */
struct MapShape
{
    enum class Kind : std::uint8_t
    {
        Place,
        Line,
        Polygon
    };
    Kind kind = Kind::Line;
    std::vector<std::vector<LatLon>> parts; ///< one place; one line; or outer and inner rings
    std::string name;                       ///< name of a place; may be empty
    std::optional<std::uint32_t> fill;      ///< 0xAARRGGBB; nullopt if the file gives no colour
    std::optional<std::uint32_t> line;      ///< 0xAARRGGBB; nullopt if the file gives no colour
    bool operator==(const MapShape&) const = default;
};

/**
 * Reads places, lines and polygons of GeoJSON, KML, KMZ and CZML. Colours are those of the file:
 * KML styles, `fill` and `stroke` of simplestyle, solid materials of CZML; polygons of an ice chart
 * (`CT` and `FA` of SIGRID-3) have the WMO colours of the total concentration. Shapes with an
 * invalid place are left out.
 * Throws `Error`: FileTooLarge (`ReadBudget`); WrongFormat for any other format; SyntaxError for
 * broken JSON or XML; `Stopped` if a stop is requested. Cost: linear.
 */
[[nodiscard]] std::vector<MapShape>
readMapShapes(std::string_view bytes, const std::string& subject, const std::stop_token& stop = {});

} // namespace berg
