#pragma once

#include "widgets/map/paint/map_painter.h"

#include <QPainter>

#include <functional>

namespace berg {

/** What the parts of a map are painted with: clipped to the map, saved and restored. */
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

/** Draws round `at`, by way of the kept drawings when there are any. */
void paintKept(const MapPaint& p, const QString& key, const QRectF& bounds, const QPointF& at,
               const std::function<void(QPainter&)>& draw);

} // namespace berg
