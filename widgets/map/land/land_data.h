#pragma once

#include "core/base/geodesy.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace berg {

/** A point of the outline of land: units east of 180 W and north of the South Pole. */
struct LandPoint
{
    std::int32_t east = 0;
    std::int32_t north = 0;
    bool operator==(const LandPoint&) const = default;
};

/** At least three points; the last one joins the first. Land on the left. */
using LandRing = std::vector<LandPoint>;

/** The land in one cell of longitude and latitude. */
struct LandCell
{
    LandPoint southWest;
    std::vector<LandRing> rings;
};

/**
 * The land of the Earth in cells, as `resources/map/convert_land.py` writes it. What is land has a
 * winding number other than zero round the rings of all cells together.
 */
class LandData
{
public:
    /** Throws `Error` with `subject` when the bytes are not a whole, sound file. */
    LandData(std::span<const std::uint8_t> bytes, const std::string& subject);

    [[nodiscard]] const std::vector<LandCell>& cells() const { return m_cells; }
    [[nodiscard]] LatLon placeOf(const LandPoint& point) const;
    /** Longitudes and latitudes that a cell spans. */
    [[nodiscard]] double cellSide_deg() const;
    /** Whether the edge lies along the border of its cell: no coast, only where the land is cut. */
    [[nodiscard]] bool isCut(const LandPoint& from, const LandPoint& to) const;

private:
    std::int32_t m_unitsPerDegree = 1;
    std::int32_t m_cellSide = 1; ///< units
    std::vector<LandCell> m_cells;
};

enum class LandDetail
{
    Coarse, ///< Natural Earth 1 : 50 million
    Fine    ///< 1 : 10 million
};

/** The data that come with the program, read when first asked for. Any thread. */
[[nodiscard]] const LandData& landData(LandDetail detail);

} // namespace berg
