#include "widgets/map/land/backdrop.h"

#include "widgets/map/land/clipping.h"
#include "widgets/theme/painter_state.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace berg {
namespace {

constexpr double kStep_deg = 0.5;    // sampling of edges, which are curved in the plane
constexpr double kClipMargin_px = 8; // hides the caps of clipped lines
constexpr double kDetail_px = 0.7;   // finer lines are left out
constexpr double kLine_px = 1.2;
constexpr double kPlace_px = 3;
constexpr float kFill = 0.12F; // opacity of polygons without their own colour
constexpr std::size_t kMostNames = 200;

/** Projects a line that is straight in latitude and longitude and takes the shorter direction. */
std::vector<Point> projected(const std::vector<LatLon>& places, const MapPlane& plane)
{
    std::vector<Point> points_m;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const LatLon& to = places[i];
        const LatLon& from = places[i == 0 ? 0 : i - 1];
        const double north_deg = to.latitude_deg - from.latitude_deg;
        const double east_deg = std::remainder(to.longitude_deg - from.longitude_deg, 360.0);
        const double steps = std::ceil(
            std::max({1.0, std::abs(north_deg) / kStep_deg, std::abs(east_deg) / kStep_deg}));
        for (double step = 1; step < steps; ++step)
            points_m.push_back(toPlane(plane, {from.latitude_deg + north_deg * step / steps,
                                               from.longitude_deg + east_deg * step / steps}));
        points_m.push_back(toPlane(plane, to));
    }
    return points_m;
}

QPolygonF onScreen(const std::vector<Point>& points_m, const MapViewTransform& view)
{
    QPolygonF line;
    for (const Point& point_m : points_m)
        if (const QPointF at = view.toPixel(point_m);
            line.size() < 2 || (at - line.back()).manhattanLength() >= kDetail_px)
            line << at;
    return line;
}

} // namespace

BackdropStyle backdropStyleOf(const Theme& theme)
{
    return {.ink = mixed(theme.sea, theme.ink, 0.6),
            .ground = theme.sea,
            .font = theme.small(),
            .isNight = theme.isNight};
}

BackdropDrawing::BackdropDrawing(BackdropPointer shapes, const MapPlane& plane)
    : m_shapes(std::move(shapes)), m_plane(plane)
{
    m_parts.reserve(m_shapes->size());
    for (const MapShape& shape : *m_shapes) {
        std::vector<BackdropPart>& parts = m_parts.emplace_back();
        for (const std::vector<LatLon>& places : shape.parts) {
            BackdropPart part{.points_m = projected(places, m_plane)};
            part.bounds = boundsOf(part.points_m);
            parts.push_back(std::move(part));
        }
    }
}

void BackdropDrawing::paint(QPainter& painter, const MapViewTransform& view, const QRectF& rect,
                            const BackdropStyle& style) const
{
    const QRectF wide =
        rect.adjusted(-kClipMargin_px, -kClipMargin_px, kClipMargin_px, kClipMargin_px);
    const WorldBounds visible = view.visible(wide);
    const PainterState saved(painter);
    painter.setClipRect(rect, Qt::IntersectClip);
    painter.setRenderHint(QPainter::Antialiasing);
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < m_parts.size(); ++i) {
        if (std::ranges::none_of(
                m_parts[i], [&](const BackdropPart& part) { return meet(part.bounds, visible); }))
            continue;
        if ((*m_shapes)[i].kind == MapShape::Kind::Place)
            places.push_back(i); // drawn above the others
        else
            paintShape(painter, i, view, wide, style);
    }
    paintPlaces(painter, places, view, style);
}

void BackdropDrawing::paintShape(QPainter& painter, std::size_t i, const MapViewTransform& view,
                                 const QRectF& wide, const BackdropStyle& style) const
{
    const MapShape& shape = (*m_shapes)[i];
    const bool isPolygon = shape.kind == MapShape::Kind::Polygon;
    QPainterPath area; // odd and even: holes are not filled
    QPainterPath edge;
    for (const BackdropPart& part : m_parts[i]) {
        const QPolygonF line = onScreen(part.points_m, view);
        if (isPolygon)
            area.addPolygon(clipped(line, wide));
        for (qsizetype k = isPolygon ? 0 : 1; k < line.size(); ++k)
            addClipped(edge, QLineF(k == 0 ? line.back() : line[k - 1], line[k]), wide);
    }
    const auto own = [&style](QRgb colour) {
        const QColor given = QColor::fromRgba(colour);
        return style.isNight ? Theme::night().toned(given) : given;
    };
    QColor fill = style.ink;
    fill.setAlphaF(kFill);
    if (isPolygon)
        painter.fillPath(area, shape.fill ? own(*shape.fill) : fill);
    painter.strokePath(edge, QPen(shape.line ? own(*shape.line) : style.ink, kLine_px,
                                  Qt::SolidLine, Qt::FlatCap, Qt::BevelJoin));
}

void BackdropDrawing::paintPlaces(QPainter& painter, const std::vector<std::size_t>& places,
                                  const MapViewTransform& view, const BackdropStyle& style) const
{
    const QFontMetricsF metrics(style.font);
    for (const std::size_t i : places) {
        const QPointF at = view.toPixel(m_parts[i].front().points_m.front());
        painter.setPen(QPen(style.ground, 1));
        painter.setBrush(style.ink);
        painter.drawEllipse(at, kPlace_px, kPlace_px);
        const QString name = QString::fromStdString((*m_shapes)[i].name);
        if (name.isEmpty() || places.size() > kMostNames)
            continue;
        QPainterPath text;
        text.addText(at + QPointF(2 * kPlace_px, metrics.ascent() / 2 - 1), style.font, name);
        painter.strokePath(text, QPen(style.ground, 3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.fillPath(text, style.ink);
    }
}

} // namespace berg
