#pragma once

#include "core/geometry/geometry.h"

#include <vector>

namespace berg {

/**
 * Returns the convex hull, counter-clockwise and without corners on its edges. It has one or two
 * corners if all points coincide or lie on a line. Cost: n log n.
 */
[[nodiscard]] std::vector<Point> convexHull(std::vector<Point> points);

/**
 * Returns a counter-clockwise outline around everything within `by_m` > 0 of the polygon, never
 * closer and up to 1 % farther at rounded corners. One or two corners stand for a point or a line.
 * If parts of the polygon grow together, the outline goes around its hull. It is empty without
 * corners. Cost: quadratic in the corners.
 */
[[nodiscard]] std::vector<Point> grownOutline(std::span<const Point> corners_m, double by_m);

/**
 * Returns true if the polygons have a common point; false if one has fewer than three corners.
 * Cost: the product of their numbers of corners if their boxes overlap.
 */
[[nodiscard]] bool polygonsMeet(std::span<const Point> a, std::span<const Point> b);

} // namespace berg
