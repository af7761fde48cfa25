#pragma once

// Private to core/io: from the rings that a map program holds back to the corners of an area.

#include "core/base/geodesy.h"

#include <span>
#include <vector>

namespace berg {

/**
 * Corners in the plane of the polygon with these exterior rings (`geographicPolygon`, or those of
 * other programs). Rings that were cut at the antimeridian are put together again, along a pole
 * too, and vertices that lie on a straight line between others, put in for the map, are taken out:
 * the outline moves by less than a metre, and less than 1e-5 of its size. Empty when the rings are
 * not one polygon. Corners may be fewer than three; of more than an area holds (`kMostAreaCorners`)
 * there are only some. Cost: vertices times corners at worst.
 */
[[nodiscard]] std::vector<Point> areaOutline(std::span<const std::vector<LatLon>> rings,
                                             const LocalFrame& frame);

} // namespace berg
