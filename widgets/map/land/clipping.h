#pragma once

#include "widgets/map/picture/map_view_transform.h"

#include <QLineF>
#include <QPolygonF>
#include <QRectF>

#include <optional>

namespace berg {

/** The part of a polygon in a rectangle. Keeps winding numbers there: all rings are cut alike. */
[[nodiscard]] QPolygonF clipped(QPolygonF polygon, const QRectF& rect);

/** The part of a line in a rectangle (Liang and Barsky); none: it is outside. */
[[nodiscard]] std::optional<QLineF> clipped(const QLineF& line, const QRectF& rect);

[[nodiscard]] bool meet(const WorldBounds& a, const WorldBounds& b);

} // namespace berg
