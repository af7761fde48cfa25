#pragma once

#include <Eigen/Core>

#include <span>

namespace berg {

using Point = Eigen::Vector2d;

/** z component of the cross product: positive when `b` points to the left of `a`. */
[[nodiscard]] inline double cross(const Point& a, const Point& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/** Counter-clockwise. */
[[nodiscard]] Point turned(const Point& vector, double angle_rad);

/** Even-odd test; `polygon` holds its corners once, at least three. */
[[nodiscard]] bool insidePolygon(std::span<const Point> polygon, const Point& p);

/** Whether the segments from `a` to `b` and from `c` to `d` have a point in common. */
[[nodiscard]] bool segmentsMeet(const Point& a, const Point& b, const Point& c, const Point& d);

/** Of the segment from `a` to `b`, the point nearest to `p`. */
[[nodiscard]] Point nearestOnSegment(const Point& a, const Point& b, const Point& p);

/** Distance from `p` to the nearest point of the segment from `a` to `b`. */
[[nodiscard]] double distanceToSegment(const Point& a, const Point& b, const Point& p);

/** Distance from `p` to the nearest edge of the closed polygon, from either side. */
[[nodiscard]] double distanceToEdges(std::span<const Point> polygon, const Point& p);

/** Distance between the segment from `a` to `b` and the nearest edge; 0 when they meet. */
[[nodiscard]] double distanceToEdges(std::span<const Point> polygon, const Point& a,
                                     const Point& b);

/** True when the closed polygon neither touches nor crosses itself. Cost: corners squared. */
[[nodiscard]] bool isSimplePolygon(std::span<const Point> polygon);

/**
 * True when the edge from the end of an open path to `next` meets the path nowhere else and does
 * not fold back on its last edge. `path` holds at least one corner. Cost: corners.
 */
[[nodiscard]] bool isClearEdge(std::span<const Point> path, const Point& next);

/** Signed area, positive when the corners run counter-clockwise. */
[[nodiscard]] double signedArea(std::span<const Point> polygon);

} // namespace berg
