#pragma once

#include <QHash>
#include <QPainter>
#include <QPixmap>

#include <functional>

namespace berg {

/**
 * Small drawings kept as pixels, because smooth shapes and text cost far more to draw than to
 * copy. A drawing is known by its key, which must name everything that decides its look.
 */
class MapSprites
{
public:
    /**
     * Shows what `draw` paints round the origin, inside `bounds`, with the origin at `at`, moved by
     * less than a device pixel so that the pixels fit.
     */
    void paint(QPainter& painter, const QString& key, const QRectF& bounds, const QPointF& at,
               const std::function<void(QPainter&)>& draw);

    /** Forgets all drawings, e.g. because the theme is another one. */
    void clear()
    {
        m_pixmaps.clear();
        m_older.clear();
    }

private:
    QHash<QString, QPixmap> m_pixmaps;
    QHash<QString, QPixmap> m_older; ///< from before there were too many
    double m_ratio = 0;              ///< device pixels for each unit of the drawings held
};

} // namespace berg
