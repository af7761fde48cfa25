#include "widgets/map/paint/map_weather_layer.h"

#include "core/base/angles.h"
#include "core/io/figure/wind_barb.h"
#include "widgets/map/paint/map_overlays.h"
#include "widgets/map/paint/map_paint.h"
#include "widgets/theme/painter_state.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kMapShaft_px = 24;
constexpr double kMarkSpacing_px = 88;
constexpr double kHalo_px = 3.6;
constexpr double kStroke_px = 1.4;
constexpr double kDirectionSteps = 72; // directions of cached barbs
constexpr double kShortestArrow_px = 9;
constexpr double kLongestArrow_px = 34;
constexpr double kArrow_pxpmps = 30; // length of an arrow by speed
constexpr double kStillWater_mps = 0.02;
constexpr double kLengthStep_px = 2;    // of cached arrows
const QPointF kCurrentBeside_px(0, 15); // from the station of a barb

/** Rounds a direction, so that drawings can be cached. */
int directionStep(const Point& velocity_mps)
{
    const double share =
        std::atan2(velocity_mps.y(), velocity_mps.x()) / (2 * std::numbers::pi) * kDirectionSteps;
    return static_cast<int>(std::lround(share));
}

Point directionOf(int step)
{
    const double angle_rad = step * 2 * std::numbers::pi / kDirectionSteps;
    return {std::cos(angle_rad), std::sin(angle_rad)};
}

double arrowLength_px(const Point& current_mps)
{
    const double length_px = std::clamp(kShortestArrow_px + kArrow_pxpmps * current_mps.norm(),
                                        kShortestArrow_px, kLongestArrow_px);
    return std::round(length_px / kLengthStep_px) * kLengthStep_px;
}

QPolygonF weatherPolygon(const std::vector<Pixel>& path, const QPointF& at)
{
    QPolygonF polygon;
    for (const Pixel& pixel : path)
        polygon << at + QPointF(pixel.x, pixel.y);
    return polygon;
}

/** Draws with a halo in the colour of the sea first, so that lines are clear over any background.
 */
template <class Draw>
void withHalo(QPainter& painter, const QColor& ink, const Theme& theme, const Draw& draw)
{
    QColor halo = theme.sea;
    halo.setAlphaF(0.75F);
    for (const auto& [colour, width_px] : {std::pair(halo, kHalo_px), std::pair(ink, kStroke_px)}) {
        painter.setPen(QPen(colour, width_px, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        draw(colour);
    }
}

void addOccupied(std::vector<QRectF>& occupied, const QRectF& rect)
{
    if (!rect.isNull())
        occupied.push_back(rect);
}

/** Places that marks leave free: labels, symbols of UAVs, panels. */
std::vector<QRectF> occupiedBy(const MapPaint& p)
{
    std::vector<QRectF> occupied = p.layout.overlays();
    for (const PlacedLabel& label : p.layout.labels)
        addOccupied(occupied, label.rect);
    for (const QRectF& label : p.layout.uavLabels)
        addOccupied(occupied, label);
    for (const MapPlaceName& name : p.layout.places)
        addOccupied(occupied, name.rect);
    return occupied;
}

/** Area of a mark, without the gaps around it. */
QRectF areaOf(const MapWeatherMark& mark, bool showsWind, bool showsCurrent)
{
    QRectF area(mark.at_px, QSizeF());
    area.adjust(-4, -4, 4, 4);
    if (showsWind && mark.values.wind_mps && barbSpeed_kn(*mark.values.wind_mps) > 0) {
        const Point from = -mark.values.wind_mps->normalized() * kMapShaft_px;
        area |=
            QRectF(mark.at_px + QPointF(from.x(), -from.y()), QSizeF()).adjusted(-12, -12, 12, 12);
    }
    if (showsCurrent && mark.values.current_mps)
        area |= QRectF(mark.at_px + kCurrentBeside_px, QSizeF()).adjusted(-19, -19, 19, 19);
    return area;
}

/** Returns by mark whether something lies over it; the marks are few, and found by their place. */
std::vector<bool> coveredMarks(const MapPaint& p, bool showsWind, bool showsCurrent)
{
    const std::vector<MapWeatherMark>& marks = p.layout.weather->marks;
    std::vector<QRectF> areas;
    for (const MapWeatherMark& mark : marks)
        areas.push_back(areaOf(mark, showsWind, showsCurrent));
    std::vector<bool> isCovered(marks.size());
    for (const QRectF& rect : occupiedBy(p))
        for (std::size_t i = 0; i < marks.size(); ++i)
            if (!isCovered[i] && areas[i].intersects(rect))
                isCovered[i] = true;
    return isCovered;
}

void paintBarb(const MapPaint& p, const QPointF& at, const Point& wind_mps, bool isSouthern)
{
    const int speed_kn = barbSpeed_kn(wind_mps);
    const int direction = directionStep(wind_mps);
    constexpr double kReach_px = 2 * kWeatherMark_px;
    const auto draw = [&](QPainter& painter) {
        constexpr double kMpsPerKnot = 1852.0 / 3600;
        drawWindBarb(painter, {0, 0}, Point(directionOf(direction) * (speed_kn * kMpsPerKnot)),
                     isSouthern, p.theme);
    };
    paintCached(p, u"barb %1 %2 %3"_s.arg(speed_kn).arg(direction).arg(int(isSouthern)),
                QRectF(-kReach_px, -kReach_px, 2 * kReach_px, 2 * kReach_px), at, draw);
}

void paintCurrent(const MapPaint& p, const QPointF& middle, const Point& current_mps)
{
    if (current_mps.norm() < kStillWater_mps)
        return;
    const int direction = directionStep(current_mps);
    const double length_px = arrowLength_px(current_mps);
    const auto draw = [&](QPainter& painter) {
        drawCurrentArrow(
            painter, {0, 0},
            Point(directionOf(direction) * ((length_px - kShortestArrow_px) / kArrow_pxpmps)),
            p.theme);
    };
    paintCached(
        p, u"current %1 %2"_s.arg(length_px).arg(direction),
        QRectF(-kWeatherMark_px, -kWeatherMark_px, 2 * kWeatherMark_px, 2 * kWeatherMark_px),
        middle, draw);
}

} // namespace

MapWeatherMarksPointer weatherMarksIn(const MapPicture& picture, const MapViewTransform& view,
                                      const QRectF& rect, const MapWeatherMarksPointer& known)
{
    if (!picture.weather)
        return nullptr;
    if (known && known->weather == picture.weather && known->view == view && known->rect == rect)
        return known;
    auto marks = std::make_shared<MapWeatherMarks>();
    marks->weather = picture.weather;
    marks->view = view;
    marks->rect = rect;
    // Powers of two from a fixed base, so that zooming keeps every second mark.
    const double step_m = std::exp2(std::ceil(std::log2(kMarkSpacing_px / view.scale_pxpm())));
    const Point low_m = view.toWorld(rect.bottomLeft());
    const Point high_m = view.toWorld(rect.topRight());
    for (double north = std::ceil(low_m.y() / step_m); north * step_m <= high_m.y(); ++north)
        for (double east = std::ceil(low_m.x() / step_m); east * step_m <= high_m.x(); ++east) {
            const Point place_m(east * step_m, north * step_m);
            marks->marks.push_back(
                {.at_px = view.toPixel(place_m), .values = picture.weather->at(place_m)});
        }
    return marks;
}

void drawWindBarb(QPainter& painter, const QPointF& at, const Point& wind_mps, bool isSouthern,
                  const Theme& theme)
{
    const PainterState saved(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    const WindBarb barb = windBarb(wind_mps, kMapShaft_px, isSouthern);
    withHalo(painter, theme.ink, theme, [&](const QColor& colour) {
        painter.setBrush(Qt::NoBrush);
        if (barb.calm_px)
            painter.drawEllipse(at, *barb.calm_px, *barb.calm_px);
        for (const std::vector<Pixel>& line : barb.lines)
            painter.drawPolyline(weatherPolygon(line, at));
        painter.setBrush(colour);
        for (const std::vector<Pixel>& pennant : barb.pennants)
            painter.drawPolygon(weatherPolygon(pennant, at));
        if (!barb.calm_px)
            painter.drawEllipse(at, 1.2, 1.2);
    });
}

void drawCurrentArrow(QPainter& painter, const QPointF& middle, const Point& current_mps,
                      const Theme& theme)
{
    if (current_mps.isZero(0))
        return;
    const PainterState saved(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    const auto paths = velocityArrow(current_mps, arrowLength_px(current_mps));
    withHalo(painter, theme.plan, theme, [&](const QColor&) {
        for (const std::vector<Pixel>& path : paths)
            painter.drawPolyline(weatherPolygon(path, middle));
    });
}

void paintMapWeather(const MapPaint& p)
{
    const MapLayers& layers = p.style.layers;
    const double wind = layers.opacity(MapLayer::Wind);
    const double current = layers.opacity(MapLayer::Current);
    if (!p.layout.weather || (wind <= 0 && current <= 0))
        return;
    const PainterState saved(p.painter);
    const double opacity = p.painter.opacity();
    const bool isSouthern = p.picture.weather->isSouthern();
    const std::vector<bool> isCovered = coveredMarks(p, wind > 0, current > 0);
    const std::vector<MapWeatherMark>& marks = p.layout.weather->marks;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        if (isCovered[i])
            continue;
        const MapWeatherValues& values = marks[i].values;
        if (current > 0 && values.current_mps) {
            p.painter.setOpacity(opacity * current);
            paintCurrent(p, marks[i].at_px + (wind > 0 ? kCurrentBeside_px : QPointF()),
                         *values.current_mps);
        }
        if (wind > 0 && values.wind_mps) {
            p.painter.setOpacity(opacity * wind);
            paintBarb(p, marks[i].at_px, *values.wind_mps, isSouthern);
        }
    }
}

} // namespace berg
