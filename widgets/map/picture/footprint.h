#pragma once

#include "widgets/map/picture/map_picture.h"
#include "widgets/map/picture/map_view_transform.h"

#include <QPolygonF>

namespace berg {

/**
 * Returns the corners of a field of view round the origin, before it is rotated: metres,
 * counter-clockwise, x along the heading (north for `FovShape::North`). A disk becomes a polygon of
 * `diskCorners`.
 */
[[nodiscard]] std::vector<Point> footprintCorners(const SensorSpec& sensor, int diskCorners);

/** Returns the rotation of those corners on the map, radians counter-clockwise, for a UAV that
 * heads towards `psi_rad`. */
[[nodiscard]] double footprintTurn_rad(const SensorSpec& sensor, double psi_rad);

/** Returns the corners of the field of view of `uav` on the map, metres. */
[[nodiscard]] std::vector<Point> fieldCorners(const MapUav& uav);

/** Returns the closed outline of the field of view of `uav` on the screen. */
[[nodiscard]] QPolygonF fieldOutline(const MapUav& uav, const MapViewTransform& view);

} // namespace berg
