#pragma once

#include "widgets/map/picture/map_view_transform.h"

#include <QLineF>
#include <QPainterPath>
#include <QPolygonF>
#include <QRectF>

#include <optional>

namespace berg {

/** Returns a polygon clipped to a rectangle, empty if it is outside. Winding numbers inside are
 * kept, because all rings are cut alike. */
[[nodiscard]] QPolygonF clipped(QPolygonF polygon, const QRectF& rect);

/** Part of a line, as fractions of its length. */
struct LineShares
{
    double from = 0;
    double to = 1;
};
/** Returns the part of `line` inside `rect` (Liang and Barsky); nullopt if it is outside. */
[[nodiscard]] std::optional<LineShares> sharesInside(const QLineF& line, const QRectF& rect);

/** Adds the part of `line` inside `rect` to a path, connected if the path ends at its start. */
void addClipped(QPainterPath& path, const QLineF& line, const QRectF& rect);

/** Returns true if two boxes overlap or touch. */
[[nodiscard]] bool meet(const WorldBounds& a, const WorldBounds& b);

} // namespace berg
