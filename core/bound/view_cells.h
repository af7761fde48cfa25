#pragma once

#include "core/base/geometry.h"

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace berg {

/** Where the UAV must be for an iceberg to be in view: a disk or an upright rectangle. */
struct ViewRegion
{
    Point centre_m = Point::Zero();
    Point half_m = Point::Zero(); ///< half extents; of a disk both are its radius
    bool disk = true;

    [[nodiscard]] bool contains(const Point& p_m) const;
};

/** How fast one gets about: through air that moves with `wind_mps`. */
struct Travel
{
    double airspeed_mps = 22;
    Point wind_mps = Point::Zero(); ///< slower than the airspeed
};

/**
 * The edges of the regions cut into cells, as many for each, and least times of flight between
 * them: from any point of one cell to any point of the other no flight is faster.
 */
class ViewCells
{
public:
    /**
     * `perRegion` is a multiple of 4. At most 16 regions. A requested stop leaves it unusable: ask
     * the token afterwards.
     */
    ViewCells(std::span<const ViewRegion> regions, int perRegion, const Travel& travel,
              const std::stop_token& stop = {});

    [[nodiscard]] int regions() const { return m_regions; }
    [[nodiscard]] int perRegion() const { return m_perRegion; }
    /** Regions that share a point with the cell: bit i for region i. */
    [[nodiscard]] std::uint32_t touching(int region, int cell) const
    {
        return m_touching[index(region, cell)];
    }
    /** Least seconds from this cell to each cell of region `to`. */
    [[nodiscard]] const float* legs_s(int region, int cell, int to) const
    {
        return &m_legs_s[index(region, cell) * m_touching.size() +
                         static_cast<std::size_t>(to) * static_cast<std::size_t>(m_perRegion)];
    }
    /** Least seconds from a point to each cell, by region, then cell. */
    [[nodiscard]] std::vector<float> legsFrom_s(const Point& start_m) const;

private:
    /** Lies in the box middle + s along - y outward, |s| <= half, 0 <= y <= sag. */
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
    std::vector<Cell> m_cells; ///< by region, then cell
    std::vector<std::uint32_t> m_touching;
    std::vector<float> m_legs_s; ///< cells x cells, row = from
};

} // namespace berg
