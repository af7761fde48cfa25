#include "widgets/map/paint/map_sprites.h"

#include <cmath>
#include <utility>

namespace berg {
namespace {

// Limit of each of the two maps, a few MB; only a long flight with ever new numbers comes near it.
constexpr qsizetype kMostSprites = 1000;

} // namespace

void MapSprites::paint(QPainter& painter, const QString& key, const QRectF& bounds,
                       const QPointF& at, const std::function<void(QPainter&)>& draw)
{
    const double ratio = painter.device()->devicePixelRatioF();
    if (ratio != m_ratio) {
        clear();
        m_ratio = ratio;
    }
    if (m_pixmaps.size() >= kMostSprites) // drawings in use move back on demand
        m_older = std::exchange(m_pixmaps, {});
    const auto snapped = [ratio](double v) { return std::floor(v * ratio) / ratio; };
    const QPointF corner(snapped(bounds.left()), snapped(bounds.top()));
    auto it = m_pixmaps.find(key);
    if (const auto older = m_older.constFind(key); it == m_pixmaps.end() && older != m_older.cend())
        it = m_pixmaps.insert(key, *older);
    if (it == m_pixmaps.end()) {
        const QSize size(static_cast<int>(std::ceil((bounds.right() - corner.x()) * ratio)) + 1,
                         static_cast<int>(std::ceil((bounds.bottom() - corner.y()) * ratio)) + 1);
        QPixmap pixmap(size);
        pixmap.setDevicePixelRatio(ratio);
        pixmap.fill(Qt::transparent);
        QPainter own(&pixmap);
        own.setRenderHint(QPainter::Antialiasing);
        own.translate(-corner);
        draw(own);
        own.end();
        it = m_pixmaps.insert(key, pixmap);
    }
    const QPointF origin(std::round(at.x() * ratio) / ratio, std::round(at.y() * ratio) / ratio);
    painter.drawPixmap(origin + corner, it.value());
}

} // namespace berg
