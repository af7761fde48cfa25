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

/** Even-odd test; `polygon` holds its corners once, at least three. */
[[nodiscard]] bool insidePolygon(std::span<const Point> polygon, const Point& p);

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
