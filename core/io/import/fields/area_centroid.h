#pragma once

// Private to core/io: position of an iceberg that a file draws as an outline.

#include "core/geometry/geometry.h"

#include <optional>
#include <span>
#include <vector>

namespace berg {

/** Corners of a ring in the plane of the file (x, y), closed or not. */
using AreaRing = std::vector<Point>;
/** An outline and its holes. */
using AreaRings = std::vector<AreaRing>;

/** A full turn of x if it is a longitude in degrees. */
inline constexpr double kTurn_deg = 360;

/**
 * Returns the centroid of the area of a polygon without its holes; sides are straight in the plane
 * of the file, as in RFC 7946. `turn` is `kTurn_deg` if x is a longitude, so that outlines may
 * cross the antimeridian, and 0 if it is a length. An outline without area, or one that crosses
 * itself so that its centroid would lie outside its box, gives the mean of its corners. Returns
 * nullopt for less than three corners and for an outline around a pole.
 */
[[nodiscard]] std::optional<Point> centroidOf(const AreaRings& polygon, double turn);

/**
 * Returns the centroids of polygons, in their order; `centroidOf` must return a place for each. Two
 * polygons that were one before it was cut at the antimeridian (RFC 7946, section 3.1.9) have one
 * centroid, unless more than 1000 polygons touch the antimeridian.
 */
[[nodiscard]] std::vector<Point> centroidsOf(std::span<const AreaRings> polygons, double turn);

} // namespace berg
