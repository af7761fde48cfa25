#pragma once

#include "core/earth/geodesy.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace berg {

/** A point of the outline of land, in units east of 180 W and north of the South Pole. */
struct LandPoint
{
    std::int32_t east = 0;
    std::int32_t north = 0;
    bool operator==(const LandPoint&) const = default;
};

/** Closed outline of at least three points; the last joins the first. Land is on the left. */
using LandRing = std::vector<LandPoint>;

/** The land in one cell of longitude and latitude. */
struct LandCell
{
    LandPoint southWest;
    std::vector<LandRing> rings;
};

/**
 * The land of the Earth in cells, as written by `resources/map/convert_land.py`. A place is on land
 * if the rings of all cells together have a winding number other than zero around it.
 */
class LandData
{
public:
    /** Throws `Error` with `subject` if the bytes are not a complete, valid file. */
    LandData(std::span<const std::uint8_t> bytes, const std::string& subject);

    [[nodiscard]] const std::vector<LandCell>& cells() const { return m_cells; }
    /** Returns the place on the Earth. */
    [[nodiscard]] LatLon placeOf(const LandPoint& point) const;
    /** Returns the span of a cell in longitude and latitude, degrees. */
    [[nodiscard]] double cellSide_deg() const;
    /**
     * Returns true if the edge lies on the border of its cell, where land is cut and there is no
     * coast.
     */
    [[nodiscard]] bool isCut(const LandPoint& from, const LandPoint& to) const;
    /**
     * Returns true if there is land at the place; any multiple of 360 degrees may be added to the
     * longitude. Cost: linear in the points of its cell.
     */
    [[nodiscard]] bool contains(const LatLon& place) const;

private:
    std::int32_t m_unitsPerDegree = 1;
    std::int32_t m_cellSide = 1; ///< units
    std::vector<LandCell> m_cells;
};

/** Scale of the land data. */
enum class LandDetail
{
    Coarse, ///< Natural Earth 1 : 50 million
    Fine    ///< Natural Earth 1 : 10 million
};

/**
 * Returns the data included in the program, read at the first call. May be called from any thread.
 */
[[nodiscard]] const LandData& landData(LandDetail detail);

/**
 * Returns true if there is land at the place by the finest data, whose coast is accurate to about a
 * kilometre.
 */
[[nodiscard]] bool isOnLand(const LatLon& place);

} // namespace berg
