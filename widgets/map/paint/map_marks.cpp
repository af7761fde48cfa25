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
#include <array>
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

constexpr double kLabelGap_px = 4; // between a symbol and its label
constexpr double kTrafficSymbol_px = 12;
constexpr double kContactSymbol_px = 6;
constexpr double kAircraftSymbol_px = 19;

/** A text beside a live object. */
struct LiveLabel
{
    LabelDisk anchor;
    QString text;
    QColor colour;
};

/** Draws the labels where they do not cover each other, earlier ones first beside their object. */
void drawLiveLabels(const MapPaint& p, const std::vector<LiveLabel>& labels)
{
    p.painter.setFont(p.theme.small());
    const QFontMetricsF metrics(p.theme.small());
    std::vector<LabelRequest> requests;
    for (const LiveLabel& label : labels)
        requests.push_back({.anchor = label.anchor,
                            .size_px = metrics.size(Qt::TextSingleLine, label.text),
                            .previous = {}});
    LabelSurroundings surroundings{.area = p.layout.rect,
                                   .solids = p.layout.uavLabels,
                                   .disks = p.layout.icebergs,
                                   .lines = {}};
    for (const PlacedLabel& name : p.layout.labels)
        surroundings.solids.push_back(name.rect);
    const std::vector<QRectF> places = placesBeside(requests, surroundings);
    for (std::size_t i = 0; i < labels.size(); ++i)
        drawHaloText(p.painter, places[i], Qt::AlignCenter, labels[i].text, labels[i].colour,
                     p.theme.sea);
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

void paintAircraft(const MapPaint& p, const MapAircraft& aircraft, std::vector<LiveLabel>& labels)
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
        p.painter.drawEllipse(contact, kContactSymbol_px, kContactSymbol_px);
        p.painter.drawEllipse(contact, 2, 2);
        labels.push_back({{contact, kContactSymbol_px}, aircraft.contactLabel, p.theme.text});
    }
    if (aircraft.isFlown && !aircraft.isGhost)
        return;
    drawUav(p.painter, at, aircraft.psi_rad, aircraft.isGhost ? p.theme.sea : colour, p.theme);
    if (aircraft.isGhost) { // a dashed ring, so that the shape shows it, too
        p.painter.setPen(QPen(colour, 1.6, Qt::DashLine));
        p.painter.drawEllipse(at, kAircraftSymbol_px, kAircraftSymbol_px);
    }
    labels.push_back({{at, kAircraftSymbol_px}, aircraft.label, p.theme.text});
}

/** Ships are hulls, ice is a triangle, aircraft are crosses with a tail. */
void paintTraffic(const MapPaint& p, const MapTraffic& traffic)
{
    const PainterState saved(p.painter);
    const QPointF at = p.layout.view.toPixel(traffic.position_m);
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
    std::vector<LiveLabel> labels;
    for (const MapAircraft& aircraft : p.picture.live.aircraft)
        paintAircraft(p, aircraft, labels);
    for (const MapTraffic& traffic : p.picture.live.traffic)
        labels.push_back({{p.layout.view.toPixel(traffic.position_m), kTrafficSymbol_px},
                          traffic.label,
                          p.theme.mutedText});
    drawLiveLabels(p, labels);
}

std::vector<QRectF> placesBeside(std::span<const LabelRequest> requests,
                                 const LabelSurroundings& surroundings)
{
    constexpr std::array<QPoint, 8> kSides{QPoint(1, 0),  QPoint(-1, 0), QPoint(0, 1),
                                           QPoint(0, -1), QPoint(1, 1),  QPoint(1, -1),
                                           QPoint(-1, 1), QPoint(-1, -1)};
    std::vector<QRectF> places;
    for (std::size_t i = 0; i < requests.size(); ++i) {
        const LabelRequest& request = requests[i];
        const QSizeF half = request.size_px / 2;
        const double away_px = request.anchor.radius_px + kLabelGap_px;
        const auto placeAt = [&](const QPoint& side) {
            const QPointF offset((away_px + half.width()) * side.x(),
                                 (side.x() == 0 ? away_px + half.height() : away_px) * side.y());
            return QRectF(request.anchor.centre_px + offset - QPointF(half.width(), half.height()),
                          request.size_px);
        };
        const auto isFree = [&](const QPoint& side) {
            const QRectF place = placeAt(side);
            const auto touches = [&](const QRectF& other) { return place.intersects(other); };
            const auto covers = [&](const LabelDisk& disk) { return overlaps(place, disk); };
            const auto coversOther = [&](const LabelRequest& other) {
                return &other != &request && overlaps(place, other.anchor);
            };
            return std::ranges::none_of(surroundings.solids, touches) &&
                   std::ranges::none_of(places, touches) &&
                   std::ranges::none_of(surroundings.disks, covers) &&
                   std::ranges::none_of(requests, coversOther);
        };
        const auto* const found = std::ranges::find_if(kSides, isFree);
        places.push_back(placeAt(found == kSides.end() ? kSides.front() : *found));
    }
    return places;
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
