#pragma once

#include "core/geometry/geometry.h"

#include <vector>

namespace berg {

/**
 * Area inside a simple polygon, concave or not, and outside other polygons, its holes, which may
 * overlap each other and the polygon. Without the first polygon it is unbounded. Immutable.
 */
class PolygonArea
{
public:
    /**
     * Takes the corners of the polygon and of the holes in either direction of rotation. An empty
     * `corners_m` makes an unbounded area with holes. Throws `std::logic_error` if a polygon has
     * fewer than three corners.
     */
    PolygonArea(std::vector<Point> corners_m, std::vector<std::vector<Point>> holes_m);

    [[nodiscard]] bool isBounded() const { return m_isBounded; }
    [[nodiscard]] bool hasHoles() const { return m_rings_m.size() > std::size_t{m_isBounded}; }
    /**
     * Returns the polygon, counter-clockwise, if there is one, and then the holes, clockwise: the
     * area is to the left of each edge.
     */
    [[nodiscard]] const std::vector<std::vector<Point>>& rings_m() const { return m_rings_m; }
    /** Returns whether the place is inside the polygon and in no hole. */
    [[nodiscard]] bool contains(const Point& place_m) const;
    [[nodiscard]] bool isInHole(const Point& place_m) const;
    /**
     * Returns the place itself if the area contains it, else the nearest place that is `margin_m`
     * from an edge and that the area contains. Returns the place itself if there is no such place.
     */
    [[nodiscard]] Point nearestInside_m(const Point& place_m, double margin_m) const;
    /** Returns the distance, m, to the nearest edge, from either side. */
    [[nodiscard]] double clearance_m(const Point& place_m) const;
    /**
     * Returns the least distance, m, of the straight line between two places to an edge; 0 if they
     * meet.
     */
    [[nodiscard]] double clearance_m(const Point& from_m, const Point& to_m) const;
    /** Returns the distance, m, to the nearest edge, negative for a place outside the area. */
    [[nodiscard]] double signedClearance_m(const Point& place_m) const;
    /** Returns whether the straight line between two places meets an edge. */
    [[nodiscard]] bool meetsEdge(const Point& a, const Point& b) const;

private:
    std::vector<std::vector<Point>> m_rings_m; ///< see `rings_m`
    bool m_isBounded;                          ///< the first of the rings is the polygon
};

} // namespace berg
