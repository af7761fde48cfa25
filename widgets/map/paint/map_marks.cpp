#include "widgets/map/paint/map_marks.h"

#include "core/base/angles.h"
#include "widgets/map/paint/map_layout.h"
#include "widgets/map/paint/map_overlays.h"
#include "widgets/map/paint/map_paint.h"
#include "widgets/map/paint/map_symbols.h"
#include "widgets/theme/painter_state.h"
#include "widgets/theme/palette.h"

#include <QFontMetricsF>

#include <algorithm>
#include <numbers>

namespace berg {
namespace {

constexpr double kRingGap_px = 3.5; // between the symbol and its ring
constexpr double kHandle_px = 6;

void drawRing(QPainter& painter, const QPointF& centre, double radius_px, double width_px,
              const Theme& theme)
{
    painter.setBrush(Qt::NoBrush);
    // A rim of sea sets the ring off from legs and labels.
    painter.setPen(QPen(theme.sea, width_px + 2.2));
    painter.drawEllipse(centre, radius_px, radius_px);
    painter.setPen(QPen(theme.text, width_px));
    painter.drawEllipse(centre, radius_px, radius_px);
}

/** Draws a label to the right of a symbol. */
void drawLiveLabel(const MapPaint& p, const QPointF& at, const QString& text, const QColor& colour)
{
    p.painter.setFont(p.theme.small());
    const QSizeF size(QFontMetricsF(p.theme.small()).size(Qt::TextSingleLine, text));
    const QRectF box(at + QPointF(16, -size.height() / 2), size);
    drawHaloText(p.painter, box, Qt::AlignCenter, text, colour, p.theme.sea);
}

/** Leaves out places that are hardly apart on the screen, because tracks become long. */
QPolygonF liveTrack(const MapPaint& p, const std::vector<Point>& track_m)
{
    constexpr double kStep_px = 2;
    QPolygonF track;
    for (std::size_t i = 0; i < track_m.size(); ++i) {
        const QPointF at = p.layout.view.toPixel(track_m[i]);
        if (i == 0 || i + 1 == track_m.size() || (at - track.back()).manhattanLength() >= kStep_px)
            track.push_back(at);
    }
    return track;
}

void paintAircraft(const MapPaint& p, const MapAircraft& aircraft)
{
    const QColor colour = uavColour(p.theme, aircraft.place);
    const QPointF at = p.layout.view.toPixel(aircraft.position_m);
    p.painter.setBrush(Qt::NoBrush);
    p.painter.setPen(QPen(colour, 1));
    if (!aircraft.isFlown)
        p.painter.drawPolyline(liveTrack(p, aircraft.track_m));
    if (aircraft.contact_m) {
        const QPointF contact = p.layout.view.toPixel(*aircraft.contact_m);
        p.painter.setPen(QPen(colour, 1.6));
        p.painter.drawEllipse(contact, 6, 6);
        p.painter.drawEllipse(contact, 2, 2);
        drawLiveLabel(p, contact, aircraft.contactLabel, p.theme.text);
    }
    if (aircraft.isFlown && !aircraft.isGhost)
        return;
    drawUav(p.painter, at, aircraft.psi_rad, aircraft.isGhost ? p.theme.sea : colour, p.theme);
    if (aircraft.isGhost) { // a dashed ring, so that the shape shows it, too
        p.painter.setPen(QPen(colour, 1.6, Qt::DashLine));
        p.painter.drawEllipse(at, 19, 19);
    }
    drawLiveLabel(p, at + QPointF(6, 0), aircraft.label, p.theme.text);
}

/** Ships are hulls, ice is a triangle, aircraft are crosses with a tail. */
void paintTraffic(const MapPaint& p, const MapTraffic& traffic)
{
    const PainterState saved(p.painter);
    const QPointF at = p.layout.view.toPixel(traffic.position_m);
    drawLiveLabel(p, at, traffic.label, p.theme.mutedText);
    p.painter.translate(at);
    if (traffic.isIce) {
        p.painter.setPen(QPen(p.theme.ink, 1.4));
        p.painter.setBrush(p.theme.panel);
        p.painter.drawPolygon(QPolygonF{{0, -9}, {8, 6}, {-8, 6}});
        return;
    }
    p.painter.rotate(-degFromRad(traffic.psi_rad.value_or(kPi / 2)));
    p.painter.setPen(QPen(p.theme.ink, 1.4));
    p.painter.setBrush(p.theme.panel);
    if (traffic.isShip) {
        p.painter.drawPolygon(QPolygonF{{11, 0}, {5, -4.5}, {-9, -4.5}, {-9, 4.5}, {5, 4.5}});
        return;
    }
    p.painter.drawLine(QPointF(-9, 0), QPointF(10, 0));
    p.painter.drawLine(QPointF(2, -9), QPointF(2, 9));
    p.painter.drawLine(QPointF(-8, -4), QPointF(-8, 4));
}

} // namespace

void paintLive(const MapPaint& p)
{
    const PainterState saved(p.painter);
    for (const MapTraffic& traffic : p.picture.live.traffic)
        paintTraffic(p, traffic);
    for (const MapAircraft& aircraft : p.picture.live.aircraft)
        paintAircraft(p, aircraft);
}

void paintSelectionMark(QPainter& painter, const LabelDisk& symbol, const Theme& theme)
{
    const PainterState saved(painter);
    const double radius_px = symbol.radius_px + kRingGap_px;
    drawRing(painter, symbol.centre_px, radius_px, 1.8, theme);
    painter.setPen(QPen(theme.text, 1.4));
    painter.setBrush(theme.panel);
    // Handles are on the diagonals, because names are mostly beside the symbol.
    const double diagonal_px = radius_px * std::numbers::sqrt2 / 2;
    for (const QPointF& direction :
         {QPointF(1, 1), QPointF(-1, 1), QPointF(-1, -1), QPointF(1, -1)}) {
        const QPointF at = symbol.centre_px + direction * diagonal_px;
        painter.drawRect(
            QRectF(at.x() - kHandle_px / 2, at.y() - kHandle_px / 2, kHandle_px, kHandle_px));
    }
}

void paintLaterDisk(QPainter& painter, const QPointF& centre, int number, const QColor& colour,
                    const Theme& theme)
{
    const PainterState saved(painter);
    painter.setPen(QPen(colour, 1.2));
    painter.setBrush(theme.sea);
    painter.drawEllipse(centre, kLaterDisk_px, kLaterDisk_px);
    QFont font = theme.small();
    font.setPixelSize(number > 99 ? 7 : 9); // fits three digits on the disk
    painter.setFont(font);
    painter.setPen(theme.text);
    const QRectF box(centre - QPointF(2, 1) * kLaterDisk_px, QSizeF(4, 2) * kLaterDisk_px);
    painter.drawText(box, Qt::AlignCenter, QString::number(number));
}

void paintHoverMark(QPainter& painter, const LabelDisk& symbol, const Theme& theme)
{
    const PainterState saved(painter);
    drawRing(painter, symbol.centre_px, symbol.radius_px + kRingGap_px, 1.2, theme);
}

void paintRecordedTrack(QPainter& painter, const QPolygonF& path, const Theme& theme)
{
    if (path.isEmpty())
        return;
    QPolygonF seen{path.front()}; // thinned to points at least a pixel from each other
    for (const QPointF& at : path)
        if ((at - seen.back()).manhattanLength() >= 1)
            seen << at;
    const PainterState saved(painter);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(
        QPen(mixed(theme.sea, theme.ink, 0.55), 1.2, Qt::SolidLine, Qt::RoundCap, Qt::BevelJoin));
    painter.drawPolyline(seen);
    painter.setBrush(theme.sea);
    painter.drawEllipse(seen.back(), 2.5, 2.5);
}

void paintRubberBand(QPainter& painter, const QRectF& band, const Theme& theme)
{
    const PainterState saved(painter);
    QColor fill = theme.plan;
    fill.setAlphaF(0.10F);
    painter.setBrush(fill);
    painter.setPen(QPen(theme.plan, 1.4, Qt::DashLine, Qt::FlatCap, Qt::MiterJoin));
    painter.drawRect(band);
}

void paintDragTrail(QPainter& painter, const QLineF& path, const Theme& theme)
{
    const PainterState saved(painter);
    painter.setPen(QPen(theme.text, 1.2, Qt::DotLine, Qt::FlatCap));
    painter.drawLine(path);
    painter.setPen(QPen(theme.text, 1.2));
    painter.setBrush(theme.sea);
    painter.drawEllipse(path.p1(), 3.5, 3.5);
}

void paintBubble(QPainter& painter, const QPointF& at, const QString& text, const QRectF& area,
                 const Theme& theme)
{
    const PainterState saved(painter);
    const QFontMetricsF metrics(theme.body());
    const QStringList lines = text.split(u'\n');
    double widest_px = 0;
    for (const QString& line : lines)
        widest_px = std::max(widest_px, tabularWidth(metrics, line));
    const QSizeF size(widest_px + 20, static_cast<double>(lines.size()) * metrics.height() + 10);
    QPointF corner = at + QPointF(18, 14);
    // The bubble goes to the other side of the cursor if there is no room.
    if (corner.x() + size.width() > area.right())
        corner.setX(at.x() - 14 - size.width());
    if (corner.y() + size.height() > area.bottom())
        corner.setY(at.y() - 14 - size.height());
    corner.setX(std::max(corner.x(), area.left()));
    corner.setY(std::max(corner.y(), area.top()));
    const QRectF box(corner, size);
    paintPanel(painter, box, theme);
    painter.setFont(theme.body());
    painter.setPen(theme.text);
    QPointF baseline = box.topLeft() + QPointF(10, 5 + metrics.ascent());
    for (const QString& line : lines) {
        drawTabular(painter, baseline, line);
        baseline.ry() += metrics.height();
    }
}

void paintTag(QPainter& painter, const QPointF& centre, const QString& text, const Theme& theme)
{
    const PainterState saved(painter);
    const QFontMetricsF metrics(theme.small());
    const QSizeF size(tabularWidth(metrics, text) + 10, metrics.height() + 4);
    const QRectF box(centre - QPointF(size.width(), size.height()) / 2, size);
    paintPanel(painter, box, theme);
    painter.setFont(theme.small());
    painter.setPen(theme.text);
    drawTabular(painter, box.topLeft() + QPointF(5, 2 + metrics.ascent()), text);
}

void paintAreaMark(QPainter& painter, const QPolygonF& outline, bool isSelected, const Theme& theme)
{
    const PainterState saved(painter);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.text, isSelected ? 2.2 : 1.8));
    painter.drawPolygon(outline);
}

void paintFocusFrame(QPainter& painter, const QRectF& rect, const Theme& theme)
{
    const PainterState saved(painter);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.plan, 2, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    painter.drawRect(rect.adjusted(1, 1, -1, -1));
}

} // namespace berg
