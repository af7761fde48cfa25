#include "widgets/map/paint/map_legend_rows.h"

#include "widgets/map/paint/map_dots.h"
#include "widgets/map/paint/map_drift.h"
#include "widgets/map/paint/map_layout.h"
#include "widgets/map/paint/map_marks.h"
#include "widgets/map/paint/map_paths.h"
#include "widgets/map/paint/map_surroundings.h"
#include "widgets/map/paint/map_symbols.h"
#include "widgets/map/paint/map_weather_layer.h"
#include "widgets/map/picture/ice_picture.h"
#include "widgets/map/picture/route_colours.h"
#include "widgets/theme/painter_state.h"
#include "widgets/theme/palette.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLinearGradient>

#include <algorithm>
#include <array>
#include <functional>
#include <set>
#include <span>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kRow_px = 18;
constexpr double kSymbolRow_px = 26;
constexpr double kSignRow_px = 20; // row height of UAVs
constexpr double kSign_px = 19;
constexpr double kSignGap_px = 14;
constexpr double kSignScale = 0.55; // relative to the symbol on the map

struct MapLegend
{
    Q_DECLARE_TR_FUNCTIONS(MapLegend)
};

bool hasRepeatVisits(const MapRoute& route)
{
    MapPlaces sorted = route.plan;
    std::ranges::sort(sorted);
    return std::ranges::adjacent_find(sorted) != sorted.end();
}

void drawPlanSwatch(QPainter& painter, const QRectF& swatch, const RouteColours& colours,
                    const Theme& theme)
{
    const double y = swatch.center().y();
    painter.setPen(QPen(colours.plan, 3, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(swatch.left(), y), QPointF(swatch.center().x(), y));
    painter.setPen(QPen(colours.plan, 1.5));
    painter.drawLine(QPointF(swatch.center().x(), y), QPointF(swatch.right(), y));
    drawOrderDisk(painter, {swatch.center().x(), y}, 7.5, 1, theme, colours.plan);
}

void drawLineSwatch(QPainter& painter, const QRectF& swatch, const QPen& pen)
{
    painter.setPen(pen);
    painter.drawLine(QPointF(swatch.left(), swatch.center().y()),
                     QPointF(swatch.right(), swatch.center().y()));
}

void drawTrackSwatch(QPainter& painter, const QRectF& swatch, const RouteColours& colours,
                     const Theme& theme)
{
    QLinearGradient fade(swatch.topLeft(), swatch.topRight());
    fade.setColorAt(0, mixed(theme.panel, colours.track, 0.15));
    fade.setColorAt(1, colours.track);
    // A filled rectangle, because Qt's SVG and PDF engines do not support gradient pens.
    painter.fillRect(QRectF(swatch.left(), swatch.center().y() - 1, swatch.width(), 2), fade);
}

void drawComparisonSwatch(QPainter& painter, const QRectF& swatch, const Theme& theme)
{
    const QLineF line(swatch.left(), swatch.center().y(), swatch.right(), swatch.center().y());
    painter.setPen(QPen(theme.comparison, 1.6, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(line);
    const QPointF beyond(kLegendSwatch_px, 0); // direction marks are not drawn on short lines
    drawDirectionMark(painter, QLineF(line.p1() - beyond, line.p2() + beyond), theme.comparison, 9);
}

void drawFieldSwatch(QPainter& painter, const QRectF& swatch, const QColor& colour)
{
    const QRectF box(swatch.left() + 8, swatch.center().y() - 6, 18, 12);
    QColor fill = colour;
    fill.setAlphaF(0.12F);
    painter.setPen(QPen(colour, 1.5));
    painter.setBrush(fill);
    painter.drawRect(box);
}

/** Draws water whose right half has been seen. */
void drawSweptSwatch(QPainter& painter, const QRectF& swatch, const Theme& theme)
{
    const QRectF box(swatch.left() + 2, swatch.center().y() - 6, swatch.width() - 4, 12);
    painter.fillRect(box, theme.sea);
    painter.fillRect(box.adjusted(box.width() / 2, 0, 0, 0), theme.swept);
    painter.setPen(QPen(theme.panelLine, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(box);
}

void drawRingSwatch(QPainter& painter, const QRectF& swatch, const QPen& pen)
{
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(swatch.center(), 7, 7);
}

void drawFenceSwatch(QPainter& painter, const QRectF& swatch, const Theme& theme)
{
    const double y = swatch.center().y() - 2;
    drawFence(painter, QLineF(swatch.left(), y, swatch.right(), y), theme);
}

void drawClusterSwatch(QPainter& painter, const QRectF& swatch, const QColor& plan,
                       const Theme& theme)
{
    painter.setPen(clusterPen(plan));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(swatch.center().x() - 13, swatch.center().y() - 7, 26, 14), 7,
                            7);
    drawAim(painter, swatch.center(), plan, theme);
}

/** Collects the rows in order. */
class RowList
{
public:
    RowList(const MapPicture& picture, const Theme& theme) : m_picture(picture), m_theme(theme) {}

    void add(bool isThere, const QString& text, const QString& word,
             std::function<void(QPainter&, const QRectF&)> draw)
    {
        if (isThere)
            m_rows.push_back(
                {.text = text, .word = word, .draw = std::move(draw), .height_px = kRow_px});
    }

    /** Adds a row with an iceberg symbol if `matches` is true for any iceberg. */
    void addIceberg(const std::function<bool(const MapIceberg&)>& matches, const QString& text,
                    const QString& word, const IcebergStyle& style)
    {
        if (!any(matches))
            return;
        m_rows.push_back({.text = text,
                          .word = word,
                          .draw =
                              [&theme = m_theme, style](QPainter& p, const QRectF& r) {
                                  drawIceberg(p, r.center(), style, theme);
                              },
                          .height_px = kSymbolRow_px});
    }

    template <class Test>
    [[nodiscard]] bool any(const Test& test) const
    {
        return std::any_of(m_picture.icebergs.begin(), m_picture.icebergs.end(), test);
    }

    [[nodiscard]] std::vector<LegendRow> take() { return std::move(m_rows); }

private:
    const MapPicture& m_picture;
    const Theme& m_theme;
    std::vector<LegendRow> m_rows;
};

void addIcebergRows(RowList& rows, const MapPicture& picture, const MapStyle& style)
{
    const Theme& theme = style.theme;
    const bool isCertain =
        !rows.any([](const MapIceberg& iceberg) { return iceberg.inView && iceberg.sigma_m2 > 0; });
    // In flight the row stays, so that the rows below do not jump.
    const bool stays = style.isLive && picture.anyRoute([](const MapRoute& route) {
        return route.track.size() > 1;
    });
    rows.addIceberg(
        [stays](const MapIceberg& iceberg) { return iceberg.inView || stays; },
        isCertain ? MapLegend::tr("In view now: σ is 0") : MapLegend::tr("In view now"),
        MapLegend::tr("In view"),
        {.radius_px = 6, .sigma = {}, .inView = true, .bracket = routeColours(picture, theme).uav});
    rows.addIceberg([](const MapIceberg& iceberg) { return iceberg.appears_s > 0; },
                    MapLegend::tr("Appears later, with time"), MapLegend::tr("Appears later"),
                    {.radius_px = 6, .ring_px = 10, .sigma = theme.sigma.at(0.3), .later = true});
    rows.addIceberg([](const MapIceberg& iceberg) { return iceberg.status == TrackStatus::Lost; },
                    MapLegend::tr("Lost: not found where expected"), MapLegend::tr("Lost"),
                    {.radius_px = 8, .sigma = {}, .status = TrackStatus::Lost});
    rows.addIceberg(
        [](const MapIceberg& iceberg) { return iceberg.status == TrackStatus::GivenUp; },
        MapLegend::tr("Search given up"), MapLegend::tr("Given up"),
        {.radius_px = 8, .sigma = {}, .status = TrackStatus::GivenUp});
    rows.add(rows.any([](const MapIceberg& iceberg) { return iceberg.circle_m > 0.0; }),
             MapLegend::tr("95 % position circle"), MapLegend::tr("95 % circle"),
             [&](QPainter& p, const QRectF& r) { drawRingSwatch(p, r, circlePen(theme)); });
    rows.add(rows.any([](const MapIceberg& iceberg) { return iceberg.truth_m.has_value(); }),
             MapLegend::tr("True position"), MapLegend::tr("Truth"),
             [&](QPainter& p, const QRectF& r) { drawTruth(p, r.center(), theme); });
    rows.add(rows.any([](const MapIceberg& iceberg) { return iceberg.ringEntry_s.has_value(); }),
             MapLegend::tr("Will enter inner ring"), MapLegend::tr("Enters ring"),
             [&](QPainter& p, const QRectF& r) { drawAlarm(p, r.center(), theme); });
}

void addFleetRows(RowList& rows, const MapPicture& picture, const Theme& theme)
{
    rows.add(!pairsTooClose(picture).empty(), MapLegend::tr("UAVs too close to each other"),
             MapLegend::tr("Too close"),
             [&](QPainter& p, const QRectF& r) { drawAlarm(p, r.center(), theme); });
    rows.add(rows.any([](const MapIceberg& iceberg) { return iceberg.assignedUav.has_value(); }),
             MapLegend::tr("Assigned to the UAV of this colour"), MapLegend::tr("Assigned to one"),
             [&](QPainter& p, const QRectF& r) {
                 drawPin(p, r.center() + QPointF(0, 7), theme.ink, theme);
             });
}

void addPathRows(RowList& rows, const MapPicture& picture, const Theme& theme,
                 const MapLayers& layers)
{
    const RouteColours colours = routeColours(picture, theme);
    rows.add(
        picture.anyRoute([](const MapRoute& route) { return !route.plan.empty(); }),
        MapLegend::tr("Plan, next leg thicker"), MapLegend::tr("Plan"),
        [&theme, colours](QPainter& p, const QRectF& r) { drawPlanSwatch(p, r, colours, theme); });
    rows.add(picture.anyRoute(hasRepeatVisits), MapLegend::tr("Later visit in the plan"),
             MapLegend::tr("Later visit"), [&theme, colours](QPainter& p, const QRectF& r) {
                 paintLaterDisk(p, r.center(), 9, colours.plan, theme);
             });
    rows.add(
        picture.anyRoute([](const MapRoute& route) { return !route.search_m.empty(); }),
        MapLegend::tr("Search pattern"), MapLegend::tr("Search"),
        [colours](QPainter& p, const QRectF& r) { drawLineSwatch(p, r, searchPen(colours.uav)); });
    rows.add(
        picture.anyRoute([](const MapRoute& route) { return !route.searchPlaces.empty(); }),
        MapLegend::tr("Place to search, probability of finding"), MapLegend::tr("Place to search"),
        [colours](QPainter& p, const QRectF& r) { drawSearchPlace(p, r.center(), colours.plan); });
    rows.add(std::any_of(picture.clusters.begin(), picture.clusters.end(),
                         [](const MapPlaces& members) { return members.size() > 1; }),
             MapLegend::tr("Planned as one point"), MapLegend::tr("One point"),
             [&theme, colours](QPainter& p, const QRectF& r) {
                 drawClusterSwatch(p, r, colours.plan, theme);
             });
    rows.add(picture.anyRoute([](const MapRoute& route) { return !route.planPaths.empty(); }),
             MapLegend::tr("Point aimed at"), MapLegend::tr("Aim point"),
             [&theme, colours](QPainter& p, const QRectF& r) {
                 drawAim(p, r.center(), colours.plan, theme);
             });
    rows.add(picture.anyRoute([](const MapRoute& route) { return !route.laterVisits_m.empty(); }),
             MapLegend::tr("Later visits of the patrol"), MapLegend::tr("Patrol"),
             [colours](QPainter& p, const QRectF& r) {
                 drawLineSwatch(p, r, laterVisitsPen(colours.plan));
             });
    rows.add(layers.shows(MapLayer::FormerPlan) &&
                 picture.anyRoute([](const MapRoute& route) { return !route.formerPlan.empty(); }),
             MapLegend::tr("Plan before the change"), MapLegend::tr("Former plan"),
             [colours](QPainter& p, const QRectF& r) {
                 drawLineSwatch(p, r, formerPlanPen(colours.former));
             });
    rows.add(
        picture.anyRoute([](const MapRoute& route) { return route.track.size() > 1; }),
        MapLegend::tr("Flown, older parts fainter"), MapLegend::tr("Flown"),
        [&theme, colours](QPainter& p, const QRectF& r) { drawTrackSwatch(p, r, colours, theme); });
    const QFontMetricsF small(theme.small());
    rows.add(
        layers.shows(MapLayer::Compared) &&
            std::any_of(picture.comparisonTracks.begin(), picture.comparisonTracks.end(),
                        [](const std::vector<MapTrackPoint>& track) { return track.size() > 1; }),
        small.elidedText(MapLegend::tr("Compared: %1").arg(picture.comparisonName), Qt::ElideRight,
                         kLegendBar_px + kLegendUnits_px),
        small.elidedText(picture.comparisonName, Qt::ElideRight, kLegendBar_px / 2),
        [&](QPainter& p, const QRectF& r) { drawComparisonSwatch(p, r, theme); });
    rows.add(!picture.uavs.empty(), MapLegend::tr("Field of view"), MapLegend::tr("Field of view"),
             [colours](QPainter& p, const QRectF& r) { drawFieldSwatch(p, r, colours.uav); });
    rows.add(
        layers.shows(MapLayer::Tracks) && layers.tracks && !layers.tracks->empty(),
        MapLegend::tr("Predicted drift, circle: 1 σ"), MapLegend::tr("Predicted drift"),
        [&theme](QPainter& p, const QRectF& r) { drawLineSwatch(p, r, driftTrackPen(theme)); });
    rows.add(layers.shows(MapLayer::Swept) && picture.showsSwept(), MapLegend::tr("Seen so far"),
             MapLegend::tr("Seen so far"),
             [&](QPainter& p, const QRectF& r) { drawSweptSwatch(p, r, theme); });
}

/** Draws the colours of the classes from open water to the closest ice, on the sea. */
void drawIceSwatch(QPainter& painter, const QRectF& swatch, std::span<const IceClass> classes,
                   const Theme& theme, double opacity)
{
    const QRectF box(swatch.left() + 2, swatch.center().y() - 6, swatch.width() - 4, 12);
    painter.fillRect(box, theme.sea);
    const double width = box.width() / static_cast<double>(classes.size());
    for (std::size_t i = 0; i < classes.size(); ++i) {
        QColor colour = QColor::fromRgba(iceFill(classes[i]));
        if (theme.isNight)
            colour = theme.toned(colour);
        colour.setAlphaF(colour.alphaF() * static_cast<float>(opacity));
        painter.fillRect(
            QRectF(box.left() + static_cast<double>(i) * width, box.top(), width, box.height()),
            colour);
    }
    painter.setPen(QPen(theme.panelLine, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(box);
}

/** "2021-01-18 18:00 UTC" */
QString dateText(const IceChart& chart)
{
    constexpr int kMinutes = 16; // length of the date with hours and minutes
    return chart.dateUtc.empty()
               ? MapLegend::tr("no date", "ice chart")
               : QString::fromStdString(chart.dateUtc).left(kMinutes).replace(u'T', u' ') +
                     u" UTC"_s;
}

/** Adds the chart with its date, and each class of ice on it. */
void addIceRows(RowList& rows, const MapPicture& picture, const MapStyle& style)
{
    const double opacity = style.layers.opacity(MapLayer::IceChart);
    if (picture.iceChart == nullptr || opacity <= 0 || picture.iceChart->chart.areas.empty())
        return;
    const std::array<std::pair<QString, QString>, kIceClasses> names{
        {{MapLegend::tr("Ice free"), u"0/10"_s},
         {MapLegend::tr("Open water"), u"<1/10"_s},
         {MapLegend::tr("Ice 1–3 tenths"), u"1–3/10"_s},
         {MapLegend::tr("Ice 4–6 tenths"), u"4–6/10"_s},
         {MapLegend::tr("Ice 7–8 tenths"), u"7–8/10"_s},
         {MapLegend::tr("Ice 9–10 tenths"), u"9–10/10"_s},
         {MapLegend::tr("Fast ice"), MapLegend::tr("Fast ice")},
         {MapLegend::tr("Ice, concentration unknown"), u"?/10"_s}}};
    const IceChart& chart = picture.iceChart->chart;
    std::set<IceClass> classes;
    for (const IceArea& area : chart.areas)
        classes.insert(classOf(area));
    const std::vector<IceClass> there(classes.begin(), classes.end());
    const Theme& theme = style.theme;
    rows.add(true,
             (picture.iceChart->isOld ? MapLegend::tr("Old ice chart: %1")
                                      : MapLegend::tr("Ice chart: %1"))
                 .arg(dateText(chart)),
             picture.iceChart->isOld ? MapLegend::tr("Old ice chart") : MapLegend::tr("Ice chart"),
             [&theme, there, opacity](QPainter& p, const QRectF& r) {
                 drawIceSwatch(p, r, there, theme, opacity);
             });
    for (const IceClass one : there)
        rows.add(true, names[static_cast<std::size_t>(one)].first,
                 names[static_cast<std::size_t>(one)].second,
                 [&theme, one, opacity](QPainter& p, const QRectF& r) {
                     drawIceSwatch(p, r, std::span(&one, 1), theme, opacity);
                 });
}

void addPermitRows(RowList& rows, const MapPicture& picture, const Theme& theme,
                   const MapLayers& layers)
{
    const bool isShown = layers.shows(MapLayer::Permit);
    rows.add(isShown && !picture.airspace.empty(), MapLegend::tr("Airspace, for information"),
             MapLegend::tr("Airspace"),
             [&](QPainter& p, const QRectF& r) { drawLineSwatch(p, r, airspacePen(theme)); });
    const auto part = [&](VolumePart which, const QString& text, const QString& word) {
        rows.add(isShown && picture.operation.has_value(), text, word,
                 [&theme, which](QPainter& p, const QRectF& r) {
                     drawLineSwatch(p, r, volumePen(which, theme));
                 });
    };
    part(VolumePart::Geography, MapLegend::tr("Flight geography, proposal"),
         MapLegend::tr("Flight geography"));
    part(VolumePart::Contingency, MapLegend::tr("Contingency volume, proposal"),
         MapLegend::tr("Contingency"));
    part(VolumePart::Buffer, MapLegend::tr("Ground-risk buffer, proposal"),
         MapLegend::tr("Risk buffer"));
    part(VolumePart::Adjacent, MapLegend::tr("Adjacent area, proposal"),
         MapLegend::tr("Adjacent area"));
}

/** Explains the marks of a forecast; the barb is one of 15 kn. */
void addWeatherRows(RowList& rows, const MapPicture& picture, const Theme& theme,
                    const MapLayers& layers)
{
    const MapWeather* weather = picture.weather.get();
    const bool isSouthern = weather != nullptr && weather->isSouthern();
    rows.add(weather != nullptr && weather->givesWind() && layers.shows(MapLayer::Wind),
             MapLegend::tr("Forecast wind, full barb 10 kn"), MapLegend::tr("Forecast wind"),
             [&theme, isSouthern](QPainter& p, const QRectF& r) {
                 drawWindBarb(p, r.center() + QPointF(11, isSouthern ? -3 : 3), Point(7.7, 0),
                              isSouthern, theme);
             });
    rows.add(weather != nullptr && weather->givesCurrent() && layers.shows(MapLayer::Current),
             MapLegend::tr("Forecast current"), MapLegend::tr("Forecast current"),
             [&theme](QPainter& p, const QRectF& r) {
                 drawCurrentArrow(p, r.center(), Point(0.4, 0), theme);
             });
}

void addPlaceRows(RowList& rows, const MapPicture& picture, const Theme& theme,
                  const MapLayers& layers)
{
    rows.add(std::any_of(picture.uavs.begin(), picture.uavs.end(),
                         [](const MapUav& uav) { return uav.home_m.has_value(); }),
             MapLegend::tr("Home"), MapLegend::tr("Home"),
             [&](QPainter& p, const QRectF& r) { drawHome(p, r.center(), theme.ink, theme); });
    rows.add(picture.anyRoute([](const MapRoute& route) { return !route.toNoReturn_m.empty(); }),
             MapLegend::tr("Point of no return"), MapLegend::tr("Point of no return"),
             [&](QPainter& p, const QRectF& r) { drawNoReturn(p, r.center(), theme.uav, theme); });
    rows.add(picture.station.has_value(), MapLegend::tr("Radio range of the ground station"),
             MapLegend::tr("Radio range"),
             [&](QPainter& p, const QRectF& r) { drawRingSwatch(p, r, linkRingPen(theme)); });
    rows.add(picture.isFenced && !picture.area_m.empty(),
             MapLegend::tr("Geofence (kept if the UAV starts inside it)"),
             MapLegend::tr("Geofence"),
             [&](QPainter& p, const QRectF& r) { drawFenceSwatch(p, r, theme); });
    const auto hasClosed = [&](bool isRing) {
        return std::any_of(picture.closed.begin(), picture.closed.end(),
                           [&](const MapClosedArea& area) { return area.isRing == isRing; });
    };
    const auto closedSwatch = [&](QPainter& p, const QRectF& r) {
        drawClosed(p, QPolygonF(QRectF(r.center().x() - 13, r.center().y() - 7, 26, 14)), r, theme);
    };
    rows.add(hasClosed(false), MapLegend::tr("No-fly area"), MapLegend::tr("No-fly area"),
             closedSwatch);
    rows.add(hasClosed(true), MapLegend::tr("Stand-off round the asset"),
             MapLegend::tr("Stand-off"), closedSwatch);
    addPermitRows(rows, picture, theme, layers);
    rows.add(picture.asset.has_value(), MapLegend::tr("Asset's range: more urgent inside"),
             MapLegend::tr("Asset's range"),
             [&](QPainter& p, const QRectF& r) { drawRingSwatch(p, r, rangeRingPen(theme)); });
    rows.add(picture.asset.has_value(), MapLegend::tr("Inner ring: alarm"),
             MapLegend::tr("Inner ring"),
             [&](QPainter& p, const QRectF& r) { drawRingSwatch(p, r, alarmRingPen(theme)); });
}

} // namespace

std::vector<LegendRow> legendRows(const MapPicture& picture, const MapStyle& style,
                                  const SymbolScale& scale)
{
    const Theme& theme = style.theme;
    RowList rows(picture, theme);
    addIcebergRows(rows, picture, style);
    addFleetRows(rows, picture, theme);
    addPathRows(rows, picture, theme, style.layers);
    addWeatherRows(rows, picture, theme, style.layers);
    addPlaceRows(rows, picture, theme, style.layers);
    addIceRows(rows, picture, style);
    rows.add(scale.showsDots, MapLegend::tr("Close together: dot or number"),
             MapLegend::tr("Close together"), [&theme](QPainter& p, const QRectF& r) {
                 drawIcebergDot(p, r.center() - QPointF(11, 0), theme.sigma.at(0.4), false, theme);
                 drawIcebergCount(p, r.center() + QPointF(7, 0), 4, theme.sigma.at(0.4), theme);
             });
    const QString drift =
        MapLegend::tr("Drift in %1").arg(durationText(scale.driftTime_s, style.locale));
    rows.add(scale.driftTime_s > 0 && !scale.showsDots, drift, drift,
             [&theme](QPainter& p, const QRectF& r) {
                 const QLineF arrow(r.left() + 4, r.center().y(), r.right() - 4, r.center().y());
                 drawArrow(p, arrow, QPen(theme.ink, 1.6), 7);
             });
    return rows.take();
}

LegendUavs::LegendUavs(const MapPicture& picture, const Theme& theme, double width_px)
{
    const QFontMetricsF metrics(theme.small());
    QPointF at(0, kSignRow_px / 2);
    for (const MapUav& uav : picture.uavs) {
        if (uav.label.isEmpty())
            continue;
        const QString name = metrics.elidedText(uav.label, Qt::ElideRight, width_px - kSign_px);
        const double chip_px = kSign_px + metrics.horizontalAdvance(name);
        if (at.x() > 0 && at.x() + chip_px > width_px)
            at = QPointF(0, at.y() + kSignRow_px);
        m_chips.push_back({.at = at, .name = name, .colour = uavColour(theme, uav.place)});
        at.rx() += chip_px + kSignGap_px;
    }
    if (!m_chips.empty())
        m_height_px = at.y() + kSignRow_px / 2;
}

void LegendUavs::paint(QPainter& painter, const QPointF& at, const Theme& theme) const
{
    for (const Chip& chip : m_chips) {
        const PainterState saved(painter);
        painter.translate(at + chip.at);
        painter.setFont(theme.small());
        painter.setPen(theme.text);
        painter.drawText(QRectF(kSign_px, -kSignRow_px / 2, 1000, kSignRow_px),
                         static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter), chip.name);
        painter.translate(kSign_px / 2 - 3, 0);
        painter.scale(kSignScale, kSignScale);
        drawUav(painter, {0, 0}, 0, chip.colour, theme);
    }
}

} // namespace berg
