#include "widgets/map/paint/map_layout.h"

#include "widgets/map/paint/map_dots.h"
#include "widgets/map/paint/map_drift.h"
#include "widgets/map/paint/map_legs.h"
#include "widgets/map/paint/map_symbols.h"
#include "widgets/map/paint/overlay_places.h"
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

constexpr double kRingAtFull_px = 12; // width of the ring of the largest sigma
constexpr double kLabelHeight_px = 19;
constexpr double kUavClearance_px = 17;
constexpr std::size_t kTrackProbes = 240;

SymbolScale symbolScale(const MapPicture& picture, const MapStyle& style,
                        const MapViewTransform& view)
{
    SymbolScale scale{.ring_pxpm = kRingAtFull_px / std::sqrt(picture.sigmaFull_m2)};
    if (!style.layers.shows(MapLayer::Drift))
        return scale;
    if (style.layers.horizon_s) {
        scale.driftTime_s = *style.layers.horizon_s;
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
            layout.density.isCrowded ? kSmallIceberg_px : icebergSymbolRadius_px(iceberg.radius_m);
        const double ring_px = layout.density.isCrowded ? 0
                               : iceberg.inView
                                   ? symbol_px + 7
                                   : layout.symbols.ringRadius_px(symbol_px, iceberg.sigma_m2);
        layout.icebergs.push_back({.centre_px = layout.view.toPixel(iceberg.position_m),
                                   .radius_px = std::max(symbol_px + 1.5, ring_px + 1)});
    }
}

/**
 * Places the names of UAVs below their symbols, which leaves the nose of a northbound UAV free,
 * unless they hide less above or beside them; names that still overlap are stacked.
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

/** Rates a view by its scale and by how well it keeps objects clear of the overlays. */
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
 * Finds the largest view with all symbols clear of the overlays of `layout`. Candidates keep the
 * strip of each overlay free or push the content to one side; the best score wins.
 */
MapViewTransform bestView(MapLayout layout, const MapPicture& picture, const QRectF& inner)
{
    const WorldBounds bounds =
        boundsOf(contentPoints(picture, layout.symbols.driftTime_s, layout.view.scale_pxpm()));
    const std::array<double, 3> lefts = {0, layout.title.width(), layout.legend.width()};
    const double besideNorth_px = layout.wind.isNull() ? 0 : layout.wind.width() + kOverlayGap_px;
    const bool isLegendRight = layout.legend.center().x() > layout.rect.center().x();
    const std::array<double, 2> rights = {0, std::max(layout.north.width() + besideNorth_px,
                                                      isLegendRight ? layout.legend.width() : 0)};
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

/** Sets what the legend shows for this crowding. */
void setLegendFlags(SymbolScale& symbols, const MapCrowding& crowding)
{
    symbols.showsDots = crowding.isDense;
    symbols.showsRings = !crowding.isCrowded;
}

/** Iterates `bestView`, because the sizes of scale bar and legend depend on the view. */
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
        setLegendFlags(layout.symbols, densityOf(picture, layout.view, layout.rect, stops, {}));
        placeOverlays(layout, picture, style);
        layout.view = bestView(layout, picture, inner);
    }
    return layout.view;
}

/** Obstacles for labels. */
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
        if (layout.density.marks[i] == IcebergMark::Symbol) // names may cover dots
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
    for (const MapRoute& route : picture.routes)
        if (!route.toNoReturn_m.empty())
            around.solids.push_back(noReturnRect(layout.view.toPixel(route.toNoReturn_m.back())));
    for (const auto& place_m :
         {picture.asset ? std::optional(picture.asset->position_m) : std::nullopt,
          picture.station ? std::optional(picture.station->position_m) : std::nullopt})
        if (place_m)
            around.disks.push_back(
                {.centre_px = layout.view.toPixel(*place_m), .radius_px = kUavClearance_px});
    return around;
}

/** Size of a label with its number, name and the numbers of later visits. */
QSizeF labelSize_px(const QString& text, const MapStop& stop, const QFontMetricsF& metrics)
{
    double width_px = std::ceil(metrics.horizontalAdvance(text)) + 2;
    if (stop.order)
        width_px += 2 * kOrderDisk_px + kOrderGap_px;
    width_px += static_cast<double>(std::min(stop.later.size(), kMostLater)) *
                (2 * kLaterDisk_px + kLaterGap_px);
    return {width_px, kLabelHeight_px};
}

/** Labels placed in one pass. */
struct LabelGroup
{
    std::vector<LabelRequest> requests;
    std::vector<std::size_t> icebergs; ///< by request
};

struct LabelGroups
{
    LabelGroup next;     ///< next visits, which always get a label
    LabelGroup others;   ///< labels that may move
    LabelGroup standing; ///< labels that keep their place unless `next` needs it
};

LabelGroups labelGroups(const MapLayout& layout, const MapPicture& picture, const MapStyle& style,
                        const MapContinuity& continuity)
{
    const QFontMetricsF metrics(labelFont(style.theme));
    // The labels of symbols of another size have other places.
    const bool isContinued = layout.density.isCrowded == continuity.crowding.isCrowded;
    LabelGroups groups;
    for (std::size_t i = 0; i < picture.icebergs.size(); ++i) {
        const LabelDisk& anchor = layout.icebergs[i];
        if (layout.density.marks[i] != IcebergMark::Symbol || !overlaps(layout.rect, anchor))
            continue;
        PlacedLabel previous;
        if (isContinued)
            previous = continuity.labels.value(picture.icebergs[i].id);
        const bool mayMove =
            !continuity.turn ||
            (i >= continuity.turn->first && i - continuity.turn->first < continuity.turn->count);
        const bool isNextVisit = isNext(layout.stops[i]);
        if (!mayMove && !isNextVisit && previous.rect.isNull())
            continue;
        LabelRequest request{.anchor = anchor,
                             .size_px =
                                 labelSize_px(labelText(picture.icebergs[i], picture.times.clock),
                                              layout.stops[i], metrics)};
        if (!previous.rect.isNull()) {
            previous.rect.translate(anchor.centre_px);
            request.previous = previous;
        }
        LabelGroup& group = isNextVisit ? groups.next : mayMove ? groups.others : groups.standing;
        group.requests.push_back(request);
        group.icebergs.push_back(i);
    }
    return groups;
}

/** Places the next visits first; without a free place they may cover other icebergs' symbols. */
std::vector<PlacedLabel> placeNext(const LabelGroup& next, LabelSurroundings around)
{
    std::vector<PlacedLabel> placed = placeLabels(next.requests, around);
    const auto isMissing = [](const PlacedLabel& label) { return label.rect.isNull(); };
    if (std::ranges::none_of(placed, isMissing))
        return placed;
    around.disks.clear();
    around.lines.clear();
    for (const PlacedLabel& label : placed)
        if (!isMissing(label))
            around.solids.push_back(label.rect);
    for (std::size_t k = 0; k < placed.size(); ++k)
        if (isMissing(placed[k])) {
            placed[k] = placeLabels({&next.requests[k], 1}, around).front();
            around.solids.push_back(placed[k].rect);
        }
    return placed;
}

/** Places the labels of the icebergs in sight. */
std::vector<PlacedLabel> labelsOf(const MapLayout& layout, const MapPicture& picture,
                                  const MapStyle& style, const MapContinuity& continuity)
{
    const LabelGroups groups = labelGroups(layout, picture, style, continuity);
    std::vector<PlacedLabel> labels(picture.icebergs.size());
    LabelSurroundings around = surroundingsOf(layout, picture);
    std::vector<QRectF> taken;
    const auto add = [&](const LabelGroup& group, const std::vector<PlacedLabel>& placed) {
        for (std::size_t k = 0; k < placed.size(); ++k) {
            labels[group.icebergs[k]] = placed[k];
            if (!placed[k].rect.isNull())
                taken.push_back(placed[k].rect);
        }
    };
    add(groups.next, placeNext(groups.next, around));
    const std::vector<QRectF> next = taken;
    for (std::size_t k = 0; k < groups.standing.requests.size(); ++k) {
        const LabelRequest& request = groups.standing.requests[k];
        PlacedLabel label = *request.previous;
        label.rect = stayingRect(request); // a new plan may have given it a number
        if (std::ranges::any_of(next,
                                [&](const QRectF& rect) { return rect.intersects(label.rect); }))
            continue;
        labels[groups.standing.icebergs[k]] = label;
        taken.push_back(label.rect);
    }
    around.solids.insert(around.solids.end(), taken.begin(), taken.end());
    std::vector<PlacedLabel> others = placeLabels(groups.others.requests, around);
    for (PlacedLabel& label : others)
        if (label.needsLeader && layout.density.isCrowded)
            label = {}; // keeps the leader lines of the next visits visible
    add(groups.others, others);
    return labels;
}

} // namespace

QFont labelFont(const Theme& theme)
{
    QFont font = theme.body();
    font.setPixelSize(12);
    return font;
}

QString labelText(const MapIceberg& iceberg, const MissionClock& clock)
{
    if (iceberg.appears_s > 0)
        return iceberg.id + u" · "_s + clock.text(iceberg.appears_s);
    if (iceberg.status == TrackStatus::Lost)
        return iceberg.id + u" · "_s + MapLayoutText::tr("lost");
    if (iceberg.status == TrackStatus::GivenUp)
        return iceberg.id + u" · "_s + MapLayoutText::tr("given up");
    return iceberg.id;
}

MapContinuity continuityOf(const MapPicture& picture, const MapLayout& layout)
{
    MapContinuity continuity{.labels = {},
                             .crowding = layout.density.crowding(),
                             .weather = layout.weather,
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
    layout.density = densityOf(picture, layout.view, rect, layout.stops, continuity.crowding);
    setLegendFlags(layout.symbols, layout.density);
    placeOverlays(layout, picture, style);
    placeIcebergs(layout, picture);
    uncoverIcebergs(layout, picture, style);
    placeUavLabels(layout, picture, style.theme);
    layout.labels = labelsOf(layout, picture, style, continuity);
    if (style.layers.shows(MapLayer::Places))
        layout.places = placeNamesOn(layout, picture, style.theme);
    layout.weather = weatherMarksIn(picture, layout.view, rect, continuity.weather);
    return layout;
}

} // namespace berg
