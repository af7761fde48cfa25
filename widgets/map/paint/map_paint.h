#pragma once

#include "widgets/map/paint/map_painter.h"

#include <QPainter>

#include <functional>

namespace berg {

/** What the parts of a map are painted with: clipped to the map, saved and restored. */
struct MapPaint
{
    QPainter& painter;
    const MapPicture& picture;
    const MapStyle& style;
    const MapLayout& layout;
    const Theme& theme;
    const Graticule& graticule;
    MapSprites* sprites;
    SweptLayer* swept;

    MapPaint(QPainter& target, const MapFrame& frame)
        : painter(target)
        , picture(frame.picture)
        , style(frame.style)
        , layout(frame.layout)
        , theme(frame.style.theme)
        , graticule(frame.graticule)
        , sprites(frame.sprites)
        , swept(frame.swept)
    {
        painter.save();
        painter.setClipRect(layout.rect, Qt::IntersectClip);
        painter.setRenderHint(QPainter::Antialiasing);
    }
    ~MapPaint() { painter.restore(); }
    MapPaint(const MapPaint&) = delete;
    MapPaint& operator=(const MapPaint&) = delete;
};

/** Draws round `at`, by way of the kept drawings when there are any. */
void paintKept(const MapPaint& p, const QString& key, const QRectF& bounds, const QPointF& at,
               const std::function<void(QPainter&)>& draw);

} // namespace berg
