#pragma once

#include "core/base/geometry.h"

#include <vector>

namespace berg {

/** Counter-clockwise, without corners on its edges. One or two corners where all points are in one
 * place or on one line. Cost: n log n. */
[[nodiscard]] std::vector<Point> convexHull(std::vector<Point> points);

/**
 * Outline round everything that is within `by_m` > 0 of the polygon, counter-clockwise: never less
 * than that, at rounded corners up to 1 % more. One or two corners stand for a point or a line. Of
 * a polygon whose parts grow together, round its hull. Cost: corners squared.
 */
[[nodiscard]] std::vector<Point> grownOutline(std::span<const Point> corners_m, double by_m);

/** Whether the polygons have a point in common. Cost: corners of one times corners of the other,
 * where their boxes overlap. */
[[nodiscard]] bool polygonsMeet(std::span<const Point> a, std::span<const Point> b);

} // namespace berg
