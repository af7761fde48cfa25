#include "widgets/map/land/clipping.h"

#include <algorithm>

namespace berg {
namespace {

/** The part of a polygon on one side of a line; `depth` is positive on that side. */
QPolygonF cutOff(const QPolygonF& polygon, const auto& depth)
{
    QPolygonF kept;
    QPointF a = polygon.back();
    double depthOfA = depth(a);
    for (const QPointF& b : polygon) {
        const double depthOfB = depth(b);
        if ((depthOfA < 0) != (depthOfB < 0))
            kept << a + (b - a) * (depthOfA / (depthOfA - depthOfB));
        if (depthOfB >= 0)
            kept << b;
        a = b;
        depthOfA = depthOfB;
    }
    return kept;
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

std::optional<QLineF> clipped(const QLineF& line, const QRectF& rect)
{
    double from = 0;
    double to = 1;
    const auto enter = [&](double path, double room) {
        if (path == 0)
            return room >= 0;
        const double at = room / path;
        (path < 0 ? from : to) = path < 0 ? std::max(from, at) : std::min(to, at);
        return from <= to;
    };
    if (!enter(-line.dx(), line.x1() - rect.left()) ||
        !enter(line.dx(), rect.right() - line.x1()) || !enter(-line.dy(), line.y1() - rect.top()) ||
        !enter(line.dy(), rect.bottom() - line.y1()))
        return std::nullopt;
    return QLineF(from > 0 ? line.pointAt(from) : line.p1(), to < 1 ? line.pointAt(to) : line.p2());
}

bool meet(const WorldBounds& a, const WorldBounds& b)
{
    return (a.min_m.array() <= b.max_m.array()).all() && (b.min_m.array() <= a.max_m.array()).all();
}

} // namespace berg
