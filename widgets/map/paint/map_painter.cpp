#include "widgets/map/paint/map_painter.h"

#include "core/base/random.h"
#include "widgets/map/land/land_layer.h"
#include "widgets/map/paint/map_dots.h"
#include "widgets/map/paint/map_drift.h"
#include "widgets/map/paint/map_legend_rows.h"
#include "widgets/map/paint/map_marks.h"
#include "widgets/map/paint/map_paint.h"
#include "widgets/map/paint/map_paths.h"
#include "widgets/map/paint/map_sprites.h"
#include "widgets/map/paint/map_surroundings.h"
#include "widgets/map/paint/map_symbols.h"
#include "widgets/map/paint/map_weather_layer.h"
#include "widgets/map/paint/wind_panel.h"
#include "widgets/map/picture/route_colours.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/painter_state.h"
#include "widgets/theme/palette.h"
#include "widgets/theme/quantity_text.h"

#include <QFontMetricsF>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kLeastArrow = 0.2; // opacity of an arrow being drawn while the layer is hidden
constexpr double kSigmaSteps = 250; // number of colours of cached drawings
constexpr double kRingSteps = 4;    // ring sizes per pixel of cached drawings

/** Draws a layer with the user's opacity; a hidden one is skipped. */
template <class Draw>
void withOpacity(const MapPaint& p, double opacity, const Draw& draw)
{
    if (opacity <= 0)
        return;
    const double before = p.painter.opacity();
    p.painter.setOpacity(before * opacity);
    draw();
    p.painter.setOpacity(before);
}

void paintGraticuleLabels(const MapPaint& p)
{
    std::vector<QRectF> taken = p.layout.overlays();
    for (const PlacedLabel& label : p.layout.labels)
        taken.push_back(label.rect);
    taken.insert(taken.end(), p.layout.uavLabels.begin(), p.layout.uavLabels.end());
    for (const MapPlaceName& name : p.layout.places)
        taken.push_back(name.rect);
    for (const LabelDisk& disk : p.layout.icebergs)
        taken.emplace_back(disk.centre_px.x() - disk.radius_px, disk.centre_px.y() - disk.radius_px,
                           2 * disk.radius_px, 2 * disk.radius_px);
    for (const GraticuleLabel& label :
         graticuleLabels(p.graticule, p.layout.rect, QFontMetricsF(p.theme.small()), p.style.locale,
                         std::move(taken))) {
        const QSizeF size = label.rect.size();
        paintCached(p, u"graticule "_s + label.text, QRectF(QPointF(-3, -3), size + QSizeF(6, 6)),
                    label.rect.topLeft(), [&](QPainter& painter) {
                        painter.setFont(p.theme.small());
                        drawHaloText(painter, QRectF(QPointF(0, 0), size), Qt::AlignCenter,
                                     label.text, p.theme.graticuleText, p.theme.sea);
                    });
    }
}

/** Rounds to steps too fine to see, so that slowly growing symbols can use cached drawings. */
void roundForCache(double& ring_px, double& sigma)
{
    ring_px = std::round(ring_px * kRingSteps) / kRingSteps;
    sigma = std::round(sigma * kSigmaSteps) / kSigmaSteps;
}

void paintIcebergs(const MapPaint& p)
{
    for (std::size_t i = 0; i < p.picture.icebergs.size(); ++i) {
        const LabelDisk& disk = p.layout.icebergs[i];
        if (p.layout.density.marks[i] != IcebergMark::Symbol ||
            !overlaps(p.layout.rect,
                      {.centre_px = disk.centre_px, .radius_px = disk.radius_px + kCappedArrow_px}))
            continue;
        const MapIceberg& iceberg = p.picture.icebergs[i];
        const bool isSmall = p.layout.density.isCrowded;
        const double symbol_px =
            isSmall ? kSmallIceberg_px : icebergSymbolRadius_px(iceberg.radius_m);
        double ring_px = isSmall ? 0 : p.layout.symbols.ringRadius_px(symbol_px, iceberg.sigma_m2);
        double sigma = std::clamp(iceberg.sigma_m2 / p.picture.sigmaFull_m2, 0.0, 1.0);
        if (p.sprites != nullptr)
            roundForCache(ring_px, sigma);
        // Neighbours differ in form; the hash of the id keeps the form of an iceberg constant.
        const auto variant = static_cast<unsigned>(stableHash(iceberg.id.toStdString()) % 6);
        const IcebergStyle style{.radius_px = symbol_px,
                                 .ring_px = ring_px,
                                 .ringOpacity = p.style.layers.opacity(MapLayer::Rings),
                                 .sigma = p.theme.sigma.at(sigma),
                                 .inView = iceberg.inView,
                                 .bracket = routeColours(p.picture, p.theme).uav,
                                 .later = iceberg.appears_s > 0,
                                 .status = iceberg.status,
                                 .variant = variant};
        const QString key =
            u"ice %1 %2 %3 %4 %5 %6 %7"_s.arg(symbol_px)
                .arg(ring_px)
                .arg(sigma)
                .arg(int(style.inView) + 2 * int(style.later) + 4 * static_cast<int>(style.status))
                .arg(variant)
                .arg(style.bracket.rgb())
                .arg(style.ringOpacity);
        const double reach_px = std::max(symbol_px + 7, ring_px) + 2;
        paintCached(p, key, QRectF(-reach_px, -reach_px, 2 * reach_px, 2 * reach_px),
                    disk.centre_px, [&](QPainter& painter) {
                        drawIceberg(painter, {0, 0}, style, p.theme);
                    });
        const QLineF arrow = driftArrow(p.picture, p.layout, i);
        if (!arrow.isNull())
            withOpacity(p, std::max(p.style.layers.opacity(MapLayer::Drift), kLeastArrow), [&] {
                const Qt::PenStyle line = isCapped(arrow) ? Qt::DashLine : Qt::SolidLine;
                drawArrow(p.painter, arrow, QPen(p.theme.ink, 1.5, line), 7);
            });
    }
}

void paintLabel(const MapPaint& p, std::size_t i)
{
    const PlacedLabel& label = p.layout.labels[i];
    const double opacity = p.style.layers.opacity(MapLayer::Labels);
    if (label.rect.isNull() || (opacity <= 0 && !p.layout.stops[i].order))
        return;
    const LabelDisk& disk = p.layout.icebergs[i];
    if (label.needsLeader) {
        const QPointF near(std::clamp(disk.centre_px.x(), label.rect.left(), label.rect.right()),
                           std::clamp(disk.centre_px.y(), label.rect.top(), label.rect.bottom()));
        const QLineF path(disk.centre_px, near);
        p.painter.setPen(QPen(p.theme.graticuleText, 1));
        p.painter.drawLine(path.pointAt(std::min(1.0, disk.radius_px / path.length())), near);
    }
    const QString text = labelText(p.picture.icebergs[i], p.picture.times.clock);
    const MapStop& stop = p.layout.stops[i];
    const QColor ground = stop.order ? routeColours(p.picture, p.theme, stop.uav).plan : QColor();
    const QSizeF size = label.rect.size();
    const auto draw = [&](QPainter& painter) {
        QRectF box(QPointF(0, 0), size);
        if (stop.order) {
            drawOrderDisk(painter, {kOrderDisk_px, box.center().y()}, kOrderDisk_px, *stop.order,
                          p.theme, ground);
            box.setLeft(2 * kOrderDisk_px + kOrderGap_px);
        }
        for (std::size_t k = 0; k < std::min(stop.later.size(), kMostLater); ++k) {
            const double right = size.width() - kLaterDisk_px;
            const double step_px = 2 * kLaterDisk_px + kLaterGap_px;
            const auto behind =
                static_cast<double>(std::min(stop.later.size(), kMostLater) - 1 - k);
            paintLaterDisk(painter, {right - behind * step_px, box.center().y()}, stop.later[k],
                           ground, p.theme);
        }
        if (opacity <= 0)
            return; // order numbers belong to the plan and stay
        painter.setOpacity(painter.opacity() * opacity);
        painter.setFont(labelFont(p.theme));
        drawHaloText(painter, box, Qt::AlignLeft | Qt::AlignVCenter, text, p.theme.text,
                     p.theme.sea);
    };
    QString key = u"label %1 %2 %3 %4 "_s.arg(stop.order.value_or(0))
                      .arg(ground.rgb())
                      .arg(opacity)
                      .arg(size.width()) +
                  text;
    for (const int later : stop.later)
        key += u" %1"_s.arg(later);
    paintCached(p, key, QRectF(QPointF(-3, -3), size + QSizeF(8, 6)), label.rect.topLeft(), draw);
}

/** Painted below handles, which may be dragged across the names. */
void paintUavLabels(const MapPaint& p)
{
    p.painter.setFont(labelFont(p.theme));
    for (std::size_t i = 0; i < p.picture.uavs.size(); ++i)
        if (const QRectF& label = p.layout.uavLabels[i]; !label.isNull())
            drawHaloText(p.painter, label, Qt::AlignCenter, p.picture.uavs[i].label, p.theme.text,
                         p.theme.sea);
}

/** Cache key of the legend: all that its drawing depends on. */
QString legendKey(const MapPaint& p)
{
    QString key = u"legend %1 %2 %3 %4 %5 %6 %7"_s.arg(p.layout.symbols.ring_pxpm)
                      .arg(int(p.layout.symbols.showsRings))
                      .arg(p.picture.sigmaFull_m2)
                      .arg(int(p.layout.isLegendCompact))
                      .arg(p.style.locale.name())
                      .arg(p.style.layers.opacity(MapLayer::Rings))
                      .arg(p.style.layers.opacity(MapLayer::IceChart));
    for (const LegendRow& row : legendRows(p.picture, p.style, p.layout.symbols))
        key += u'\n' + row.text;
    for (const MapUav& uav : p.picture.uavs)
        key += u"\n%1 "_s.arg(uav.place) + uav.label;
    return key;
}

/** Returns whether a symbol lies below the panel. */
bool hidesSomething(const MapPaint& p, const QRectF& rect)
{
    return std::ranges::any_of(p.layout.icebergs,
                               [&](const LabelDisk& disk) { return overlaps(rect, disk); }) ||
           std::ranges::any_of(p.picture.uavs, [&](const MapUav& uav) {
               return rect.contains(p.layout.view.toPixel(uav.position_m));
           });
}

void paintPanelIcons(const MapPaint& p)
{
    constexpr std::array<IconName, kMapPanels> kIcons{
        IconName::Iceberg, IconName::Measure, IconName::Fit, IconName::Estimate, IconName::Hint};
    constexpr double kMargin_px = 4;
    for (std::size_t i = 0; i < kMapPanels; ++i)
        if (const QRectF& rect = p.layout.icons[i]; !rect.isNull()) {
            paintPanel(p.painter, rect, p.theme);
            icon(kIcons[i], p.theme)
                .paint(
                    &p.painter,
                    rect.marginsRemoved({kMargin_px, kMargin_px, kMargin_px, kMargin_px}).toRect());
        }
}

/** Paints the move handle and the fold button on the panel under the pointer. */
void paintPanelParts(const MapPaint& p, const QRectF& rect)
{
    const QRectF fold = foldButtonOf(rect);
    const QRectF grip = panelGripOf(rect);
    p.painter.setPen(QPen(p.theme.panelLine, 1));
    p.painter.setBrush(p.theme.panel);
    p.painter.drawRoundedRect(fold, 3, 3);
    p.painter.drawRoundedRect(grip, 3, 3);
    p.painter.setPen(QPen(p.theme.text, 1.6, Qt::SolidLine, Qt::RoundCap));
    p.painter.drawLine(fold.center() - QPointF(4, 0), fold.center() + QPointF(4, 0));
    for (const double x : {-3.0, 3.0})
        for (const double y : {-4.0, 0.0, 4.0})
            p.painter.drawPoint(grip.center() + QPointF(x, y));
}

void paintOverlays(const MapPaint& p, double north_rad, const std::optional<QPointF>& pointer)
{
    constexpr double kFaint = 0.15;
    const auto fade = [&](const QRectF& rect) {
        const bool isFaint = pointer && rect.contains(*pointer) && hidesSomething(p, rect);
        p.painter.setOpacity(isFaint ? kFaint : 1);
    };
    const auto panel = [&](const QRectF& rect, const QString& key, const auto& draw) {
        const QRectF bounds(QPointF(0, 0), rect.size());
        fade(rect);
        if (!rect.isNull())
            paintCached(p, key + u" %1 %2"_s.arg(rect.width()).arg(rect.height()), bounds,
                        rect.topLeft(), [&](QPainter& painter) { draw(painter, bounds); });
    };
    panel(p.layout.legend, legendKey(p), [&](QPainter& painter, const QRectF& rect) {
        paintLegend(painter, rect, p.picture, p.style, p.layout.symbols, p.layout.isLegendCompact);
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
    fade(p.layout.wind);
    if (!p.layout.wind.isNull())
        paintWindPanel(p.painter, p.layout.wind, p.picture.air, p.style);
    fade(p.layout.title);
    if (!p.layout.title.isNull())
        paintTitle(p.painter, p.layout.title, p.picture, p.style, p.layout.isTitleCompact);
    p.painter.setOpacity(1);
    paintPanelIcons(p);
    for (const MapPanel which : kFoldingPanels)
        if (pointer && p.layout.panel(which).contains(*pointer))
            paintPanelParts(p, p.layout.panel(which));
    if (!p.picture.icebergs.empty())
        return;
    const double top = std::max(p.layout.title.bottom(), p.layout.rect.top()) + 6;
    paintEmptyState(p.painter, p.layout.rect.adjusted(0, top - p.layout.rect.top(), 0, -6),
                    p.picture, p.style);
}

} // namespace

void paintCached(const MapPaint& p, const QString& key, const QRectF& bounds, const QPointF& at,
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

void paintMapGround(QPainter& painter, const MapFrame& frame)
{
    const MapPaint p(painter, frame);
    const LandRequest land{.plane = LocalFrame(p.picture.origin),
                           .view = p.layout.view,
                           .rect = p.layout.rect,
                           .ratio = painter.device()->devicePixelRatioF(),
                           .style = landStyleOf(p.theme),
                           .backdrop = p.style.layers.backdrop,
                           .backdropOpacity = p.style.layers.opacity(MapLayer::Backdrop),
                           .ice = p.picture.iceChart ? p.picture.iceChart->shapes : nullptr,
                           .iceOpacity = p.style.layers.opacity(MapLayer::IceChart),
                           .backdropStyle = backdropStyleOf(p.theme)};
    if (frame.land != nullptr)
        frame.land->paint(painter, land);
    else
        paintGroundOf(painter, land);
    if (const auto reach = reachIn(land.rect, land.plane, land.view))
        painter.setClipPath(*reach, Qt::IntersectClip);
    painter.setPen(QPen(p.theme.graticule, 1));
    withOpacity(p, frame.style.layers.opacity(MapLayer::Graticule), [&] {
        for (const GraticuleLine& line : p.graticule.lines)
            painter.drawPolyline(line.path_px);
    });
}

void paintMapContent(QPainter& painter, const MapFrame& frame)
{
    const MapPaint p(painter, frame);
    const MapLayers& layers = frame.style.layers;
    withOpacity(p, layers.opacity(MapLayer::Places), [&] { paintPlaceNames(p); });
    paintMapWeather(p);
    paintArea(p);
    AreaNames names(p);
    paintClosedAreas(p, names);
    withOpacity(p, layers.opacity(MapLayer::Permit), [&] { paintPermit(p, names); });
    withOpacity(p, layers.opacity(MapLayer::Swept), [&] { paintSwept(p); });
    withOpacity(p, layers.opacity(MapLayer::Compared), [&] { paintComparison(p); });
    paintTracks(p);
    paintFieldsOfView(p);
    paintDots(p); // dots lie below the plans
    paintLaterVisits(p);
    withOpacity(p, layers.opacity(MapLayer::FormerPlan), [&] { paintFormerPlans(p); });
    paintClusters(p);
    paintPlans(p);
    paintSearches(p);
    paintCircles(p);
    withOpacity(p, layers.opacity(MapLayer::Tracks), [&] { paintDriftTracks(p); });
    paintIcebergs(p);
    paintTruths(p);
    paintAlarms(p);
    paintPins(p);
    paintHomes(p);
    paintAsset(p);
    paintStation(p);
    paintNoReturns(p);
    paintTooClose(p);
    for (const MapUav& uav : p.picture.uavs)
        drawUav(painter, p.layout.view.toPixel(uav.position_m), uav.psi_rad,
                uavColour(p.theme, uav.place), p.theme);
    paintLive(p);
    withOpacity(p, layers.opacity(MapLayer::Labels), [&] { paintUavLabels(p); });
}

void paintMapLabels(QPainter& painter, const MapFrame& frame)
{
    const MapPaint p(painter, frame);
    const MapLayers& layers = frame.style.layers;
    for (std::size_t i = 0; i < p.picture.icebergs.size(); ++i)
        paintLabel(p, i);
    withOpacity(p, layers.opacity(MapLayer::Graticule), [&] { paintGraticuleLabels(p); });
}

void paintMapOverlays(QPainter& painter, const MapFrame& frame)
{
    const MapPaint p(painter, frame);
    const LocalFrame plane(p.picture.origin);
    paintOverlays(p, northAngle_rad(plane, p.layout.view.toWorld(p.layout.rect.center())),
                  frame.pointer);
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
