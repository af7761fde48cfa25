#include "widgets/charts/decimate.h"
#include "widgets/charts/time_chart.h"
#include "widgets/theme/quantity_text.h"

#include <QAreaSeries>
#include <QChart>
#include <QCoreApplication>
#include <QFontMetricsF>
#include <QGraphicsLayout>
#include <QLineSeries>
#include <QValueAxis>

#include <algorithm>
#include <cmath>

namespace berg {
namespace {

constexpr double kTickSpacing_px = 52;      // least distance of grid lines
constexpr double kSmallTickSpacing_px = 30; // where the plot is low: up to
constexpr int kSmallSteps = 4;              // so many, or round numbers leave much of it empty
constexpr double kTimeSpacing_px = 84;
constexpr double kSimplify_px = 0.1;

/** Context of the texts: that of the class would have its namespace, which lupdate leaves out. */
struct TimeChartText
{
    Q_DECLARE_TR_FUNCTIONS(TimeChartText)
};

/** Visible lines with points. */
bool isShown(const TimeLine& line)
{
    return !line.hidden && !line.points.empty();
}

/** Has its name in the margin, and a colour that is not that of the axis. */
bool isOneOfMany(const TimeLine& line)
{
    return line.role == LineRole::Sigma || line.role == LineRole::Uav;
}

/** Cuts lines at the edges of the view: not every paint device clips, SVG does not. */
void cutToView(QList<QPointF>& points, const TimeWindow& view)
{
    const auto at = [](const QPointF& a, const QPointF& b, double x) {
        return QPointF(x, a.y() + (b.y() - a.y()) * (x - a.x()) / (b.x() - a.x()));
    };
    while (points.size() > 1 && points[1].x() <= view.from_s)
        points.removeFirst();
    while (points.size() > 1 && points[points.size() - 2].x() >= view.to_s)
        points.removeLast();
    if (points.size() < 2)
        return;
    if (points[0].x() < view.from_s)
        points[0] = at(points[0], points[1], view.from_s);
    if (points.back().x() > view.to_s)
        points.back() = at(points[points.size() - 2], points.back(), view.to_s);
}

} // namespace

bool TimeChart::hasPoints() const
{
    return std::any_of(m_content.lines.begin(), m_content.lines.end(),
                       [](const TimeLine& line) { return isShown(line); });
}

bool TimeChart::labelsInMargin() const
{
    return std::any_of(m_content.lines.begin(), m_content.lines.end(),
                       [](const TimeLine& line) { return isOneOfMany(line); });
}

bool TimeChart::hasRightAxis() const
{
    if (m_content.rightTitle.isEmpty() || m_content.lines.empty())
        return !m_content.rightTitle.isEmpty();
    return std::any_of(m_content.lines.begin(), m_content.lines.end(),
                       [](const TimeLine& line) { return line.onRightAxis && isShown(line); });
}

TimeChart::ValueRange TimeChart::range(bool onRightAxis) const
{
    ValueRange range;
    const auto include = [&range](double value) {
        range.lowest = std::min(range.lowest, value);
        range.highest = std::max(range.highest, value);
    };
    for (std::size_t i = 0; i < m_drawn.size(); ++i)
        if (m_content.lines[i].onRightAxis == onRightAxis)
            for (const QPointF& p : m_drawn[i])
                include(p.y());
    if (!onRightAxis && hasPoints())
        for (const ReferenceLine& reference : m_content.references)
            include(reference.value);
    return range;
}

std::vector<ChartTick> TimeChart::valueTicks(const NiceTicks& ticks) const
{
    std::vector<ChartTick> out;
    const int steps = ticks.below + ticks.count;
    for (int k = 0; k <= steps; ++k)
        out.push_back(
            {.at_px = m_frame.plot.bottom() - m_frame.plot.height() * k / steps,
             .text = fixedText((k - ticks.below) * ticks.step, ticks.decimals(), locale())});
    return out;
}

void TimeChart::setPlot(const NiceTicks& left, const NiceTicks& right)
{
    const QSizeF size = viewport()->size();
    const QFontMetricsF small(m_theme.small());
    const auto widest = [&small](const std::vector<ChartTick>& ticks) {
        double width_px = 0;
        for (const ChartTick& tick : ticks)
            width_px = std::max(width_px, small.horizontalAdvance(tick.text));
        return width_px;
    };
    double rightWidth_px = hasRightAxis() ? widest(valueTicks(right)) : 0;
    if (labelsInMargin())
        rightWidth_px = marginWidth();
    const double left_px = kChartSide_px + widest(valueTicks(left)) + kChartTickGap_px;
    const double right_px = size.width() - kChartSide_px - rightWidth_px - kChartTickGap_px;
    const double top_px = chartTop(m_frame);
    m_frame.plot = QRectF(left_px, top_px, std::max(10.0, right_px - left_px),
                          std::max(10.0, size.height() - top_px - kChartBottom_px));
    chart()->setPlotArea(m_frame.plot);
}

void TimeChart::layOut()
{
    m_isLaidOut = true;
    m_frame.title = m_titleShown ? m_content.title : QString();
    decimateLines();
    const double height_px = viewport()->height() - chartTop(m_frame) - kChartBottom_px;
    const int few = std::min(kSmallSteps, static_cast<int>(height_px / kSmallTickSpacing_px));
    const int most = std::max({1, few, static_cast<int>(height_px / kTickSpacing_px)});
    const ValueRange leftRange = range(false);
    const NiceTicks left = niceTicksAround(leftRange.lowest, leftRange.highest, most);
    NiceTicks right = niceTicksExactly(range(true).highest, std::max(1, left.count));
    right.below = left.below; // one grid
    right.count = left.count;
    setPlot(left, right);
    for (std::size_t i = 0; i < m_series.size(); ++i) {
        // Each change of an axis would lay out the points that are about to be replaced.
        m_series[i]->clear();
        if (m_areas[i] != nullptr)
            m_areas[i]->upperSeries()->clear();
    }
    setAxes(left, right);
    chart()->layout()->invalidate(); // or the grid stays where the old plot was
    chart()->layout()->activate();
    simplifyLines();
    styleLines();
    showPoints();
    fillFrame(left, right);
    if (labelsInMargin())
        placeMarginLabels();
    else
        placeInnerLabels();
    m_picture = {};
    viewport()->update();
}

int TimeChart::columns() const
{
    return std::max(1, viewport()->width() - static_cast<int>(2 * kChartSide_px));
}

void TimeChart::decimateLines()
{
    const TimeWindow shown = window();
    const DecimationWindow view{.from = shown.from_s, .to = shown.to_s, .columns = columns()};
    m_drawn.assign(m_content.lines.size(), {});
    for (std::size_t i = 0; i < m_drawn.size(); ++i) {
        const QList<QPointF>& points = m_content.lines[i].points;
        if (m_content.lines[i].hidden)
            continue;
        m_drawn[i] =
            m_content.isThinned
                ? points
                : decimate({points.constData(), static_cast<std::size_t>(points.size())}, view);
        cutToView(m_drawn[i], shown);
    }
}

void TimeChart::setAxes(const NiceTicks& left, const NiceTicks& right)
{
    m_left->setTickInterval(left.step);
    m_left->setRange(left.start(), left.end());
    m_right->setTickInterval(right.step);
    m_right->setRange(right.start(), right.end());
    const TimeWindow shown = window();
    m_time->setTickInterval(timeStep_s(
        shown.length_s(), std::max(1, static_cast<int>(m_frame.plot.width() / kTimeSpacing_px))));
    m_time->setRange(shown.from_s, shown.to_s);
}

double TimeChart::timeToView(double time_s) const
{
    return m_frame.plot.left() +
           m_frame.plot.width() * (time_s - m_time->min()) / (m_time->max() - m_time->min());
}

double TimeChart::viewToTime(double x_px) const
{
    const double part = (x_px - m_frame.plot.left()) / m_frame.plot.width();
    return m_time->min() + std::clamp(part, 0.0, 1.0) * (m_time->max() - m_time->min());
}

QPointF TimeChart::toView(const TimeLine& line, const QPointF& p) const
{
    const QValueAxis& axis = line.onRightAxis ? *m_right : *m_left;
    const double part = (p.y() - axis.min()) / (axis.max() - axis.min());
    return {timeToView(p.x()), m_frame.plot.bottom() - m_frame.plot.height() * part};
}

void TimeChart::fillFrame(const NiceTicks& left, const NiceTicks& right)
{
    const auto colourOf = [&](bool onRightAxis) {
        for (const TimeLine& line : m_content.lines)
            if (line.onRightAxis == onRightAxis && !isOneOfMany(line) && !line.hidden)
                return lineColour(line);
        return m_theme.mutedText;
    };
    m_frame.size = viewport()->size();
    m_frame.leftTitle = m_content.leftTitle;
    m_frame.rightTitle = hasRightAxis() ? m_content.rightTitle : QString();
    m_frame.timeTitle = m_time->max() >= 3600 ? TimeChartText::tr("Time, h:mm:ss")
                                              : TimeChartText::tr("Time, mm:ss");
    m_frame.leftColour = colourOf(false);
    m_frame.rightColour = colourOf(true);
    m_frame.left = valueTicks(left);
    m_frame.right = hasRightAxis() ? valueTicks(right) : std::vector<ChartTick>();
    m_frame.times.clear();
    const double step_s = m_time->tickInterval();
    const double first = std::ceil(m_time->min() / step_s - 1e-9);
    for (double k = first; k * step_s <= m_time->max() * (1 + 1e-9); ++k)
        m_frame.times.push_back({.at_px = timeToView(k * step_s), .text = clockText(k * step_s)});
    fillMarks();
    m_frame.labels.clear();
    m_frame.emptyText = hasPoints() ? QString() : m_content.emptyText;
}

void TimeChart::fillMarks()
{
    const auto inView = [this](double time_s) {
        return time_s >= m_time->min() && time_s <= m_time->max();
    };
    m_frame.marks_px.clear();
    for (const double time_s : m_content.marks_s)
        if (inView(time_s))
            m_frame.marks_px.push_back(timeToView(time_s));
    m_frame.marksTitle = m_content.marksTitle;
    m_frame.references.clear();
    if (hasPoints())
        for (const ReferenceLine& reference : m_content.references)
            m_frame.references.push_back(
                {.at_px = toView({}, {0, reference.value}).y(), .text = reference.label});
    m_frame.cursor_px.reset();
    if (m_content.cursor_s && inView(*m_content.cursor_s))
        m_frame.cursor_px = timeToView(*m_content.cursor_s);
}

void TimeChart::simplifyLines()
{
    for (std::size_t i = 0; i < m_drawn.size(); ++i) {
        const QValueAxis& axis = m_content.lines[i].onRightAxis ? *m_right : *m_left;
        const double unit = (axis.max() - axis.min()) / m_frame.plot.height();
        m_drawn[i] = simplified(m_drawn[i], kSimplify_px * unit);
    }
}

void TimeChart::showPoints()
{
    // Qt draws each segment by itself: fewer of them are faster and join without seams.
    for (std::size_t i = 0; i < m_drawn.size(); ++i) {
        m_series[i]->replace(m_drawn[i]);
        if (m_areas[i] != nullptr)
            m_areas[i]->upperSeries()->replace(m_drawn[i]);
    }
}

} // namespace berg
