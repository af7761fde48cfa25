#include "widgets/map/paint/map_surroundings.h"

#include "core/geometry/geometry.h"
#include "core/scenario/limits.h"
#include "widgets/map/paint/map_legs.h"
#include "widgets/map/paint/map_paint.h"
#include "widgets/map/paint/map_symbols.h"
#include "widgets/map/picture/plan_stops.h"
#include "widgets/map/picture/route_colours.h"
#include "widgets/theme/palette.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainterPath>
#include <QPainterPathStroker>

#include <algorithm>
#include <array>

namespace berg {
namespace {

struct MapWorld
{
    Q_DECLARE_TR_FUNCTIONS(MapWorld)
};

constexpr double kClusterGap_px = 6; // between a symbol and the cluster's outline

void paintFence(const MapPaint& p, const std::vector<Point>& corners_m)
{
    // Posts stand to the right of the direction of travel: inside for clockwise corners.
    const bool isClockwise = signedArea(corners_m) < 0;
    for (std::size_t i = 0; i < corners_m.size(); ++i) {
        const QLineF side(p.layout.view.toPixel(corners_m[i]),
                          p.layout.view.toPixel(corners_m[(i + 1) % corners_m.size()]));
        drawFence(p.painter, isClockwise ? side : QLineF(side.p2(), side.p1()), p.theme);
    }
}

/** Draws the outer ring dashed and the inner ring solid. */
void paintRings(const MapPaint& p, const MapAsset& asset)
{
    const QPointF at = p.layout.view.toPixel(asset.position_m);
    const double scale_pxpm = p.layout.view.scale_pxpm();
    p.painter.setBrush(Qt::NoBrush);
    p.painter.setPen(rangeRingPen(p.theme));
    p.painter.drawEllipse(at, asset.range_m * scale_pxpm, asset.range_m * scale_pxpm);
    p.painter.setPen(alarmRingPen(p.theme));
    p.painter.drawEllipse(at, asset.alarm_m * scale_pxpm, asset.alarm_m * scale_pxpm);
}

/** Outline of the symbols of the members, like a taut string around them. */
QPainterPath outlineOf(const MapLayout& layout, const MapPlaces& members)
{
    QPainterPath outline;
    QPolygonF centres;
    double widest_px = 0;
    for (const MapPlace member : members) {
        const LabelDisk& disk = layout.icebergs[toIndex(member)];
        centres << disk.centre_px;
        widest_px = std::max(widest_px, disk.radius_px);
    }
    // Joining all pairs covers the edges of the convex hull.
    for (const QPointF& from : centres)
        for (const QPointF& to : centres) {
            outline.moveTo(from);
            outline.lineTo(to);
        }
    QPainterPathStroker stroker;
    stroker.setWidth(2 * (widest_px + kClusterGap_px));
    stroker.setCapStyle(Qt::RoundCap);
    stroker.setJoinStyle(Qt::RoundJoin);
    return stroker.createStroke(outline).simplified();
}

/** Colour of the plan that contains the first member. */
QColor clusterColour(const MapPaint& p, const MapPlaces& members)
{
    const MapStop& stop = p.layout.stops[toIndex(members.front())];
    return stop.order ? routeColours(p.picture, p.theme, stop.uav).plan : p.theme.plan;
}

/** Draws an outline around both UAVs with an alarm in the middle. */
void paintPairTooClose(const MapPaint& p, const QLineF& path)
{
    constexpr double kReach_px = 22;
    QPainterPath line(path.p1());
    line.lineTo(path.p2() + QPointF(0.01, 0)); // also outlines two UAVs at one place
    QPainterPathStroker stroker;
    stroker.setWidth(2 * kReach_px);
    stroker.setCapStyle(Qt::RoundCap);
    p.painter.setBrush(Qt::NoBrush);
    p.painter.setPen(QPen(p.theme.sea, 4.4));
    p.painter.drawPath(stroker.createStroke(line));
    p.painter.setPen(alarmRingPen(p.theme, 2.2));
    p.painter.drawPath(stroker.createStroke(line));
    p.painter.drawLine(path);
    drawAlarm(p.painter, path.center() - QPointF(0, kReach_px), p.theme);
}

} // namespace

AreaNames::AreaNames(const MapPaint& p) : m_p(p), m_taken(p.layout.overlays())
{
    for (const PlacedLabel& label : p.layout.labels)
        if (!label.rect.isNull())
            m_taken.push_back(label.rect);
    for (const MapPlaceName& name : p.layout.places)
        m_taken.push_back(name.rect);
    constexpr QSizeF kUav_px(40, 40);
    constexpr QSizeF kAsset_px(100, 60); // includes its name below
    const auto reserveAt = [&](const Point& place_m, const QSizeF& size_px) {
        QRectF taken(QPointF(0, 0), size_px);
        taken.moveCenter(p.layout.view.toPixel(place_m));
        m_taken.push_back(taken);
    };
    for (const MapUav& uav : p.picture.uavs)
        reserveAt(uav.position_m, kUav_px);
    if (p.picture.asset)
        reserveAt(p.picture.asset->position_m, kAsset_px);
}

bool AreaNames::isFree(const QRectF& label) const
{
    return std::ranges::none_of(m_taken,
                                [&](const QRectF& one) { return one.intersects(label); }) &&
           std::ranges::none_of(m_p.layout.icebergs,
                                [&](const LabelDisk& iceberg) { return overlaps(label, iceberg); });
}

void AreaNames::paint(const QRectF& shown, const std::array<QString, 2>& lines,
                      const std::array<double, 5>& shares)
{
    constexpr double kLine_px = 17;
    constexpr double kEdge_px = 4;
    const QFontMetricsF metrics(m_p.painter.font());
    const QSizeF size_px(
        std::max(metrics.horizontalAdvance(lines[0]), metrics.horizontalAdvance(lines[1])),
        2 * kLine_px);
    const QRectF room = shown.adjusted(0, kEdge_px, -size_px.width(), -size_px.height());
    for (const double down : shares)
        for (const double across : {0.5, 0.25, 0.75, 0.05, 0.95}) {
            const QRectF label(QPointF(room.left() + across * room.width(),
                                       room.top() + down * std::max(0.0, room.height())),
                               size_px);
            if (!isFree(label))
                continue;
            for (std::size_t i = 0; i < lines.size(); ++i)
                drawHaloText(m_p.painter,
                             QRectF(label.left(), label.top() + static_cast<double>(i) * kLine_px,
                                    label.width(), kLine_px),
                             Qt::AlignCenter, lines[i], m_p.theme.text, m_p.theme.sea);
            m_taken.push_back(label);
            return;
        }
}

void paintArea(const MapPaint& p)
{
    if (p.picture.area_m.empty())
        return;
    if (p.picture.isFenced) {
        paintFence(p, p.picture.area_m);
        return;
    }
    p.painter.setBrush(Qt::NoBrush);
    p.painter.setPen(QPen(p.theme.coast, 1.4, Qt::DashLine));
    p.painter.drawPolygon(p.layout.view.toPixels(p.picture.area_m));
}

void paintClosedAreas(const MapPaint& p, AreaNames& names)
{
    p.painter.setFont(labelFont(p.theme));
    for (const MapClosedArea& area : p.picture.closed) {
        const QPolygonF outline = p.layout.view.toPixels(area.corners_m);
        const QRectF shown = outline.boundingRect() & p.layout.rect;
        if (shown.isEmpty())
            continue;
        drawClosed(p.painter, outline, p.layout.rect, p.theme);
        if (area.isRing)
            continue; // the asset bears the name
        names.paint(shown, {area.name, heightsText(area.floor_m, area.ceiling_m, p.style.locale)},
                    {0.5, 0.3, 0.7, 0.1, 0.9});
        names.reserve(shown); // a name inside would seem to belong to this area
    }
}

QPen volumePen(VolumePart part, const Theme& theme)
{
    switch (part) {
    case VolumePart::Geography:
        return {theme.plan, 1.6, Qt::SolidLine};
    case VolumePart::Contingency:
        return {theme.warning, 1.6, Qt::DashLine};
    case VolumePart::Buffer:
        return {theme.alarm, 1.6, Qt::DashDotLine};
    case VolumePart::Adjacent:
        break;
    }
    return {theme.mutedText, 1.4, Qt::DotLine};
}

QPen airspacePen(const Theme& theme)
{
    // Purple as on charts; red is used for the compared run.
    return {theme.toned(theme.isDark ? 0xc99cf5 : 0x7a3ea8), 1.4, Qt::DashDotDotLine};
}

void paintPermit(const MapPaint& p, AreaNames& names)
{
    p.painter.setBrush(Qt::NoBrush);
    p.painter.setFont(labelFont(p.theme));
    for (const MapAirspace& area : p.picture.airspace) {
        const QPolygonF outline = p.layout.view.toPixels(area.corners_m);
        const QRectF shown = outline.boundingRect() & p.layout.rect;
        if (shown.isEmpty())
            continue;
        p.painter.setPen(airspacePen(p.theme));
        p.painter.drawPolygon(outline);
        names.paint(shown, {area.title, heightsText(area.floor_m, area.ceiling_m, p.style.locale)},
                    {0, 1, 0.25, 0.5, 0.75});
    }
    for (std::size_t part = 0; p.picture.operation && part < kVolumeParts; ++part) {
        p.painter.setPen(volumePen(static_cast<VolumePart>(part), p.theme));
        p.painter.drawPolygon(p.layout.view.toPixels(p.picture.operation->outlines_m[part]));
    }
}

void paintHomes(const MapPaint& p)
{
    for (std::size_t uav = 0; uav < p.picture.uavs.size(); ++uav)
        if (const std::optional<Point>& home_m = p.picture.uavs[uav].home_m)
            drawHome(p.painter, p.layout.view.toPixel(*home_m),
                     routeColours(p.picture, p.theme, uav).home, p.theme);
}

void paintAsset(const MapPaint& p)
{
    if (!p.picture.asset)
        return;
    paintRings(p, *p.picture.asset);
    const QPointF at = p.layout.view.toPixel(p.picture.asset->position_m);
    drawAsset(p.painter, at, p.theme);
    p.painter.setFont(labelFont(p.theme));
    drawHaloText(p.painter, QRectF(at.x() - 100, at.y() + 11, 200, 18), Qt::AlignHCenter,
                 p.picture.asset->name, p.theme.text, p.theme.sea);
}

void paintStation(const MapPaint& p)
{
    if (!p.picture.station)
        return;
    const QPointF at = p.layout.view.toPixel(p.picture.station->position_m);
    p.painter.setBrush(Qt::NoBrush);
    p.painter.setPen(linkRingPen(p.theme));
    for (const double range_m : p.picture.station->ranges_m) {
        const double radius_px = range_m * p.layout.view.scale_pxpm();
        p.painter.drawEllipse(at, radius_px, radius_px);
    }
    drawStation(p.painter, at, p.theme);
}

void paintNoReturns(const MapPaint& p)
{
    p.painter.setFont(labelFont(p.theme));
    for (std::size_t uav = 0; uav < p.picture.routes.size(); ++uav) {
        const QPolygonF path = p.layout.view.toPixels(p.picture.routes[uav].toNoReturn_m);
        if (path.isEmpty())
            continue;
        const QColor colour = uavColour(p.theme, p.picture.uavs[uav].place);
        p.painter.setPen(QPen(colour, 1.2, Qt::DotLine));
        p.painter.drawPolyline(path);
        const QPointF at = path.back();
        drawNoReturn(p.painter, at, colour, p.theme);
        drawHaloText(p.painter, QRectF(at.x() - 30, at.y() - 22, 60, 16), Qt::AlignHCenter,
                     MapWorld::tr("PNR"), p.theme.text, p.theme.sea);
    }
}

void paintClusters(const MapPaint& p)
{
    for (const MapPlaces& members : p.picture.clusters) {
        if (members.size() < 2)
            continue;
        const QColor colour = clusterColour(p, members);
        QColor fill = colour;
        fill.setAlphaF(0.07F);
        p.painter.setBrush(fill);
        p.painter.setPen(clusterPen(colour));
        p.painter.drawPath(outlineOf(p.layout, members));
        drawAim(p.painter, p.layout.view.toPixel(middleOf_m(p.picture, members)), colour, p.theme);
    }
}

void paintCircles(const MapPaint& p)
{
    p.painter.setBrush(Qt::NoBrush);
    p.painter.setPen(circlePen(p.theme));
    for (std::size_t i = 0; i < p.picture.icebergs.size(); ++i) {
        const MapIceberg& iceberg = p.picture.icebergs[i];
        if (!iceberg.circle_m || p.layout.density.marks[i] != IcebergMark::Symbol)
            continue; // circles around all dots would hide a dense field
        const double radius_px = *iceberg.circle_m * p.layout.view.scale_pxpm();
        const LabelDisk circle{.centre_px = p.layout.view.toPixel(iceberg.position_m),
                               .radius_px = radius_px};
        if (radius_px > icebergSymbolRadius_px(iceberg.radius_m) && overlaps(p.layout.rect, circle))
            p.painter.drawEllipse(circle.centre_px, radius_px, radius_px);
    }
}

void paintTruths(const MapPaint& p)
{
    for (const MapIceberg& iceberg : p.picture.icebergs) {
        if (!iceberg.truth_m)
            continue;
        const QLineF path(p.layout.view.toPixel(iceberg.position_m),
                          p.layout.view.toPixel(*iceberg.truth_m));
        if (path.length() < icebergSymbolRadius_px(iceberg.radius_m))
            continue; // the places coincide at this scale
        p.painter.setPen(QPen(p.theme.ink, 1, Qt::DotLine));
        p.painter.drawLine(path);
        drawTruth(p.painter, path.p2(), p.theme);
    }
}

void paintAlarms(const MapPaint& p)
{
    for (std::size_t i = 0; i < p.picture.icebergs.size(); ++i) {
        const MapIceberg& iceberg = p.picture.icebergs[i];
        if (!iceberg.ringEntry_s)
            continue;
        const double beside_px = icebergSymbolRadius_px(iceberg.radius_m);
        drawAlarm(p.painter, p.layout.icebergs[i].centre_px + QPointF(beside_px, -beside_px),
                  p.theme);
    }
}

void paintPins(const MapPaint& p)
{
    for (std::size_t i = 0; i < p.picture.icebergs.size(); ++i) {
        const MapIceberg& iceberg = p.picture.icebergs[i];
        if (!iceberg.assignedUav)
            continue;
        const double beside_px = 0.7 * icebergSymbolRadius_px(iceberg.radius_m);
        drawPin(p.painter, p.layout.icebergs[i].centre_px - QPointF(beside_px, beside_px),
                uavColour(p.theme, *iceberg.assignedUav), p.theme);
    }
}

std::vector<std::pair<std::size_t, std::size_t>> pairsTooClose(const MapPicture& picture)
{
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t a = 0; a < picture.uavs.size(); ++a)
        for (std::size_t b = a + 1; b < picture.uavs.size(); ++b) {
            const MapUav& one = picture.uavs[a];
            const MapUav& other = picture.uavs[b];
            if (one.isAloft && other.isAloft &&
                std::abs(one.altitude_m - other.altitude_m) < kLayerHeight_m &&
                (one.position_m - other.position_m).norm() < picture.separation_m)
                pairs.emplace_back(a, b);
        }
    return pairs;
}

void paintTooClose(const MapPaint& p)
{
    for (const auto& [a, b] : pairsTooClose(p.picture))
        paintPairTooClose(p, {p.layout.view.toPixel(p.picture.uavs[a].position_m),
                              p.layout.view.toPixel(p.picture.uavs[b].position_m)});
}

} // namespace berg
