#include "widgets/map/land/clipping.h"

#include <algorithm>

namespace berg {
namespace {

/** The part of a polygon on one side of a line; `depth` is positive on that side. */
QPolygonF cutOff(const QPolygonF& polygon, const auto& depth)
{
    QPolygonF clipped;
    QPointF a = polygon.back();
    double depthOfA = depth(a);
    for (const QPointF& b : polygon) {
        const double depthOfB = depth(b);
        if ((depthOfA < 0) != (depthOfB < 0))
            clipped << a + (b - a) * (depthOfA / (depthOfA - depthOfB));
        if (depthOfB >= 0)
            clipped << b;
        a = b;
        depthOfA = depthOfB;
    }
    return clipped;
}

} // namespace

QPolygonF clipped(QPolygonF polygon, const QRectF& rect)
{
    const auto cut = [&](const auto& depth) {
        if (!polygon.isEmpty())
            polygon = cutOff(polygon, depth);
    };
    cut([&](const QPointF& p) { return p.x() - rect.left(); });
    cut([&](const QPointF& p) { return rect.right() - p.x(); });
    cut([&](const QPointF& p) { return p.y() - rect.top(); });
    cut([&](const QPointF& p) { return rect.bottom() - p.y(); });
    return polygon;
}

std::optional<LineShares> sharesInside(const QLineF& line, const QRectF& rect)
{
    LineShares inside;
    const auto enter = [&inside](double step, double limit) { // step * share <= limit
        if (step == 0)
            return limit >= 0;
        const double at = limit / step;
        if (step < 0)
            inside.from = std::max(inside.from, at);
        else
            inside.to = std::min(inside.to, at);
        return inside.from <= inside.to;
    };
    if (enter(-line.dx(), line.x1() - rect.left()) && enter(line.dx(), rect.right() - line.x1()) &&
        enter(-line.dy(), line.y1() - rect.top()) && enter(line.dy(), rect.bottom() - line.y1()))
        return inside;
    return std::nullopt;
}

void addClipped(QPainterPath& path, const QLineF& line, const QRectF& rect)
{
    const std::optional<LineShares> inside = sharesInside(line, rect);
    if (!inside)
        return;
    const QPointF from = inside->from > 0 ? line.pointAt(inside->from) : line.p1();
    if (path.isEmpty() || path.currentPosition() != from)
        path.moveTo(from);
    path.lineTo(inside->to < 1 ? line.pointAt(inside->to) : line.p2());
}

bool meet(const WorldBounds& a, const WorldBounds& b)
{
    return (a.min_m.array() <= b.max_m.array()).all() && (b.min_m.array() <= a.max_m.array()).all();
}

} // namespace berg
