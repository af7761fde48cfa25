#include "widgets/map/paint/overview_inset.h"

#include "core/base/angles.h"
#include "widgets/map/paint/map_overlays.h"
#include "widgets/theme/accessible_roles.h"
#include "widgets/theme/quantity_text.h"

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kFrame_px = 5; // width of the panel's frame
constexpr double kLargestScale_pxpm = 2e-3;
constexpr double kNotch = 120; // eighths of a degree
constexpr double kWheelZoom = 1.25;
constexpr double kParallels_px = 26; // smallest distance of parallels
constexpr double kSmallestBox_px = 7;
constexpr double kMark_px = 4;

/** Customary orientation: Greenland below the North Pole, Greenwich above the South Pole. */
PolarFrame frameOf(Pole pole)
{
    return pole == Pole::North ? PolarFrame(pole, -45) : PolarFrame(pole, 0);
}

/** Strokes a line with a rim that separates it from land and sea. */
void strokeTwice(QPainter& painter, const QPolygonF& line, const QColor& colour, const QColor& rim)
{
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(rim, 3.6));
    painter.drawPolygon(line);
    painter.setPen(QPen(colour, 1.6));
    painter.drawPolygon(line);
}

} // namespace

OverviewInset::OverviewInset(QWidget* parent) : QWidget(parent), m_frame(frameOf(Pole::North))
{
    setObjectName(u"overviewInset"_s);
    setMouseTracking(true);
    setCursor(Qt::CrossCursor);
    connect(&m_land, &LandLayer::updated, this, qOverload<>(&QWidget::update));
    updateTexts();
    showWhole();
}

void OverviewInset::setTheme(const Theme& theme)
{
    m_theme = theme;
    update();
}

void OverviewInset::setNavigable(bool navigable)
{
    m_isNavigable = navigable;
    if (!navigable)
        showWhole();
}

void OverviewInset::setPole(Pole pole)
{
    m_frame = frameOf(pole);
    showWhole();
}

void OverviewInset::setPlace(const LatLon& place)
{
    m_place = place;
    const Pole nearest = place.latitude_deg < 0 ? Pole::South : Pole::North;
    if (nearest != pole())
        setPole(nearest);
    update();
}

void OverviewInset::setExtent(std::vector<LatLon> outline)
{
    if (outline == m_extent)
        return;
    m_extent = std::move(outline);
    update();
}

QPointF OverviewInset::pixelOf(const LatLon& place) const
{
    return m_view.toPixel(m_frame.toPlane(place));
}

std::optional<LatLon> OverviewInset::placeAt(const QPointF& at) const
{
    const Point p_m = m_view.toWorld(at);
    if (!chartRect().contains(at) || p_m.norm() > mapReach_m(m_frame))
        return std::nullopt;
    return m_frame.toGeographic(p_m);
}

void OverviewInset::zoomBy(double factor, const QPointF& at)
{
    const double scale_pxpm = std::clamp(m_view.scale_pxpm() * factor, wholeScale_pxpm(),
                                         std::max(kLargestScale_pxpm, wholeScale_pxpm()));
    setView(m_view.zoomed(scale_pxpm / m_view.scale_pxpm(), at));
}

void OverviewInset::finishLand()
{
    m_land.finish();
}

QRectF OverviewInset::chartRect() const
{
    return QRectF(rect()).adjusted(kFrame_px, kFrame_px, -kFrame_px, -kFrame_px);
}

double OverviewInset::wholeScale_pxpm() const
{
    const QSizeF size = chartRect().size();
    return std::max(10.0, std::min(size.width(), size.height())) / (2 * mapReach_m(m_frame));
}

void OverviewInset::showWhole()
{
    m_view = MapViewTransform(Point::Zero(), chartRect().center(), wholeScale_pxpm());
    update();
}

/** Limits the view so that the chart covers as much of its rectangle as possible. */
void OverviewInset::setView(const MapViewTransform& view)
{
    const QRectF chart = chartRect();
    const double reach_px = mapReach_m(m_frame) * view.scale_pxpm();
    const QPointF pole_px = view.toPixel(Point::Zero());
    const auto limited = [&](double at, double middle, double side_px) {
        const double slack_px = std::max(0.0, reach_px - side_px / 2);
        return std::clamp(at, middle - slack_px, middle + slack_px);
    };
    const QPointF wanted(limited(pole_px.x(), chart.center().x(), chart.width()),
                         limited(pole_px.y(), chart.center().y(), chart.height()));
    m_view = view.moved(wanted - pole_px);
    update();
}

void OverviewInset::updateTexts()
{
    setAccessibleRole(*this, QAccessible::Canvas);
    setAccessibleName(tr("Overview"));
    setAccessibleDescription(
        tr("Polar chart showing the location of the map. Click a place to move the map there."));
}

void OverviewInset::paintGraticule(QPainter& painter) const
{
    double step_deg = 10;
    const auto spacing_px = [&](double degrees) { return degrees * 111'200 * m_view.scale_pxpm(); };
    for (const double finer_deg : {5.0, 2.0, 1.0})
        if (spacing_px(finer_deg) >= 3 * kParallels_px)
            step_deg = finer_deg;
    if (spacing_px(step_deg) < kParallels_px)
        step_deg = 20;
    QColor line = m_theme.graticule; // faint, so that the land stands out
    line.setAlphaF(0.35F * line.alphaF());
    painter.setPen(QPen(line, 1));
    painter.setBrush(Qt::NoBrush);
    const double sign = pole() == Pole::North ? 1 : -1;
    const QPointF centre = m_view.toPixel(Point::Zero());
    for (double away_deg = step_deg; away_deg < kMapReach_deg; away_deg += step_deg) {
        const QLineF radius(centre, pixelOf({sign * (90 - away_deg), 0}));
        painter.drawEllipse(centre, radius.length(), radius.length());
    }
    const double apart_deg = 3 * step_deg > 30 ? 45 : 3 * step_deg;
    for (double longitude_deg = -180; longitude_deg < 180; longitude_deg += apart_deg)
        painter.drawLine(QLineF(pixelOf({sign * (90 - step_deg), longitude_deg}),
                                pixelOf({sign * (90 - kMapReach_deg), longitude_deg})));
}

void OverviewInset::paintMarks(QPainter& painter) const
{
    QPolygonF box;
    for (const LatLon& corner : m_extent)
        box << pixelOf(corner);
    const QRectF bounds = box.boundingRect();
    if (std::max(bounds.width(), bounds.height()) >= kSmallestBox_px)
        strokeTwice(painter, box, m_theme.plan, m_theme.sea);
    if (!m_place)
        return;
    painter.setPen(QPen(m_theme.panel, 1.5));
    painter.setBrush(m_theme.uav);
    painter.drawEllipse(pixelOf(*m_place), kMark_px, kMark_px);
}

void OverviewInset::paintCoordinates(QPainter& painter) const
{
    const std::optional<LatLon> place = m_cursor ? placeAt(*m_cursor) : std::nullopt;
    if (!place)
        return;
    const std::optional<int> decimals =
        m_view.scale_pxpm() > 2e-4 ? std::optional(0) : std::nullopt;
    const QString text = placeText(*place, decimals, locale());
    const QFontMetricsF metrics(m_theme.small());
    const QSizeF size(metrics.horizontalAdvance(text) + 12, metrics.height() + 6);
    const QRectF chart = chartRect();
    const QRectF chip(
        QPointF(chart.center().x() - size.width() / 2, chart.bottom() - size.height()), size);
    paintPanel(painter, chip, m_theme);
    painter.setFont(m_theme.small());
    painter.setPen(m_theme.text);
    painter.drawText(chip, Qt::AlignCenter, text);
}

void OverviewInset::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintPanel(painter, rect(), m_theme);
    const QRectF chart = chartRect();
    painter.save();
    painter.setClipRect(chart);
    const std::optional<QPainterPath> reach = reachIn(chart, m_frame, m_view);
    if (reach)
        painter.setClipPath(*reach, Qt::IntersectClip);
    m_land.paint(painter, {.plane = m_frame,
                           .view = m_view,
                           .rect = chart,
                           .ratio = devicePixelRatioF(),
                           .style = landStyleOf(m_theme)});
    paintGraticule(painter);
    paintMarks(painter);
    painter.restore();
    if (reach) {
        painter.setClipRect(chart);
        painter.strokePath(*reach, QPen(m_theme.coast, 1));
    }
    paintCoordinates(painter);
}

void OverviewInset::resizeEvent(QResizeEvent*)
{
    showWhole();
}

void OverviewInset::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange) {
        updateTexts();
        update();
    }
    QWidget::changeEvent(event);
}

void OverviewInset::mousePressEvent(QMouseEvent* event)
{
    event->accept(); // keeps the event from the map below
    if (event->button() != Qt::LeftButton)
        return;
    m_pressed = event->position();
    m_movedTo = event->position();
}

void OverviewInset::mouseMoveEvent(QMouseEvent* event)
{
    event->accept();
    m_cursor = event->position();
    if (m_isNavigable && event->buttons().testFlag(Qt::LeftButton)) {
        const bool isMove = !m_pressed || QLineF(*m_pressed, event->position()).length() >=
                                              QApplication::startDragDistance();
        if (isMove) {
            m_pressed.reset();
            setView(m_view.moved(event->position() - m_movedTo));
            m_movedTo = event->position();
        }
    }
    update();
}

void OverviewInset::mouseReleaseEvent(QMouseEvent* event)
{
    event->accept();
    if (event->button() != Qt::LeftButton || !std::exchange(m_pressed, std::nullopt))
        return;
    if (const std::optional<LatLon> place = placeAt(event->position()))
        emit placePicked(*place);
}

void OverviewInset::wheelEvent(QWheelEvent* event)
{
    if (!m_isNavigable) {
        QWidget::wheelEvent(event);
        return;
    }
    zoomBy(std::pow(kWheelZoom, event->angleDelta().y() / kNotch), event->position());
    event->accept();
}

void OverviewInset::leaveEvent(QEvent*)
{
    m_cursor.reset();
    update();
}

} // namespace berg
