#include "widgets/map/picture/map_view_transform.h"

#include "core/base/error.h"

#include <algorithm>

namespace berg {

void WorldBounds::include(const Point& p_m)
{
    min_m = min_m.cwiseMin(p_m);
    max_m = max_m.cwiseMax(p_m);
}

WorldBounds boundsOf(std::span<const Point> points_m)
{
    if (points_m.empty())
        return {};
    WorldBounds bounds{.min_m = points_m.front(), .max_m = points_m.front()};
    for (const Point& p_m : points_m)
        bounds.include(p_m);
    return bounds;
}

MapViewTransform::MapViewTransform(const Point& centre_m, const QPointF& centre_px,
                                   double scale_pxpm)
    : m_centre_m(centre_m), m_centre_px(centre_px), m_scale_pxpm(scale_pxpm)
{
    require(scale_pxpm > 0, "map scale must be positive");
}

MapViewTransform MapViewTransform::fitted(const WorldBounds& bounds, const QRectF& target,
                                          const QPointF& align, double smallest_m)
{
    const Point size_m = bounds.size_m().cwiseMax(Point::Constant(smallest_m));
    const double scale_pxpm = std::max(1e-9, std::min(std::max(target.width(), 1.0) / size_m.x(),
                                                      std::max(target.height(), 1.0) / size_m.y()));
    const QPointF spare_px(target.width() - size_m.x() * scale_pxpm,
                           target.height() - size_m.y() * scale_pxpm);
    const QPointF shift_px((align.x() - 0.5) * spare_px.x(), (align.y() - 0.5) * spare_px.y());
    return {bounds.centre_m(), target.center() + shift_px, scale_pxpm};
}

QPointF MapViewTransform::toPixel(const Point& p_m) const
{
    const Point offset_px = (p_m - m_centre_m) * m_scale_pxpm;
    return {m_centre_px.x() + offset_px.x(), m_centre_px.y() - offset_px.y()};
}

QPolygonF MapViewTransform::toPixels(std::span<const Point> points_m) const
{
    QPolygonF pixels;
    for (const Point& p_m : points_m)
        pixels << toPixel(p_m);
    return pixels;
}

Point MapViewTransform::toWorld(const QPointF& p_px) const
{
    const QPointF offset_px = p_px - m_centre_px;
    return m_centre_m + Point(offset_px.x(), -offset_px.y()) / m_scale_pxpm;
}

WorldBounds MapViewTransform::visible(const QRectF& rect) const
{
    WorldBounds bounds{.min_m = toWorld(rect.bottomLeft()), .max_m = toWorld(rect.topRight())};
    return bounds;
}

MapViewTransform MapViewTransform::zoomed(double factor, const QPointF& at_px) const
{
    return {toWorld(at_px), at_px, m_scale_pxpm * factor};
}

MapViewTransform MapViewTransform::moved(const QPointF& offset_px) const
{
    return {m_centre_m, m_centre_px + offset_px, m_scale_pxpm};
}

} // namespace berg
