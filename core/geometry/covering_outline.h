#pragma once

#include "core/geometry/geometry.h"

#include <optional>
#include <vector>

namespace berg {

/** A simple polygon that covers everything a closed line encloses. */
struct CoveringOutline
{
    std::vector<Point> corners_m; ///< counter-clockwise
    bool wasCrossing = false;     ///< true if the line touched or crossed itself
    bool wasThinned = false;      ///< true if the line had too many corners
};

/**
 * Returns an outline of at most `limit` >= 3 corners that covers what the closed line through
 * `ring_m` encloses, up to an error of a centimetre. A simple polygon within the limit stays as it
 * is. Parts that meet in a point are joined by a passage some decimetres wide; where that fails,
 * and for a crossing line of more than 4000 corners or 20,000 crossings, the convex hull covers
 * them. Returns nullopt if the line encloses less than a square metre. Coordinates must be finite.
 * Cost: corners squared.
 */
[[nodiscard]] std::optional<CoveringOutline> coveringOutline(std::span<const Point> ring_m,
                                                             std::size_t limit);

} // namespace berg
