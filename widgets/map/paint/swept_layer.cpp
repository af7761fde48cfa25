#include "widgets/map/paint/swept_layer.h"

#include <QPainter>

#include <utility>

namespace berg {
namespace {

constexpr double kFrame_ms = 5; // painting time per frame

} // namespace

void SweptLayer::paint(QPainter& painter, const std::vector<SweptTrail>& trails,
                       const SweptStyle& style)
{
    if (m_shown.style() == style && m_shown.isOf(trails)) {
        m_isDone = m_shown.advance(trails, style, kFrame_ms);
    } else {
        const auto isAlike = [&](const SweptMask& mask) {
            const SweptStyle& other = mask.style();
            return mask.isOf(trails) && other.tint == style.tint && other.rect == style.rect &&
                   other.ratio == style.ratio;
        };
        // The view in progress is completed first, else a steadily moving one never would be.
        const SweptStyle target = m_isUnderWay && isAlike(m_next) ? m_next.style() : style;
        const bool isWhole = m_next.advance(trails, target, kFrame_ms);
        m_isUnderWay = !isWhole && isAlike(m_shown);
        if (!m_isUnderWay)
            std::swap(m_shown, m_next);
        m_isDone = isWhole && m_shown.style() == style;
    }
    const SweptStyle& shown = m_shown.style();
    if (shown.view == style.view && shown.rect == style.rect) {
        painter.drawImage(style.rect.topLeft(), m_shown.image());
        return;
    }
    const auto placeNow = [&](const QPointF& p_px) {
        return style.view.toPixel(shown.view.toWorld(p_px));
    };
    const QRectF was(shown.rect.topLeft(), QSizeF(m_shown.image().size()) / shown.ratio);
    painter.drawImage(QRectF(placeNow(was.topLeft()), placeNow(was.bottomRight())),
                      m_shown.image());
}

} // namespace berg
