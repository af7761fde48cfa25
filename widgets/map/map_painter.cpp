#include "widgets/map/map_painter.h"

#include "core/base/random.h"
#include "widgets/map/map_sprites.h"
#include "widgets/map/map_symbols.h"
#include "widgets/map/painter_state.h"
#include "widgets/theme/quantity_text.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kOldestTrack = 0.2; // share of the track's colour left at its oldest end
constexpr int kTrackShades = 40;
constexpr double kComparison_px = 1.2;      // thinner than the track
constexpr double kComparisonMarks_px = 150; // between its arrow heads
constexpr double kComparisonMark_px = 9;

constexpr double kArrowRoom_px = 60; // that a drift arrow may take beside its symbol
constexpr double kSigmaSteps = 250;  // of the colour of kept drawings
constexpr double kRingSteps = 4;     // for each pixel, of the rings of kept drawings

struct Paint
{
    QPainter& painter;
    const MapPicture& picture;
    const MapStyle& style;
    const MapLayout& layout;
    const Theme& theme;
    const Graticule& graticule;
    MapSprites* sprites;

    Paint(QPainter& target, const MapFrame& frame)
        : painter(target)
        , picture(frame.picture)
        , style(frame.style)
        , layout(frame.layout)
        , theme(frame.style.theme)
        , graticule(frame.graticule)
        , sprites(frame.sprites)
    {
        painter.save();
        painter.setClipRect(layout.rect, Qt::IntersectClip);
        painter.setRenderHint(QPainter::Antialiasing);
    }
    ~Paint() { painter.restore(); }
    Paint(const Paint&) = delete;
    Paint& operator=(const Paint&) = delete;
};

/** Draws round `at`, by way of the kept drawings when there are any. */
void paintKept(const Paint& p, const QString& key, const QRectF& bounds, const QPointF& at,
               const std::function<void(QPainter&)>& draw)
{
    if (p.sprites != nullptr) {
        p.sprites->paint(p.painter, key, bounds, at, draw);
        return;
    }
    const PainterState saved(p.painter);
    p.painter.translate(at);
    draw(p.painter);
}

/** Where a path crosses the inside of an edge of the map, to label it there. */
std::optional<QPointF> crossing(const QPolygonF& path, const QLineF& edge)
{
    for (int i = 0; i + 1 < path.size(); ++i) {
        QPointF at;
        if (QLineF(path[i], path[i + 1]).intersects(edge, &at) == QLineF::BoundedIntersection)
            return at;
    }
    return std::nullopt;
}

void paintGraticuleLabels(const Paint& p)
{
    const Graticule& graticule = p.graticule;
    p.painter.setFont(p.theme.small());
    const QFontMetricsF metrics(p.theme.small());
    const QRectF& rect = p.layout.rect;
    // Longitudes along the upper edge, latitudes along the right one; never under an overlay.
    const QLineF top(rect.left(), rect.top() + 11, rect.right(), rect.top() + 11);
    const QLineF right(rect.right() - 6, rect.top(), rect.right() - 6, rect.bottom());
    std::vector<QRectF> taken = p.layout.overlays();
    for (const PlacedLabel& label : p.layout.labels)
        taken.push_back(label.rect);
    for (const LabelDisk& disk : p.layout.icebergs)
        taken.emplace_back(disk.centre_px.x() - disk.radius_px, disk.centre_px.y() - disk.radius_px,
                           2 * disk.radius_px, 2 * disk.radius_px);
    for (const GraticuleLine& line : graticule.lines) {
        const std::optional<QPointF> at = crossing(line.path_px, line.isMeridian ? top : right);
        if (!at)
            continue;
        const QString text =
            line.isMeridian
                ? longitudeText(line.value_deg, graticule.longitudeDecimals, p.style.locale)
                : latitudeText(line.value_deg, graticule.latitudeDecimals, p.style.locale);
        const QSizeF size(metrics.horizontalAdvance(text) + 2, metrics.height());
        const QRectF box(
            line.isMeridian ? QPointF(at->x() - size.width() / 2, rect.top() + 5)
                            : QPointF(rect.right() - size.width() - 6, at->y() - size.height() / 2),
            size);
        const QRectF wide = box.adjusted(-4, -2, 4, 2);
        const bool clear =
            rect.contains(box) && std::none_of(taken.begin(), taken.end(),
                                               [&](const QRectF& r) { return r.intersects(wide); });
        if (!clear)
            continue;
        taken.push_back(wide);
        paintKept(p, u"graticule "_s + text, QRectF(QPointF(-3, -3), size + QSizeF(6, 6)),
                  box.topLeft(), [&](QPainter& painter) {
                      painter.setFont(p.theme.small());
                      drawHaloText(painter, QRectF(QPointF(0, 0), size), Qt::AlignCenter, text,
                                   p.theme.graticuleText, p.theme.sea);
                  });
    }
}

void paintTrack(const Paint& p)
{
    const std::vector<MapTrackPoint>& track = p.picture.track;
    if (track.size() < 2)
        return;
    const double from_s = track.front().time_s;
    const double span_s = std::max(1e-9, track.back().time_s - from_s);
    const auto shadeOf = [&](double time_s) {
        return static_cast<int>((time_s - from_s) / span_s * (kTrackShades - 1));
    };
    p.painter.setBrush(Qt::NoBrush);
    QPolygonF piece{p.layout.view.toPixel(track.front().position_m)};
    int shade = 0;
    const auto flush = [&] {
        // Mixed with the sea instead of translucent: crossings would add up otherwise. Round joins
        // look the same on so thin a line, but take most of the time of a frame.
        const double share =
            kOldestTrack + (1 - kOldestTrack) * static_cast<double>(shade) / (kTrackShades - 1);
        p.painter.setPen(QPen(mixed(p.theme.sea, p.theme.track, share), 1.6, Qt::SolidLine,
                              Qt::FlatCap, Qt::BevelJoin));
        p.painter.drawPolyline(piece);
    };
    for (const MapTrackPoint& point : track) {
        const QPointF at = p.layout.view.toPixel(point.position_m);
        const QPointF step = at - piece.back();
        if (QPointF::dotProduct(step, step) >= 1)
            piece << at;
        if (shadeOf(point.time_s) == shade)
            continue;
        flush();
        piece = QPolygonF{piece.back()};
        shade = shadeOf(point.time_s);
    }
    piece << p.layout.view.toPixel(track.back().position_m);
    flush();
}

/** One colour and arrow heads along the way: told from the flown track by shape too. */
void paintComparison(const Paint& p)
{
    const std::vector<MapTrackPoint>& track = p.picture.comparisonTrack;
    if (track.size() < 2)
        return;
    QPolygonF line{p.layout.view.toPixel(track.front().position_m)};
    std::vector<QLineF> marks;
    double sinceMark_px = kComparisonMarks_px / 2;
    for (const MapTrackPoint& point : track) {
        const QLineF step(line.back(), p.layout.view.toPixel(point.position_m));
        if (step.length() < 1)
            continue;
        line << step.p2();
        sinceMark_px += step.length();
        if (sinceMark_px >= kComparisonMarks_px && p.layout.rect.contains(step.p2())) {
            // Longer than the step: marks keep off lines too short for them.
            const QPointF reach = (step.p2() - step.p1()) / step.length() * 3 * kComparisonMark_px;
            marks.emplace_back(step.p2() - reach, step.p2() + reach);
            sinceMark_px = 0;
        }
    }
    p.painter.setBrush(Qt::NoBrush);
    p.painter.setPen(
        QPen(p.theme.comparison, kComparison_px, Qt::SolidLine, Qt::FlatCap, Qt::BevelJoin));
    p.painter.drawPolyline(line);
    for (const QLineF& mark : marks)
        drawDirectionMark(p.painter, mark, p.theme.comparison, kComparisonMark_px);
}

void paintArea(const Paint& p)
{
    if (p.picture.area_m.empty())
        return;
    QPolygonF outline;
    for (const Point& corner_m : p.picture.area_m)
        outline << p.layout.view.toPixel(corner_m);
    p.painter.setBrush(Qt::NoBrush);
    p.painter.setPen(QPen(p.theme.coast, 1.4, Qt::DashLine));
    p.painter.drawPolygon(outline);
}

void paintPlan(const Paint& p)
{
    const std::vector<QLineF> legs = planLegs(p.picture, p.layout);
    for (std::size_t k = legs.size(); k-- > 0;) {
        const bool isNext = k == 0;
        const double width_px = isNext ? 3.2 : 1.6;
        if (legs[k].isNull())
            continue;
        // A rim of sea sets the line off from the track below.
        p.painter.setPen(QPen(p.theme.sea, width_px + 2.4, Qt::SolidLine, Qt::FlatCap));
        p.painter.drawLine(legs[k]);
        p.painter.setPen(QPen(p.theme.plan, width_px, Qt::SolidLine, Qt::FlatCap));
        p.painter.drawLine(legs[k]);
        drawDirectionMark(p.painter, legs[k], p.theme.plan, isNext ? 13 : 10);
    }
}

void paintFieldOfView(const Paint& p)
{
    if (!p.picture.uav)
        return;
    QColor fill = p.theme.uav;
    fill.setAlphaF(0.09F);
    p.painter.setPen(QPen(p.theme.uav, 1.6, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    p.painter.setBrush(fill);
    p.painter.drawPolygon(fieldOutline(*p.picture.uav, p.layout.view));
}

/** Kept drawings come in steps too fine to see, so that slow growth can use them. */
void roundForKeeping(double& ring_px, double& sigma)
{
    ring_px = std::round(ring_px * kRingSteps) / kRingSteps;
    sigma = std::round(sigma * kSigmaSteps) / kSigmaSteps;
}

void paintIcebergs(const Paint& p)
{
    for (std::size_t i = 0; i < p.picture.icebergs.size(); ++i) {
        const LabelDisk& disk = p.layout.icebergs[i];
        if (!overlaps(p.layout.rect,
                      {.centre_px = disk.centre_px, .radius_px = disk.radius_px + kArrowRoom_px}))
            continue;
        const MapIceberg& iceberg = p.picture.icebergs[i];
        const double symbol_px = icebergSymbolRadius_px(iceberg.radius_m);
        double ring_px = p.layout.symbols.ringRadius_px(symbol_px, iceberg.sigma_m2);
        double sigma = std::clamp(iceberg.sigma_m2 / p.picture.sigmaFull_m2, 0.0, 1.0);
        if (p.sprites != nullptr)
            roundForKeeping(ring_px, sigma);
        // Neighbours differ in form; the id decides, so that a form stays with its iceberg.
        const auto variant = static_cast<unsigned>(stableHash(iceberg.id.toStdString()) % 6);
        const IcebergLook look{.radius_px = symbol_px,
                               .ring_px = ring_px,
                               .sigma = p.theme.sigma.at(sigma),
                               .inView = iceberg.inView,
                               .later = iceberg.appears_s > 0,
                               .variant = variant};
        const QString key = u"ice %1 %2 %3 %4 %5"_s.arg(symbol_px)
                                .arg(ring_px)
                                .arg(sigma)
                                .arg(int(look.inView) + 2 * int(look.later))
                                .arg(variant);
        const double reach_px = std::max(symbol_px + 7, ring_px) + 2;
        paintKept(p, key, QRectF(-reach_px, -reach_px, 2 * reach_px, 2 * reach_px), disk.centre_px,
                  [&](QPainter& painter) {
                      drawIceberg(painter, {0, 0}, look, p.theme);
                  });
        const QLineF arrow = driftArrow(p.picture, p.layout, i);
        if (!arrow.isNull())
            drawArrow(p.painter, arrow, QPen(p.theme.ink, 1.5), 7);
    }
}

void paintLabel(const Paint& p, std::size_t i)
{
    const PlacedLabel& label = p.layout.labels[i];
    if (label.rect.isNull())
        return;
    const LabelDisk& disk = p.layout.icebergs[i];
    if (label.apart) {
        const QPointF near(std::clamp(disk.centre_px.x(), label.rect.left(), label.rect.right()),
                           std::clamp(disk.centre_px.y(), label.rect.top(), label.rect.bottom()));
        const QLineF way(disk.centre_px, near);
        p.painter.setPen(QPen(p.theme.graticuleText, 1));
        p.painter.drawLine(way.pointAt(std::min(1.0, disk.radius_px / way.length())), near);
    }
    const QString text = labelText(p.picture.icebergs[i]);
    const int order = p.layout.order[i];
    const QSizeF size = label.rect.size();
    const auto draw = [&](QPainter& painter) {
        QRectF box(QPointF(0, 0), size);
        if (order > 0) {
            drawOrderDisk(painter, {kOrderDisk_px, box.center().y()}, kOrderDisk_px, order,
                          p.theme);
            box.setLeft(2 * kOrderDisk_px + kOrderGap_px);
        }
        painter.setFont(labelFont(p.theme));
        drawHaloText(painter, box, Qt::AlignLeft | Qt::AlignVCenter, text, p.theme.text,
                     p.theme.sea);
    };
    paintKept(p, u"label %1 "_s.arg(order) + text, QRectF(QPointF(-3, -3), size + QSizeF(8, 6)),
              label.rect.topLeft(), draw);
}

void paintAsset(const Paint& p)
{
    if (!p.picture.asset)
        return;
    const QPointF at = p.layout.view.toPixel(p.picture.asset->position_m);
    drawAsset(p.painter, at, p.theme);
    p.painter.setFont(labelFont(p.theme));
    drawHaloText(p.painter, QRectF(at.x() - 100, at.y() + 11, 200, 18), Qt::AlignHCenter,
                 p.picture.asset->name, p.theme.text, p.theme.sea);
}

/** What the look of the legend depends on. */
QString legendKey(const Paint& p)
{
    const auto any = [&](const auto& test) {
        return std::any_of(p.picture.icebergs.begin(), p.picture.icebergs.end(), test);
    };
    const bool inView = any([](const MapIceberg& iceberg) { return iceberg.inView; });
    const bool later = any([](const MapIceberg& iceberg) { return iceberg.appears_s > 0; });
    return u"legend %1 %2 %3 %4%5%6%7%8 %9 "_s.arg(p.layout.symbols.ring_pxpm)
               .arg(p.layout.symbols.driftTime_s)
               .arg(p.picture.sigmaFull_m2)
               .arg(int(inView))
               .arg(int(later))
               .arg(int(!p.picture.plan.empty()))
               .arg(int(p.picture.track.size() > 1))
               .arg(int(p.picture.uav.has_value()))
               .arg(p.style.locale.name()) + // last, the one text of the user's
           (p.picture.comparisonTrack.size() > 1 ? p.picture.comparisonName : QString());
}

void paintOverlays(const Paint& p, double north_rad)
{
    const auto panel = [&](const QRectF& rect, const QString& key, const auto& draw) {
        const QRectF bounds(QPointF(0, 0), rect.size());
        if (!rect.isNull())
            paintKept(p, key, bounds, rect.topLeft(),
                      [&](QPainter& painter) { draw(painter, bounds); });
    };
    panel(p.layout.legend, legendKey(p), [&](QPainter& painter, const QRectF& rect) {
        paintLegend(painter, rect, p.picture, p.style, p.layout.symbols);
    });
    panel(p.layout.scaleBar,
          u"scale %1 %2"_s.arg(p.layout.view.scale_pxpm()).arg(p.style.locale.name()),
          [&](QPainter& painter, const QRectF& rect) {
              paintScaleBar(painter, rect, p.layout.view, p.style);
          });
    panel(p.layout.north, u"north %1"_s.arg(north_rad, 0, 'f', 3),
          [&](QPainter& painter, const QRectF& rect) {
              paintNorthArrow(painter, rect, north_rad, p.style);
          });
    if (!p.layout.title.isNull())
        paintTitle(p.painter, p.layout.title, p.picture, p.style);
    if (!p.picture.icebergs.empty())
        return;
    const double top = std::max(p.layout.title.bottom(), p.layout.rect.top()) + 6;
    paintEmptyState(p.painter, p.layout.rect.adjusted(0, top - p.layout.rect.top(), 0, -6),
                    p.picture, p.style);
}

} // namespace

void paintMapGround(QPainter& painter, const MapFrame& frame)
{
    const Paint p(painter, frame);
    painter.fillRect(p.layout.rect, p.theme.sea);
    painter.setPen(QPen(p.theme.graticule, 1));
    for (const GraticuleLine& line : p.graticule.lines)
        painter.drawPolyline(line.path_px);
}

void paintMapContent(QPainter& painter, const MapFrame& frame)
{
    const Paint p(painter, frame);
    paintArea(p);
    paintComparison(p);
    paintTrack(p);
    paintFieldOfView(p);
    paintPlan(p);
    paintIcebergs(p);
    paintAsset(p);
    if (p.picture.uav)
        drawUav(painter, p.layout.view.toPixel(p.picture.uav->position_m), p.picture.uav->psi_rad,
                p.theme);
}

void paintMapLabels(QPainter& painter, const MapFrame& frame)
{
    const Paint p(painter, frame);
    for (std::size_t i = 0; i < p.picture.icebergs.size(); ++i)
        paintLabel(p, i);
    paintGraticuleLabels(p);
}

void paintMapOverlays(QPainter& painter, const MapFrame& frame)
{
    const Paint p(painter, frame);
    const LocalFrame plane(p.picture.origin);
    paintOverlays(p, northAngle_rad(plane, p.layout.view.toWorld(p.layout.rect.center())));
}

void paintMap(QPainter& painter, const MapPicture& picture, const MapStyle& style,
              const MapLayout& layout)
{
    const Graticule graticule = graticuleOf(LocalFrame(picture.origin), layout.view, layout.rect);
    const MapFrame frame{
        .picture = picture, .style = style, .layout = layout, .graticule = graticule};
    paintMapGround(painter, frame);
    paintMapContent(painter, frame);
    paintMapLabels(painter, frame);
    paintMapOverlays(painter, frame);
}

QImage mapImage(const MapPicture& picture, const MapStyle& style, const QSize& size_px,
                double scale)
{
    QImage image(size_px, QImage::Format_RGB32);
    image.setDevicePixelRatio(scale);
    QPainter painter(&image);
    const QRectF rect(QPointF(0, 0), QSizeF(size_px) / scale);
    paintMap(painter, picture, style, arrangeMap(picture, style, rect));
    return image;
}

} // namespace berg
