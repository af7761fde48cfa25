#include "widgets/map/paint/swept_layer.h"

#include <QPainter>

#include <utility>

namespace berg {
namespace {

constexpr double kFrame_ms = 5; ///< of painting in one frame

} // namespace

void SweptLayer::paint(QPainter& painter, const std::vector<SweptTrail>& trails,
                       const SweptLook& look)
{
    if (m_shown.look() == look && m_shown.isOf(trails)) {
        m_isDone = m_shown.advance(trails, look, kFrame_ms);
    } else {
        const auto isAlike = [&](const SweptMask& mask) {
            const SweptLook& other = mask.look();
            return mask.isOf(trails) && other.tint == look.tint && other.rect == look.rect &&
                   other.ratio == look.ratio;
        };
        // A view under way is painted to its end, else one that moves on and on would never be.
        const SweptLook target = m_isUnderWay && isAlike(m_next) ? m_next.look() : look;
        const bool isWhole = m_next.advance(trails, target, kFrame_ms);
        m_isUnderWay = !isWhole && isAlike(m_shown);
        if (!m_isUnderWay)
            std::swap(m_shown, m_next);
        m_isDone = isWhole && m_shown.look() == look;
    }
    const SweptLook& shown = m_shown.look();
    if (shown.view == look.view && shown.rect == look.rect) {
        painter.drawImage(look.rect.topLeft(), m_shown.image());
        return;
    }
    const auto placeNow = [&](const QPointF& p_px) {
        return look.view.toPixel(shown.view.toWorld(p_px));
    };
    const QRectF was(shown.rect.topLeft(), QSizeF(m_shown.image().size()) / shown.ratio);
    painter.drawImage(QRectF(placeNow(was.topLeft()), placeNow(was.bottomRight())),
                      m_shown.image());
}

} // namespace berg
