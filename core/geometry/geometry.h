#pragma once

#include <Eigen/Core>

#include <span>

namespace berg {

/** Point or vector in a plane; map points are east, north in metres. */
using Point = Eigen::Vector2d;

/** Returns the z component of the cross product, positive if `b` points to the left of `a`. */
[[nodiscard]] inline double cross(const Point& a, const Point& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/** Returns the vector turned counter-clockwise. */
[[nodiscard]] Point turned(const Point& vector, double angle_rad);

/**
 * Returns true if `p` is inside the polygon (even-odd rule). `polygon` lists at least three
 * corners, each once.
 */
[[nodiscard]] bool insidePolygon(std::span<const Point> polygon, const Point& p);

/** Returns true if the segments from `a` to `b` and from `c` to `d` have a common point. */
[[nodiscard]] bool segmentsMeet(const Point& a, const Point& b, const Point& c, const Point& d);

/** Returns the point of the segment from `a` to `b` that is nearest to `p`. */
[[nodiscard]] Point nearestOnSegment(const Point& a, const Point& b, const Point& p);

/** Returns the distance from `p` to the nearest point of the segment from `a` to `b`. */
[[nodiscard]] double distanceToSegment(const Point& a, const Point& b, const Point& p);

/** Returns the distance from `p`, inside or outside, to the nearest edge of the closed polygon. */
[[nodiscard]] double distanceToEdges(std::span<const Point> polygon, const Point& p);

/** Returns the distance from the segment `a` to `b` to the nearest edge, or 0 if they meet. */
[[nodiscard]] double distanceToEdges(std::span<const Point> polygon, const Point& a,
                                     const Point& b);

/**
 * Returns true if the closed polygon has at least three corners and neither touches nor crosses
 * itself. Cost: quadratic at worst
 * in the number of corners.
 */
[[nodiscard]] bool isSimplePolygon(std::span<const Point> polygon);

/**
 * Returns true if the edge from the end of an open path to `next` meets the path nowhere else and
 * does not fold back on its last edge. `path` has at least one corner. Cost: linear.
 */
[[nodiscard]] bool isClearEdge(std::span<const Point> path, const Point& next);

/** Returns the area of the polygon, positive if the corners run counter-clockwise. */
[[nodiscard]] double signedArea(std::span<const Point> polygon);

} // namespace berg
