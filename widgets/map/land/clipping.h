#pragma once

#include "widgets/map/picture/map_view_transform.h"

#include <QLineF>
#include <QPainterPath>
#include <QPolygonF>
#include <QRectF>

#include <optional>

namespace berg {

/** The part of a polygon in a rectangle. Keeps winding numbers there: all rings are cut alike. */
[[nodiscard]] QPolygonF clipped(QPolygonF polygon, const QRectF& rect);

/** From where to where on a line, as shares of its length. */
struct LineShares
{
    double from = 0;
    double to = 1;
};
/** The part of a line in a rectangle (Liang and Barsky); none: it is outside. */
[[nodiscard]] std::optional<LineShares> sharesInside(const QLineF& line, const QRectF& rect);

/** Adds that part to a path that is drawn along such lines. */
void addClipped(QPainterPath& path, const QLineF& line, const QRectF& rect);

[[nodiscard]] bool meet(const WorldBounds& a, const WorldBounds& b);

} // namespace berg
