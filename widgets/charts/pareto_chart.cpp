#include "widgets/charts/pareto_chart.h"

#include "widgets/model/curve_choice.h"
#include "widgets/theme/quantity_text.h"

#include <QFontMetricsF>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace berg {
namespace {

constexpr double kTickSpacing_px = 34;
constexpr double kDistanceSpacing_px = 64;
constexpr double kPlan_px = 3;
constexpr double kPresent_px = 6.5;
constexpr double kReach_px = 14;        ///< of the pointer
constexpr double kRoomForEnds_px = 240; ///< to name the ends of the front
constexpr double kTitleGap_px = 16;     ///< at least between the two titles
constexpr double kEndGap_px = 12;       ///< between a name and its end

double shownDistance(const CurveInterval& interval)
{
    return longDistanceUnit().fromSi(interval.distance_m);
}

} // namespace

ParetoChart::ParetoChart(const Theme& theme, QWidget* parent) : QWidget(parent), m_theme(theme)
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAccessibleName(tr("Distance against uncertainty reward"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    refresh();
}

void ParetoChart::setTheme(const Theme& theme)
{
    m_theme = theme;
    refresh();
}

void ParetoChart::setTitleShown(bool shown)
{
    m_titleShown = shown;
    refresh();
}

void ParetoChart::setCurve(const TauCurve& curve)
{
    m_curve = curve;
    setHovered(-1);
}

void ParetoChart::setOfFleet(bool isOfFleet)
{
    if (isOfFleet == m_isOfFleet)
        return;
    m_isOfFleet = isOfFleet;
    refresh();
}

void ParetoChart::setTau(double tau)
{
    if (tau == m_tau)
        return;
    m_tau = tau;
    refresh();
}

QSize ParetoChart::sizeHint() const
{
    return {400, 240};
}

QSize ParetoChart::minimumSizeHint() const
{
    return {280, 150};
}

void ParetoChart::refresh()
{
    m_present = presentInterval(m_curve, m_tau);
    layOut();
    const int shown = m_hovered >= 0 ? m_hovered : m_present;
    setAccessibleDescription(
        shown < 0 ? m_frame.emptyText
                  : intervalText(m_curve.intervals[static_cast<std::size_t>(shown)], locale()));
    update();
}

std::vector<ChartTick> ParetoChart::ticks(const NiceRange& axis, double from_px, double to_px) const
{
    std::vector<ChartTick> out;
    for (int k = 0; k <= axis.count; ++k)
        out.push_back({.at_px = from_px + (to_px - from_px) * k / axis.count,
                       .text = fixedText(axis.at(k), axis.decimals(), locale())});
    return out;
}

void ParetoChart::layOut()
{
    const std::vector<CurveInterval>& plans = m_curve.intervals;
    m_frame = {.size = size(), .leftColour = m_theme.mutedText, .rightColour = m_theme.text};
    m_frame.title = m_titleShown ? accessibleName() : QString();
    const double top_px = chartTop(m_frame);
    const double height_px = std::max(10.0, height() - top_px - kChartBottom_px);
    if (plans.empty()) {
        m_frame.plot =
            QRectF(kChartSide_px, top_px, std::max(10.0, width() - 2 * kChartSide_px), height_px);
        m_frame.emptyText = m_isOfFleet        ? tr("Available for a single UAV only")
                            : m_curve.complete ? tr("No icebergs to plan for")
                                               : tr("Computing the plans for every τ");
        return;
    }
    m_frame.timeTitle = tr("Distance, %1").arg(longDistanceUnit().name);
    // Along the curve both go down.
    m_reward = niceRange(plans.back().reward_m2, plans.front().reward_m2,
                         std::max(1, static_cast<int>(height_px / kTickSpacing_px)));
    m_distance = niceRange(shownDistance(plans.back()), shownDistance(plans.front()),
                           std::max(1, static_cast<int>((width() - 80) / kDistanceSpacing_px)));
    m_frame.left = ticks(m_reward, top_px + height_px, top_px);
    double widest_px = 0;
    for (const ChartTick& tick : m_frame.left)
        widest_px =
            std::max(widest_px, QFontMetricsF(m_theme.small()).horizontalAdvance(tick.text));
    const double left_px = kChartSide_px + widest_px + kChartTickGap_px;
    m_frame.plot =
        QRectF(left_px, top_px, std::max(10.0, width() - kChartSide_px - kPresent_px - left_px),
               height_px);
    m_frame.times = ticks(m_distance, m_frame.plot.left(), m_frame.plot.right());
    fillTitles();
}

/** What the vertical axis is, and the figures of the plan pointed at or of the present one. */
void ParetoChart::fillTitles()
{
    const int shown = m_hovered >= 0 ? m_hovered : m_present;
    if (shown >= 0) {
        const CurveInterval& plan = m_curve.intervals[static_cast<std::size_t>(shown)];
        m_frame.rightTitle = tr("%1, %2").arg(distanceText(plan.distance_m, locale()),
                                              sigmaText(plan.reward_m2, locale()));
    }
    const QFontMetricsF metrics(m_theme.small());
    const QString full = tr("Uncertainty reward, m²");
    const double room_px = width() - 2 * kChartSide_px - kTitleGap_px;
    const bool fits =
        metrics.horizontalAdvance(full) + metrics.horizontalAdvance(m_frame.rightTitle) < room_px;
    m_frame.leftTitle = fits ? full : tr("Reward, m²");
}

QPointF ParetoChart::place(const CurveInterval& interval) const
{
    const QRectF& plot = m_frame.plot;
    return {plot.left() + plot.width() * m_distance.share(shownDistance(interval)),
            plot.bottom() - plot.height() * m_reward.share(interval.reward_m2)};
}

std::vector<QPointF> ParetoChart::points() const
{
    std::vector<QPointF> out;
    for (const CurveInterval& interval : m_curve.intervals)
        out.push_back(place(interval));
    return out;
}

int ParetoChart::planNear(const QPointF& at) const
{
    int nearest = -1;
    double nearest_px = kReach_px;
    const std::vector<QPointF> places = points();
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double distance_px = std::hypot(places[i].x() - at.x(), places[i].y() - at.y());
        if (distance_px < nearest_px) {
            nearest = static_cast<int>(i);
            nearest_px = distance_px;
        }
    }
    return nearest;
}

void ParetoChart::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.fillRect(rect(), m_theme.chart);
    painter.setRenderHint(QPainter::Antialiasing);
    if (!m_curve.intervals.empty()) {
        paintChartGrid(painter, m_frame, m_theme);
        paintFront(painter);
    }
    paintChartFrame(painter, m_frame, m_theme);
    if (hasFocus()) {
        painter.setPen(QPen(m_theme.plan, 1));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void ParetoChart::paintFront(QPainter& painter) const
{
    QPolygonF line;
    for (const QPointF& point : points())
        line << point;
    painter.setPen(QPen(mixed(m_theme.chart, m_theme.plan, 0.6), 1.2));
    painter.drawPolyline(line);
    for (const CurveInterval& interval : m_curve.intervals)
        paintPlan(painter, interval, kPlan_px);
    if (m_hovered >= 0) {
        painter.setPen(QPen(m_theme.text, 1.4));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(place(m_curve.intervals[static_cast<std::size_t>(m_hovered)]),
                            kPlan_px + 3, kPlan_px + 3);
    }
    paintEnds(painter);
    if (m_present >= 0)
        paintPlan(painter, m_curve.intervals[static_cast<std::size_t>(m_present)], kPresent_px);
}

/** What the two ends of the front are; below and right of it there is room. */
void ParetoChart::paintEnds(QPainter& painter) const
{
    const std::vector<CurveInterval>& plans = m_curve.intervals;
    if (plans.size() < 2 || m_frame.plot.width() < kRoomForEnds_px)
        return;
    const QString longest = tr("Most uncertain first");
    const QString shortest = tr("Shortest path");
    const QFontMetricsF metrics(m_theme.small());
    painter.setFont(m_theme.small());
    painter.setPen(m_theme.mutedText);
    const QPointF top = place(plans.front());
    painter.drawText(QPointF(top.x() - metrics.horizontalAdvance(longest),
                             top.y() + kEndGap_px + metrics.ascent()),
                     longest);
    const QPointF foot = place(plans.back());
    painter.drawText(QPointF(foot.x() + kEndGap_px, foot.y() + metrics.ascent() / 2), shortest);
}

void ParetoChart::paintPlan(QPainter& painter, const CurveInterval& interval,
                            double radius_px) const
{
    const QPointF at = place(interval);
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_theme.chart); // a gap between disk and line
    painter.drawEllipse(at, radius_px + 1.5, radius_px + 1.5);
    painter.setPen(QPen(m_theme.plan, 1.5));
    painter.setBrush(interval.proven ? m_theme.plan : m_theme.chart);
    painter.drawEllipse(at, radius_px - 0.5, radius_px - 0.5);
}

void ParetoChart::resizeEvent(QResizeEvent* /*event*/)
{
    layOut();
}

void ParetoChart::setHovered(int plan)
{
    m_hovered = plan;
    setToolTip(plan < 0
                   ? QString()
                   : intervalText(m_curve.intervals[static_cast<std::size_t>(plan)], locale()));
    refresh();
}

void ParetoChart::mouseMoveEvent(QMouseEvent* event)
{
    if (const int plan = planNear(event->position()); plan != m_hovered)
        setHovered(plan);
}

void ParetoChart::leaveEvent(QEvent* /*event*/)
{
    setHovered(-1);
}

void ParetoChart::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        QWidget::mousePressEvent(event);
        return;
    }
    const int plan = planNear(event->position());
    if (plan >= 0)
        choose(shortTau(m_curve.intervals[static_cast<std::size_t>(plan)]));
}

void ParetoChart::keyPressEvent(QKeyEvent* event)
{
    // To the right ways get longer.
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Down:
        choose(tauOfNextPlan(m_curve, m_tau));
        return;
    case Qt::Key_Right:
    case Qt::Key_Up:
        choose(tauOfPreviousPlan(m_curve, m_tau));
        return;
    default:
        QWidget::keyPressEvent(event);
    }
}

void ParetoChart::choose(std::optional<double> tau)
{
    if (tau)
        emit tauChosen(*tau);
}

} // namespace berg
