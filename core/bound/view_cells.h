#pragma once

#include "core/geometry/geometry.h"

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace berg {

/** The positions of the UAV that have an iceberg in view, as a disk or an upright rectangle. */
struct ViewRegion
{
    Point centre_m = Point::Zero();
    Point half_m = Point::Zero(); ///< Half extents; both are the radius of a disk.
    bool disk = true;

    /** Returns whether the region, edge included, holds the point. */
    [[nodiscard]] bool contains(const Point& p_m) const;
};

/** Speed through air that moves with `wind_mps`. */
struct Travel
{
    double airspeed_mps = 22;
    Point wind_mps = Point::Zero(); ///< Wind, which must be slower than the airspeed.
};

/**
 * The edges of regions, each cut into the same number of cells, and lower bounds on the times of
 * flight between the cells: no flight from any point of one cell to any point of the other is
 * faster.
 */
class ViewCells
{
public:
    /**
     * Cuts at most 16 regions into `perRegion` cells each, a multiple of 4, and calculates all
     * times. A requested stop leaves the object unusable, so callers check the token afterwards.
     */
    ViewCells(std::span<const ViewRegion> regions, int perRegion, const Travel& travel,
              const std::stop_token& stop = {});

    /** Returns the number of regions. */
    [[nodiscard]] int regions() const { return m_regions; }
    /** Returns the number of cells of each region. */
    [[nodiscard]] int perRegion() const { return m_perRegion; }
    /**
     * Returns the set of regions that may share a point with the cell; bit i stands for region i.
     */
    [[nodiscard]] std::uint32_t touching(int region, int cell) const
    {
        return m_touching[index(region, cell)];
    }
    /**
     * Returns the least seconds from this cell to each cell of region `to`, as an array of
     * `perRegion()` entries that lives as long as the object.
     */
    [[nodiscard]] const float* legs_s(int region, int cell, int to) const
    {
        return &m_legs_s[index(region, cell) * m_touching.size() +
                         static_cast<std::size_t>(to) * static_cast<std::size_t>(m_perRegion)];
    }
    /** Returns the least seconds from a point to each cell, ordered by region, then cell. */
    [[nodiscard]] std::vector<float> legsFrom_s(const Point& start_m) const;

private:
    /**
     * A piece of an edge, which lies in the box middle + s along - y outward with |s| <= half and 0
     * <= y <= sag.
     */
    struct Cell
    {
        Point middle_m = Point::Zero();
        Point along = Point::Zero();
        Point outward = Point::Zero();
        double half_m = 0;
        double sag_m = 0;
    };
    [[nodiscard]] std::size_t index(int region, int cell) const
    {
        return static_cast<std::size_t>(region) * static_cast<std::size_t>(m_perRegion) +
               static_cast<std::size_t>(cell);
    }
    void cut(const ViewRegion& region);
    [[nodiscard]] static bool meets(const Cell& cell, const ViewRegion& region);
    [[nodiscard]] float leg_s(const Cell& from, const Cell& to) const;

    int m_regions;
    int m_perRegion;
    Travel m_travel;
    std::vector<Cell> m_cells; ///< Cells, ordered by region.
    std::vector<std::uint32_t> m_touching;
    std::vector<float> m_legs_s; ///< Square matrix with one row for each cell of departure.
};

} // namespace berg
