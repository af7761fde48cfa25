#include "widgets/map/paint/map_layout.h"

#include "widgets/map/paint/map_dots.h"
#include "widgets/map/paint/map_drift.h"
#include "widgets/map/paint/map_legs.h"
#include "widgets/map/paint/map_symbols.h"
#include "widgets/map/paint/wind_panel.h"
#include "widgets/map/picture/footprint.h"
#include "widgets/map/picture/map_content.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>
#include <QFontMetricsF>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct MapLayoutText
{
    Q_DECLARE_TR_FUNCTIONS(MapLayoutText)
};

constexpr double kMargin_px = 12;     // of overlays from the edge and from each other
constexpr double kRingAtFull_px = 12; // ring of the largest sigma beyond its symbol
constexpr double kLabelHeight_px = 19;
constexpr double kUavClearance_px = 17;
constexpr std::size_t kTrackProbes = 240;

// Overlays may take this share of the width and height before they are left out.
constexpr double kWidestShare = 0.45;
constexpr double kTallestShare = 0.62;
constexpr double kLargestShare = 0.16; // of the area
constexpr double kLargestCalmShare = 0.05;
constexpr double kFolded_px = 26;
constexpr double kPanelPart_px = 17;
constexpr double kLowMap_px = 600; // whose legend is compact

bool fits(const QSizeF& size, const QRectF& rect)
{
    return !size.isEmpty() && size.width() <= kWidestShare * rect.width() &&
           size.height() <= kTallestShare * rect.height() &&
           size.width() * size.height() <= kLargestShare * rect.width() * rect.height();
}

template <class Layout>
auto& panelOf(Layout& layout, MapPanel which)
{
    switch (which) {
    case MapPanel::Legend:
        return layout.legend;
    case MapPanel::ScaleBar:
        return layout.scaleBar;
    case MapPanel::North:
        return layout.north;
    case MapPanel::Wind:
        return layout.wind;
    case MapPanel::Title:
        break;
    }
    return layout.title;
}

/** As the user wants it: hidden, an icon in the same corner, or elsewhere; on the map. */
void rearrange(MapLayout& layout, const MapPanelStates& states)
{
    const QRectF inner = layout.rect.adjusted(kMargin_px, kMargin_px, -kMargin_px, -kMargin_px);
    for (std::size_t i = 0; i < kMapPanels; ++i) {
        const MapPanelState& state = states[i];
        QRectF& rect = panelOf(layout, static_cast<MapPanel>(i));
        layout.icons[i] = {};
        layout.moved_px[i] = {};
        if (rect.isNull() || state == MapPanelState{})
            continue;
        QRectF wanted = rect;
        if (state.isFolded) {
            const bool isRight = rect.center().x() > inner.center().x();
            const bool isLow = rect.center().y() > inner.center().y();
            wanted.setSize({kFolded_px, kFolded_px});
            wanted.moveTo(isRight ? rect.right() - kFolded_px : rect.left(),
                          isLow ? rect.bottom() - kFolded_px : rect.top());
        }
        const QPointF own = wanted.topLeft();
        wanted.translate(state.moved_px);
        wanted.moveLeft(
            std::max(inner.left(), std::min(wanted.left(), inner.right() - wanted.width())));
        wanted.moveTop(
            std::max(inner.top(), std::min(wanted.top(), inner.bottom() - wanted.height())));
        layout.moved_px[i] = wanted.topLeft() - own;
        rect = state.isHidden || state.isFolded ? QRectF() : wanted;
        if (state.isFolded && !state.isHidden)
            layout.icons[i] = wanted;
    }
}

/** Beside the north arrow. */
void placeWind(MapLayout& layout, const MapPicture& picture, const MapStyle& style)
{
    const QSizeF size = windPanelSize(picture.air, style);
    if (layout.north.isNull() || !fits(size, layout.rect))
        return;
    const bool isCalm = picture.air.wind_mps.isZero(0) && picture.air.current_mps.isZero(0);
    if (isCalm && size.width() * size.height() >
                      kLargestCalmShare * layout.rect.width() * layout.rect.height())
        return;
    const QRectF rect(QPointF(layout.north.left() - kMargin_px - size.width(), layout.north.top()),
                      size);
    const auto isClearOf = [&rect](const QRectF& other) {
        return other.isNull() ||
               !other.adjusted(-kMargin_px, -kMargin_px, kMargin_px, kMargin_px).intersects(rect);
    };
    if (isClearOf(layout.title) && isClearOf(layout.legend) && isClearOf(layout.scaleBar))
        layout.wind = rect;
}

/** Overlays into their corners: title top left, legend bottom left, the others on the right. */
void placeOverlays(MapLayout& layout, const MapPicture& picture, const MapStyle& style)
{
    layout.title = layout.legend = layout.scaleBar = layout.north = layout.wind = layout.inset = {};
    const QRectF inner = layout.rect.adjusted(kMargin_px, kMargin_px, -kMargin_px, -kMargin_px);
    const QSizeF title = titleSize(picture, style, 0.6 * layout.rect.width());
    if (!title.isEmpty() && title.width() >= 120 && title.height() <= 0.4 * layout.rect.height())
        layout.title = QRectF(inner.topLeft(), title);
    layout.isLegendCompact = layout.rect.height() < kLowMap_px;
    QSizeF legend = legendSize(picture, style, layout.symbols, layout.isLegendCompact);
    if (!legend.isEmpty())
        legend = legend.expandedTo(layout.leastLegend_px);
    const bool roomBelowTitle =
        layout.title.bottom() + kMargin_px <= inner.bottom() - legend.height();
    if (fits(legend, layout.rect) && roomBelowTitle)
        layout.legend = QRectF(QPointF(inner.left(), inner.bottom() - legend.height()), legend);
    const QSizeF bar = scaleBarSize(layout.view, style);
    if (fits(bar, layout.rect))
        layout.scaleBar = QRectF(inner.bottomRight() - QPointF(bar.width(), bar.height()), bar);
    const QSizeF north = northArrowSize();
    if (fits(north, layout.rect))
        layout.north = QRectF(inner.topRight() - QPointF(north.width(), 0), north);
    placeWind(layout, picture, style);
    const double ceiling = std::max(layout.north.bottom(), layout.wind.bottom());
    const QRectF inset(QPointF(inner.right() - style.inset_px.width(), ceiling + kMargin_px),
                       style.inset_px);
    const double floor = layout.scaleBar.isNull() ? inner.bottom() : layout.scaleBar.top();
    if (fits(style.inset_px, layout.rect) && inset.bottom() + kMargin_px <= floor)
        layout.inset = inset;
    rearrange(layout, style.panels);
}

SymbolScale symbolScale(const MapPicture& picture, const MapStyle& style,
                        const MapViewTransform& view)
{
    SymbolScale scale{.ring_pxpm = kRingAtFull_px / std::sqrt(picture.sigmaFull_m2)};
    if (!style.layers.shows(MapLayer::Drift) || style.layers.horizon_s > 0) {
        scale.driftTime_s = style.layers.shows(MapLayer::Drift) ? style.layers.horizon_s : 0;
        return scale;
    }
    double fastest_mps = 0;
    for (const MapIceberg& iceberg : picture.icebergs)
        fastest_mps = std::max(fastest_mps, iceberg.velocity_mps.norm());
    if (fastest_mps > 0)
        scale.driftTime_s = driftTimeFor_s(fastest_mps, view.scale_pxpm());
    return scale;
}

void placeIcebergs(MapLayout& layout, const MapPicture& picture)
{
    layout.icebergs.clear();
    for (std::size_t i = 0; i < picture.icebergs.size(); ++i) {
        const MapIceberg& iceberg = picture.icebergs[i];
        if (layout.density.marks[i] != IcebergMark::Symbol) {
            layout.icebergs.push_back({.centre_px = layout.view.toPixel(iceberg.position_m),
                                       .radius_px = kIcebergDot_px + 1});
            continue;
        }
        const double symbol_px =
            layout.density.isDense ? kSmallIceberg_px : icebergSymbolRadius_px(iceberg.radius_m);
        const double ring_px = layout.density.isDense ? 0
                               : iceberg.inView
                                   ? symbol_px + 7
                                   : layout.symbols.ringRadius_px(symbol_px, iceberg.sigma_m2);
        layout.icebergs.push_back({.centre_px = layout.view.toPixel(iceberg.position_m),
                                   .radius_px = std::max(symbol_px + 1.5, ring_px + 1)});
    }
}

/**
 * Below the symbols, where the nose of none that flies north is, unless above or beside them they
 * hide less; below each other if need be.
 */
void placeUavLabels(MapLayout& layout, const MapPicture& picture, const Theme& theme)
{
    const QFontMetricsF metrics(labelFont(theme));
    const std::vector<QRectF> panels = layout.overlays();
    layout.uavLabels.assign(picture.uavs.size(), {});
    for (std::size_t uav = 0; uav < picture.uavs.size(); ++uav) {
        if (picture.uavs[uav].label.isEmpty())
            continue;
        const double width_px = std::ceil(metrics.horizontalAdvance(picture.uavs[uav].label)) + 2;
        QRectF label(0, 0, width_px, kLabelHeight_px);
        const auto isOn = [&label](const QRectF& other) { return other.intersects(label); };
        const auto hidden = [&] {
            return std::ranges::count_if(
                       layout.icebergs,
                       [&](const LabelDisk& disk) { return overlaps(label, disk); }) +
                   std::ranges::count_if(layout.uavLabels, isOn) +
                   std::ranges::count_if(panels, isOn);
        };
        const double up_px = kUavClearance_px + 1 + kLabelHeight_px / 2;
        const double aside_px = kUavClearance_px + 1 + width_px / 2;
        QRectF best;
        std::ptrdiff_t least = std::numeric_limits<std::ptrdiff_t>::max();
        for (const auto& [x, y] :
             {std::pair(0.0, up_px), {0.0, -up_px}, {aside_px, 0.0}, {-aside_px, 0.0}}) {
            label.moveCenter(layout.view.toPixel(picture.uavs[uav].position_m) + QPointF(x, y));
            if (const std::ptrdiff_t count = hidden(); count < least) {
                least = count;
                best = label;
            }
        }
        label = best;
        for (auto other = std::ranges::find_if(layout.uavLabels, isOn);
             other != layout.uavLabels.end(); other = std::ranges::find_if(layout.uavLabels, isOn))
            label.moveTop(other->bottom());
        layout.uavLabels[uav] = label;
    }
}

/** A view and how well it keeps things clear of the overlays. */
double viewScore(const MapLayout& layout, const MapPicture& picture)
{
    const std::vector<QRectF> overlays = layout.overlays();
    const auto covered = [&](const QPointF& p, double radius_px) {
        return std::any_of(overlays.begin(), overlays.end(), [&](const QRectF& overlay) {
            return overlaps(overlay, {.centre_px = p, .radius_px = radius_px});
        });
    };
    double score = layout.view.scale_pxpm();
    const auto halve = [&](const Point& p_m, double radius_px) {
        if (covered(layout.view.toPixel(p_m), radius_px))
            score *= 0.5;
    };
    for (const MapIceberg& iceberg : picture.icebergs)
        halve(iceberg.position_m, 26);
    for (const MapUav& uav : picture.uavs)
        halve(uav.position_m, 20);
    if (picture.asset)
        halve(picture.asset->position_m, 20);
    if (picture.station)
        halve(picture.station->position_m, 20);
    for (const Point& corner_m : picture.area_m)
        if (covered(layout.view.toPixel(corner_m), 4))
            score *= 0.9;
    for (const MapRoute& route : picture.routes) {
        const std::size_t stride = route.track.size() * picture.routes.size() / kTrackProbes + 1;
        for (std::size_t i = 0; i < route.track.size(); i += stride)
            if (covered(layout.view.toPixel(route.track[i].position_m), 2))
                score *= 0.97;
    }
    return score;
}

/**
 * The view that shows everything largest with the symbols clear of the overlays of `layout`: tries
 * to keep the strip of each overlay free and to push the content to one side, and takes the best.
 */
MapViewTransform bestView(MapLayout layout, const MapPicture& picture, const QRectF& inner)
{
    const WorldBounds bounds =
        boundsOf(contentPoints(picture, layout.symbols.driftTime_s, layout.view.scale_pxpm()));
    const std::array<double, 3> lefts = {0, layout.title.width(), layout.legend.width()};
    const double besideNorth_px = layout.wind.isNull() ? 0 : layout.wind.width() + kMargin_px;
    const std::array<double, 2> rights = {0, layout.north.width() + besideNorth_px};
    const std::array<double, 2> tops = {0, layout.title.height()};
    const std::array<double, 3> bottoms = {0, layout.scaleBar.height(), layout.legend.height()};
    MapViewTransform best = layout.view;
    double bestScore = -1;
    for (const double left : lefts)
        for (const double right : rights)
            for (const double top : tops)
                for (const double bottom : bottoms)
                    for (const double x : {0.5, 1.0, 0.0})
                        for (const double y : {0.5, 1.0, 0.0}) {
                            layout.view = MapViewTransform::fitted(
                                bounds, inner.adjusted(left, top, -right, -bottom), {x, y});
                            // A hundredth off centre counts less than a hundredth of the scale.
                            const double score =
                                viewScore(layout, picture) *
                                (1 - 0.01 * std::abs(x - 0.5) - 0.01 * std::abs(y - 0.5));
                            if (score > bestScore) {
                                bestScore = score;
                                best = layout.view;
                            }
                        }
    return best;
}

/** `bestView` for the overlays that it has itself: scale bar and legend depend on the view. */
MapViewTransform fittedView(MapLayout layout, const MapPicture& picture, const MapStyle& style)
{
    constexpr int kRounds = 2;
    const double margin_px =
        std::min({kSymbolMargin_px, 0.15 * layout.rect.width(), 0.15 * layout.rect.height()});
    const QRectF inner = layout.rect.adjusted(margin_px, margin_px, -margin_px, -margin_px);
    layout.view = MapViewTransform::fitted(
        boundsOf(contentPoints(picture, 0, std::numeric_limits<double>::infinity())), inner);
    const std::vector<MapStop> stops = stopsOf(picture);
    for (int round = 0; round < kRounds; ++round) {
        layout.symbols = symbolScale(picture, style, layout.view);
        layout.symbols.showsDots = // which have a row of the legend
            densityOf(picture, layout.view, layout.rect, stops, false).isDense;
        placeOverlays(layout, picture, style);
        layout.view = bestView(layout, picture, inner);
    }
    return layout.view;
}

/** What the labels have to keep clear of. */
LabelSurroundings surroundingsOf(const MapLayout& layout, const MapPicture& picture)
{
    LabelSurroundings around;
    around.area = layout.rect.adjusted(3, 3, -3, -3);
    around.solids = layout.overlays();
    for (std::size_t uav = 0; uav < picture.routes.size(); ++uav)
        for (const QPolygonF& leg : planLegs(picture, layout, uav))
            for (qsizetype i = 1; i < leg.size(); ++i)
                around.lines.emplace_back(leg[i - 1], leg[i]);
    for (std::size_t i = 0; i < picture.icebergs.size(); ++i) {
        if (layout.density.marks[i] == IcebergMark::Symbol) // names may lie on dots
            around.disks.push_back(layout.icebergs[i]);
        if (const QLineF arrow = driftArrow(picture, layout, i); !arrow.isNull())
            around.lines.push_back(arrow);
    }
    for (const MapUav& uav : picture.uavs) {
        around.disks.push_back(
            {.centre_px = layout.view.toPixel(uav.position_m), .radius_px = kUavClearance_px});
        const QPolygonF field = fieldOutline(uav, layout.view);
        for (int i = 0; i + 1 < field.size(); ++i)
            around.lines.emplace_back(field[i], field[i + 1]);
    }
    for (const QRectF& label : layout.uavLabels)
        if (!label.isNull())
            around.solids.push_back(label);
    for (const auto& place_m :
         {picture.asset ? std::optional(picture.asset->position_m) : std::nullopt,
          picture.station ? std::optional(picture.station->position_m) : std::nullopt})
        if (place_m)
            around.disks.push_back(
                {.centre_px = layout.view.toPixel(*place_m), .radius_px = kUavClearance_px});
    return around;
}

/** Labels of the icebergs in sight. */
std::vector<PlacedLabel> labelsOf(const MapLayout& layout, const MapPicture& picture,
                                  const MapStyle& style, const MapContinuity& continuity)
{
    const QFontMetricsF metrics(labelFont(style.theme));
    std::vector<PlacedLabel> labels(picture.icebergs.size());
    LabelSurroundings around = surroundingsOf(layout, picture);
    std::vector<LabelRequest> requests;
    std::vector<std::size_t> asking; // iceberg of each request
    for (std::size_t i = 0; i < picture.icebergs.size(); ++i) {
        const LabelDisk& anchor = layout.icebergs[i];
        if (layout.density.marks[i] != IcebergMark::Symbol || !overlaps(layout.rect, anchor))
            continue;
        LabelRequest request{.anchor = anchor, .size_px = {}};
        const auto before = continuity.labels.find(picture.icebergs[i].id);
        const bool mayLook =
            !continuity.turn ||
            (i >= continuity.turn->first && i - continuity.turn->first < continuity.turn->count);
        if (before != continuity.labels.end()) {
            PlacedLabel previous = before.value();
            if (!previous.rect.isNull()) {
                previous.rect.translate(anchor.centre_px);
                request.previous = previous;
            }
            if (!mayLook) {
                labels[i] = previous;
                if (request.previous)
                    around.solids.push_back(previous.rect);
                continue;
            }
        }
        if (!mayLook)
            continue;
        double width_px = std::ceil(metrics.horizontalAdvance(labelText(picture.icebergs[i]))) + 2;
        if (layout.stops[i].order > 0)
            width_px += 2 * kOrderDisk_px + kOrderGap_px;
        width_px += static_cast<double>(std::min(layout.stops[i].later.size(), kMostLater)) *
                    (2 * kLaterDisk_px + kLaterGap_px);
        request.size_px = QSizeF(width_px, kLabelHeight_px);
        requests.push_back(request);
        asking.push_back(i);
    }
    const std::vector<PlacedLabel> placed = placeLabels(requests, around);
    for (std::size_t k = 0; k < placed.size(); ++k)
        labels[asking[k]] = placed[k];
    return labels;
}

} // namespace

std::vector<QRectF> MapLayout::overlays() const
{
    std::vector<QRectF> shown;
    for (const QRectF& overlay : {title, legend, scaleBar, north, wind, inset})
        if (!overlay.isNull())
            shown.push_back(overlay);
    for (const QRectF& icon : icons)
        if (!icon.isNull())
            shown.push_back(icon);
    return shown;
}

const QRectF& MapLayout::panel(MapPanel which) const
{
    return panelOf(*this, which);
}

QRectF foldButtonOf(const QRectF& panel)
{
    return {panel.right() - kPanelPart_px - 3, panel.top() + 3, kPanelPart_px, kPanelPart_px};
}

QRectF panelGripOf(const QRectF& panel)
{
    return foldButtonOf(panel).translated(-kPanelPart_px - 2, 0);
}

QFont labelFont(const Theme& theme)
{
    QFont font = theme.body();
    font.setPixelSize(12);
    return font;
}

QString labelText(const MapIceberg& iceberg)
{
    if (iceberg.appears_s > 0)
        return iceberg.id + u" · "_s + clockText(iceberg.appears_s);
    if (iceberg.status == TrackStatus::Lost)
        return iceberg.id + u" · "_s + MapLayoutText::tr("lost");
    if (iceberg.status == TrackStatus::GivenUp)
        return iceberg.id + u" · "_s + MapLayoutText::tr("given up");
    return iceberg.id;
}

MapContinuity continuityOf(const MapPicture& picture, const MapLayout& layout)
{
    MapContinuity continuity{.labels = {},
                             .isDense = layout.density.isDense,
                             .legend_px = layout.legend.size(),
                             .isLegendCompact = layout.isLegendCompact};
    for (std::size_t i = 0; i < picture.icebergs.size(); ++i) {
        PlacedLabel label = layout.labels[i];
        if (!label.rect.isNull())
            label.rect.translate(-layout.icebergs[i].centre_px);
        continuity.labels.insert(picture.icebergs[i].id, label);
    }
    return continuity;
}

MapLayout arrangeMap(const MapPicture& picture, const MapStyle& style, const QRectF& rect,
                     const std::optional<MapViewTransform>& view, const MapContinuity& continuity)
{
    MapLayout layout;
    layout.rect = rect;
    const bool hasFlown =
        picture.anyRoute([](const MapRoute& route) { return route.track.size() > 1; });
    if (hasFlown && continuity.isLegendCompact == (rect.height() < kLowMap_px))
        layout.leastLegend_px = continuity.legend_px;
    layout.view = view ? *view : fittedView(layout, picture, style);
    layout.symbols = symbolScale(picture, style, layout.view);
    if (continuity.driftTime_s)
        layout.symbols.driftTime_s = *continuity.driftTime_s;
    layout.stops = stopsOf(picture);
    layout.density = densityOf(picture, layout.view, rect, layout.stops, continuity.isDense);
    layout.symbols.showsDots = layout.density.isDense;
    placeOverlays(layout, picture, style);
    placeIcebergs(layout, picture);
    placeUavLabels(layout, picture, style.theme);
    layout.labels = labelsOf(layout, picture, style, continuity);
    return layout;
}

} // namespace berg
