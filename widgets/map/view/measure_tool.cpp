#include "widgets/map/view/measure_tool.h"

#include "core/base/angles.h"
#include "core/vehicle/dubins.h"
#include "widgets/map/paint/map_marks.h"
#include "widgets/map/view/map_view.h"
#include "widgets/theme/painter_state.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct MeasureToolText
{
    Q_DECLARE_TR_FUNCTIONS(MeasureTool)
};

constexpr double kSamePoint_px = 3;  // covers both clicks of a double click
constexpr double kPoint_px = 3.5;    // radius
constexpr double kLabelRoom_px = 90; // legs shorter than this have no label

/** Below this length a geodesic differs from a straight line on the map by less than a pixel. */
constexpr double kStraight_m = 20000;
constexpr int kMostPieces = 64;

/** Vector from one place to another: geodesic length and true bearing at the start. */
Point geodesicPath_m(LatLon from, LatLon to)
{
    return LocalFrame(from).toPlane(to); // the projection is exact from its origin
}

QPolygonF geodesicLine(const LocalFrame& plane, const MapViewTransform& view, const Point& from_m,
                       const Point& to_m)
{
    const LatLon from = plane.toGeographic(from_m);
    const LocalFrame about(from);
    const Point path_m = about.toPlane(plane.toGeographic(to_m));
    const int pieces = std::clamp(static_cast<int>(path_m.norm() / kStraight_m), 1, kMostPieces);
    QPolygonF line{view.toPixel(from_m)};
    for (int i = 1; i < pieces; ++i)
        line << view.toPixel(plane.toPlane(about.toGeographic(path_m * i / pieces)));
    line << view.toPixel(to_m);
    return line;
}

/** Length with decimetres at best, which are a pixel at the largest scale. */
QString measuredText(double length_m, const QLocale& locale)
{
    constexpr double kFine_m = 10;
    const bool isFine = length_m < kFine_m && shownUnits().distance == DistanceUnit::Metric;
    return isFine ? MeasureToolText::tr("%1 m").arg(fixedText(length_m, 1, locale))
                  : distanceText(length_m, locale);
}

QString legText(const MeasuredLeg& leg, const QLocale& locale)
{
    return u"%1  %2"_s.arg(measuredText(leg.length_m, locale), directionText(leg.bearing_deg));
}

} // namespace

MeasuredLeg measureLeg(const Scenario& scenario, const Point& wind_mps, const Point& from_m,
                       const Point& to_m)
{
    const LocalFrame plane(scenario.origin);
    const Point path_m = geodesicPath_m(plane.toGeographic(from_m), plane.toGeographic(to_m));
    MeasuredLeg leg{.length_m = path_m.norm()};
    if (leg.length_m > 0)
        leg.bearing_deg = headingFromPsi(std::atan2(path_m.y(), path_m.x()));
    const bool isFlown =
        !scenario.uavs.empty() && wind_mps.norm() < scenario.uavs.front().spec.airspeed_mps;
    if (!isFlown || leg.length_m <= 0 || to_m == from_m)
        return leg;
    const Point inPlane_m = (to_m - from_m).normalized() * leg.length_m;
    leg.time_s = flightTime_s(inPlane_m, scenario.uavs.front().spec.airspeed_mps, wind_mps);
    return leg;
}

void MeasureTool::press(const MapPointer& pointer)
{
    m_isPressed = !context().scene.isOverlay(pointer.at_px);
    m_now = pointer;
}

void MeasureTool::move(const MapPointer& pointer)
{
    m_now = pointer;
}

void MeasureTool::release(const MapPointer& pointer)
{
    if (!m_isPressed)
        return;
    m_isPressed = false;
    if (!pointer.isInside)
        return;
    if (!m_isOpen)
        m_points_m.clear();
    const MapViewTransform& view = context().scene.view();
    if (m_points_m.empty() ||
        QLineF(view.toPixel(m_points_m.back()), pointer.at_px).length() >= kSamePoint_px)
        m_points_m.push_back(placeOf(pointer));
    m_isOpen = true;
    m_now = pointer;
}

bool MeasureTool::hover(const MapPointer& pointer)
{
    m_now = pointer;
    m_isHovering = true;
    return m_isOpen;
}

void MeasureTool::finishDrawing()
{
    m_isOpen = false;
    if (m_points_m.size() < 2)
        m_points_m.clear();
}

void MeasureTool::undoLastPoint()
{
    if (!m_points_m.empty())
        m_points_m.pop_back();
    m_isOpen = !m_points_m.empty();
}

bool MeasureTool::cancelDrawing()
{
    const bool isThere = !m_points_m.empty();
    m_points_m.clear();
    m_isOpen = false;
    return isThere;
}

/** Points set so far, and the one under the cursor while the line is open. */
std::vector<Point> MeasureTool::line() const
{
    std::vector<Point> points_m = m_points_m;
    if (m_isOpen && m_isHovering)
        points_m.push_back(m_now.at_m);
    return points_m;
}

QString MeasureTool::totalText(const std::vector<MeasuredLeg>& legs) const
{
    const QLocale& locale = context().scene.locale();
    const Scenario& scenario = context().document.scenario();
    double length_m = 0;
    std::optional<double> time_s;
    for (const MeasuredLeg& leg : legs) {
        length_m += leg.length_m;
        if (leg.time_s)
            time_s = time_s.value_or(0) + *leg.time_s;
    }
    QString text = legText(legs.back(), locale);
    if (legs.size() > 1)
        text += u'\n' + MeasureToolText::tr("Total %1").arg(distanceText(length_m, locale, 4));
    if (!time_s)
        return text;
    const QString speed = speedText(scenario.uavs.front().spec.airspeed_mps, locale, 3);
    const QString time =
        context().scene.picture().air.wind_mps.isZero(0)
            ? MeasureToolText::tr("%1 at %2").arg(clockText(*time_s), speed)
            : MeasureToolText::tr("%1 at %2 in the wind").arg(clockText(*time_s), speed);
    return text + u'\n' + time;
}

/** Draws a leg with its label; that of the last leg is drawn at its end by `paint`. */
void MeasureTool::paintLeg(QPainter& painter, const Point& from_m, const Point& to_m,
                           const MeasuredLeg& leg, bool isLast) const
{
    const MapScene& scene = context().scene;
    const Theme& theme = scene.theme();
    const LocalFrame plane(context().document.scenario().origin);
    const QPolygonF line = geodesicLine(plane, scene.view(), from_m, to_m);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.sea, 4.5));
    painter.drawPolyline(line);
    painter.setPen(QPen(theme.text, 1.8, Qt::DashLine));
    painter.drawPolyline(line);
    const QLineF ends(line.front(), line.back());
    if (!isLast && ends.length() >= kLabelRoom_px)
        paintTag(painter, ends.center(), legText(leg, scene.locale()), theme);
}

void MeasureTool::paint(QPainter& painter) const
{
    const std::vector<Point> points_m = line();
    if (points_m.empty())
        return;
    const PainterState saved(painter);
    const MapScene& scene = context().scene;
    std::vector<MeasuredLeg> legs;
    for (std::size_t i = 0; i + 1 < points_m.size(); ++i) {
        legs.push_back(measureLeg(context().document.scenario(), scene.picture().air.wind_mps,
                                  points_m[i], points_m[i + 1]));
        paintLeg(painter, points_m[i], points_m[i + 1], legs.back(), i + 2 == points_m.size());
    }
    painter.setPen(QPen(scene.theme().text, 1.8));
    painter.setBrush(scene.theme().panel);
    for (const Point& point_m : m_points_m)
        painter.drawEllipse(scene.view().toPixel(point_m), kPoint_px, kPoint_px);
    if (!legs.empty())
        paintBubble(painter, scene.view().toPixel(points_m.back()), totalText(legs), scene.rect(),
                    scene.theme());
}

QCursor MeasureTool::cursor(const std::string&) const
{
    return Qt::CrossCursor;
}

QString MeasureTool::status() const
{
    if (m_isOpen)
        return MeasureToolText::tr("Click to set the next point. Enter ends the line, Backspace "
                                   "removes a point, Esc clears.");
    if (!m_points_m.empty())
        return MeasureToolText::tr("Click to start another line. Esc clears this one.");
    return MeasureToolText::tr("Click points to measure the path between them: geodesic length, "
                               "true bearing, time of flight.");
}

} // namespace berg
