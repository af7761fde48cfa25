#pragma once

#include <QHash>
#include <QPainter>
#include <QPixmap>

#include <functional>

namespace berg {

/**
 * Cache of small drawings as pixels: smooth shapes and text cost far more to draw than to copy. The
 * key of a drawing must contain all that decides its style.
 */
class MapSprites
{
public:
    /**
     * Shows what `draw` paints around the origin, inside `bounds`, with the origin at `at`, rounded
     * to a device pixel. `draw` is called only if the key is not cached: if it is new, has not been
     * used for long, or the painter's device has another pixel ratio than the last one.
     */
    void paint(QPainter& painter, const QString& key, const QRectF& bounds, const QPointF& at,
               const std::function<void(QPainter&)>& draw);

    /** Drops all drawings, for example because the theme has changed. */
    void clear()
    {
        m_pixmaps.clear();
        m_older.clear();
    }

private:
    QHash<QString, QPixmap> m_pixmaps;
    QHash<QString, QPixmap> m_older; ///< drawings moved here when `m_pixmaps` was full
    double m_ratio = 0;              ///< device pixels per unit of the cached drawings
};

} // namespace berg
