#pragma once

#include "core/earth/geodesy.h"

#include <functional>
#include <optional>

namespace berg {

/**
 * Converts x, y of a map projection, metres, to the place on the Earth, longitude in [-180, 180).
 */
using Unprojection = std::function<LatLon(const Point& projected_m)>;

/**
 * Returns the inverse of a map projection by its EPSG code: polar stereographic (3031, 3032, 3411,
 * 3412, 3413, 3976, 3995, 3996, UPS 5041, 5042, 32661, 32761), UTM (326zz and 327zz, 258zz of
 * ETRS89, 269zz of NAD83) and the Mercator of web maps (3857, 900913). Datums that differ from WGS
 * 84 by a few metres are taken as WGS 84. Returns nullopt for any other code.
 */
[[nodiscard]] std::optional<Unprojection> unprojectionOf(int epsg);

/**
 * Returns true if the code is for latitudes and longitudes in degrees, in WGS 84 or within 2 m of
 * it.
 */
[[nodiscard]] bool isGeographic(int epsg);

} // namespace berg
