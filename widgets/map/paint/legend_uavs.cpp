#include "widgets/map/paint/legend_uavs.h"

#include "widgets/map/paint/map_symbols.h"
#include "widgets/theme/painter_state.h"
#include "widgets/theme/palette.h"

#include <QFontMetricsF>

namespace berg {
namespace {

constexpr double kRow_px = 20;
constexpr double kSign_px = 19;
constexpr double kGap_px = 14;
constexpr double kSignScale = 0.55; // of the symbol on the map

} // namespace

LegendUavs::LegendUavs(const MapPicture& picture, const Theme& theme, double width_px)
{
    const QFontMetricsF metrics(theme.small());
    QPointF at(0, kRow_px / 2);
    for (const MapUav& uav : picture.uavs) {
        if (uav.label.isEmpty())
            continue;
        const QString name = metrics.elidedText(uav.label, Qt::ElideRight, width_px - kSign_px);
        const double chip_px = kSign_px + metrics.horizontalAdvance(name);
        if (at.x() > 0 && at.x() + chip_px > width_px)
            at = QPointF(0, at.y() + kRow_px);
        m_chips.push_back({.at = at, .name = name, .colour = uavColour(theme, uav.place)});
        at.rx() += chip_px + kGap_px;
    }
    if (!m_chips.empty())
        m_height_px = at.y() + kRow_px / 2;
}

void LegendUavs::paint(QPainter& painter, const QPointF& at, const Theme& theme) const
{
    for (const Chip& chip : m_chips) {
        const PainterState saved(painter);
        painter.translate(at + chip.at);
        painter.setFont(theme.small());
        painter.setPen(theme.text);
        painter.drawText(QRectF(kSign_px, -kRow_px / 2, 1000, kRow_px),
                         static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter), chip.name);
        painter.translate(kSign_px / 2 - 3, 0);
        painter.scale(kSignScale, kSignScale);
        drawUav(painter, {0, 0}, 0, chip.colour, theme);
    }
}

} // namespace berg
