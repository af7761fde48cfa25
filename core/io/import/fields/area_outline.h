#pragma once

// Private to core/io: converts the rings of a map program to the corners of an area.

#include "core/earth/geodesy.h"

#include <span>
#include <vector>

namespace berg {

/**
 * Returns the corners in the plane of the polygon with these exterior rings (`geographicPolygon`,
 * or those of other programs). Rings that were cut at the antimeridian or along a pole are joined
 * again, and vertices on straight lines between others, inserted for the map, are removed: the
 * outline moves by less than a metre, and less than 1e-5 of its size. Returns no corners if the
 * rings are not one polygon. There may be fewer than three corners; if there are more than an area
 * holds (`kMostAreaCorners`), only some are returned. Cost: vertices times corners at worst.
 */
[[nodiscard]] std::vector<Point> areaOutline(std::span<const std::vector<LatLon>> rings,
                                             const LocalFrame& frame);

} // namespace berg
