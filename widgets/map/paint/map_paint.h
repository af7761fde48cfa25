#pragma once

#include "widgets/map/paint/map_painter.h"

#include <QPainter>

#include <functional>

namespace berg {

/** Painting context of a map: clips to the map, and restores the painter when destroyed. */
struct MapPaint : MapFrame
{
    QPainter& painter;
    const Theme& theme;

    MapPaint(QPainter& target, const MapFrame& frame)
        : MapFrame(frame), painter(target), theme(frame.style.theme)
    {
        painter.save();
        painter.setClipRect(layout.rect, Qt::IntersectClip);
        painter.setRenderHint(QPainter::Antialiasing);
    }
    ~MapPaint() { painter.restore(); }
    MapPaint(const MapPaint&) = delete;
    MapPaint& operator=(const MapPaint&) = delete;
};

/** Draws at `at`, from the cache of drawings under `key` if there is one. */
void paintCached(const MapPaint& p, const QString& key, const QRectF& bounds, const QPointF& at,
                 const std::function<void(QPainter&)>& draw);

} // namespace berg
