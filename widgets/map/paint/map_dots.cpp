#include "widgets/map/paint/map_dots.h"

#include "widgets/map/paint/map_paint.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kCount_px = 9;      // radius for one or two digits
constexpr double kLongCount_px = 12; // radius for three digits
constexpr double kSigmaSteps = 100;  // number of colours of cached drawings

double shareOf(const MapPaint& p, double sigma_m2)
{
    const double share = std::clamp(sigma_m2 / p.picture.sigmaFull_m2, 0.0, 1.0);
    return std::round(share * kSigmaSteps) / kSigmaSteps;
}

QRectF roundIt(double radius_px)
{
    return {-radius_px, -radius_px, 2 * radius_px, 2 * radius_px};
}

} // namespace

void drawIcebergDot(QPainter& painter, const QPointF& centre, const QColor& sigma, bool inView,
                    const Theme& theme)
{
    const QRectF box = roundIt(kIcebergDot_px).translated(centre);
    painter.setPen(QPen(inView ? theme.uav : theme.ink, inView ? 1.6 : 0.8));
    painter.setBrush(inView ? theme.ice : sigma);
    if (inView)
        painter.drawRect(box);
    else
        painter.drawEllipse(box);
}

void drawIcebergCount(QPainter& painter, const QPointF& centre, int icebergs, const QColor& sigma,
                      const Theme& theme)
{
    const QRectF box = roundIt(icebergs < 100 ? kCount_px : kLongCount_px).translated(centre);
    painter.setPen(QPen(sigma, 2.4));
    painter.setBrush(theme.panel);
    painter.drawEllipse(box);
    painter.setPen(theme.text);
    painter.setFont(theme.small());
    painter.drawText(box.adjusted(-4, -2, 4, 2), Qt::AlignCenter, QString::number(icebergs));
}

void paintDots(const MapPaint& p)
{
    if (!p.layout.density.isDense)
        return;
    const QRectF dot = roundIt(kIcebergDot_px + 2);
    const QRectF seen = p.layout.rect.marginsAdded({8, 8, 8, 8});
    for (std::size_t i = 0; i < p.picture.icebergs.size(); ++i) {
        const QPointF& at = p.layout.icebergs[i].centre_px;
        if (p.layout.density.marks[i] != IcebergMark::Dot || !seen.contains(at))
            continue;
        const bool inView = p.picture.icebergs[i].inView;
        const double share = shareOf(p, p.picture.icebergs[i].sigma_m2);
        paintCached(p, u"dot %1 %2"_s.arg(inView ? -1 : share).arg(int(inView)), dot, at,
                    [&](QPainter& painter) {
                        drawIcebergDot(painter, {0, 0}, p.theme.sigma.at(share), inView, p.theme);
                    });
    }
    for (const MapCount& count : p.layout.density.counts) {
        const double share = shareOf(p, count.sigma_m2);
        paintCached(
            p, u"count %1 %2"_s.arg(share).arg(count.icebergs), roundIt(kLongCount_px + 3),
            count.centre_px, [&](QPainter& painter) {
                drawIcebergCount(painter, {0, 0}, count.icebergs, p.theme.sigma.at(share), p.theme);
            });
    }
}

} // namespace berg
