#pragma once

#include "widgets/map/picture/map_picture.h"
#include "widgets/map/picture/map_view_transform.h"

#include <QPolygonF>

namespace berg {

/**
 * Corners of the field of view round a UAV at (0, 0) with the turn 0, metres, counter-clockwise; a
 * disk is a polygon of `diskCorners`.
 */
[[nodiscard]] std::vector<Point> footprintCorners(const SensorSpec& sensor, int diskCorners);

/** By how much those corners are turned when the UAV's psi is `psi_rad`. */
[[nodiscard]] double footprintTurn_rad(const SensorSpec& sensor, double psi_rad);

/** Corners of the field of view round that UAV. */
[[nodiscard]] std::vector<Point> fieldCorners(const MapUav& uav);

/** Outline of the field of view on the screen. */
[[nodiscard]] QPolygonF fieldOutline(const MapUav& uav, const MapViewTransform& view);

} // namespace berg
