#include "widgets/charts/time_figure.h"

#include "widgets/charts/decimate.h"
#include "widgets/charts/line_look.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>
#include <QFontMetricsF>

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

bool hasRightAxis(const TimeChartContent& content)
{
    if (content.rightTitle.isEmpty() || content.lines.empty())
        return !content.rightTitle.isEmpty();
    return std::any_of(content.lines.begin(), content.lines.end(),
                       [](const TimeLine& line) { return line.onRightAxis && isShown(line); });
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

std::vector<QList<QPointF>> linesInView(const TimeChartContent& content, const TimeWindow& shown,
                                        int columns)
{
    const DecimationWindow view{.from = shown.from_s, .to = shown.to_s, .columns = columns};
    std::vector<QList<QPointF>> drawn(content.lines.size());
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        const QList<QPointF>& points = content.lines[i].points;
        if (content.lines[i].hidden)
            continue;
        drawn[i] =
            content.isThinned
                ? points
                : decimate({points.constData(), static_cast<std::size_t>(points.size())}, view);
        cutToView(drawn[i], shown);
    }
    return drawn;
}

struct ValueRange
{
    double lowest = 0;
    double highest = 0;
};

ValueRange rangeOf(const TimeFigure& figure, const TimeChartContent& content, bool onRightAxis)
{
    ValueRange range;
    const auto include = [&range](double value) {
        range.lowest = std::min(range.lowest, value);
        range.highest = std::max(range.highest, value);
    };
    for (std::size_t i = 0; i < figure.drawn.size(); ++i)
        if (content.lines[i].onRightAxis == onRightAxis)
            for (const QPointF& p : figure.drawn[i])
                include(p.y());
    if (!onRightAxis && hasPoints(content))
        for (const ReferenceLine& reference : content.references)
            include(reference.value);
    return range;
}

void setValueAxes(TimeFigure& figure, const TimeChartContent& content)
{
    const double height_px = figure.frame.size.height() - chartTop(figure.frame) - kChartBottom_px;
    const int few = std::min(kSmallSteps, static_cast<int>(height_px / kSmallTickSpacing_px));
    const int most = std::max({1, few, static_cast<int>(height_px / kTickSpacing_px)});
    const ValueRange left = rangeOf(figure, content, false);
    figure.left = niceTicksAround(left.lowest, left.highest, most);
    figure.right =
        niceTicksExactly(rangeOf(figure, content, true).highest, std::max(1, figure.left.count));
    figure.right.below = figure.left.below; // one grid
    figure.right.count = figure.left.count;
}

std::vector<ChartTick> valueTicks(const NiceTicks& ticks, const QRectF& plot, const QLocale& locale)
{
    std::vector<ChartTick> out;
    const int steps = ticks.below + ticks.count;
    for (int k = 0; k <= steps; ++k)
        out.push_back(
            {.at_px = plot.bottom() - plot.height() * k / steps,
             .text = fixedText((k - ticks.below) * ticks.step, ticks.decimals(), locale)});
    return out;
}

void setPlot(TimeFigure& figure, const TimeChartContent& content, const TimeFigureStyle& style)
{
    const QFontMetricsF small(style.theme.small());
    const auto widest = [&](const NiceTicks& ticks) {
        double width_px = 0;
        for (const ChartTick& tick : valueTicks(ticks, {}, style.locale))
            width_px = std::max(width_px, small.horizontalAdvance(tick.text));
        return width_px;
    };
    const double margin_px = labelMargin_px(content, style.theme, style.size_px.width());
    const double rightWidth_px = margin_px > 0           ? margin_px
                                 : hasRightAxis(content) ? widest(figure.right)
                                                         : 0;
    const double left_px =
        std::max(style.leastLeft_px, kChartSide_px + widest(figure.left) + kChartTickGap_px);
    const double right_px =
        style.size_px.width() -
        std::max(style.leastRight_px, kChartSide_px + rightWidth_px + kChartTickGap_px);
    const double top_px = chartTop(figure.frame);
    figure.frame.plot = QRectF(left_px, top_px, std::max(10.0, right_px - left_px),
                               std::max(10.0, style.size_px.height() - top_px - kChartBottom_px));
    if (hasRightAxis(content))
        figure.frame.rightEdge_px =
            figure.frame.plot.right() + kChartTickGap_px + widest(figure.right);
}

void simplifyLines(TimeFigure& figure, const TimeChartContent& content)
{
    for (std::size_t i = 0; i < figure.drawn.size(); ++i) {
        const NiceTicks& axis = figure.axisOf(content.lines[i]);
        const double unit = (axis.end() - axis.start()) / figure.frame.plot.height();
        figure.drawn[i] = simplified(figure.drawn[i], kSimplify_px * unit);
    }
}

void fillTitles(ChartFrame& frame, const TimeChartContent& content, const TimeFigureStyle& style)
{
    const auto colourOf = [&](bool onRightAxis) {
        for (const TimeLine& line : content.lines)
            if (line.onRightAxis == onRightAxis && !isOneOfMany(line) && !line.hidden)
                return lineColour(line, style.theme, content.sigmaFull_m2);
        return style.theme.mutedText;
    };
    frame.leftTitle = content.leftTitle;
    frame.rightTitle = hasRightAxis(content) ? content.rightTitle : QString();
    frame.timeTitle = style.window.to_s >= 3600 ? TimeChartText::tr("Time, h:mm:ss")
                                                : TimeChartText::tr("Time, mm:ss");
    frame.leftColour = colourOf(false);
    frame.rightColour = colourOf(true);
    frame.emptyText = hasPoints(content) ? QString() : content.emptyText;
}

void fillTicks(TimeFigure& figure, const TimeChartContent& content, const QLocale& locale)
{
    ChartFrame& frame = figure.frame;
    frame.left = valueTicks(figure.left, frame.plot, locale);
    if (hasRightAxis(content))
        frame.right = valueTicks(figure.right, frame.plot, locale);
    const double step_s = figure.timeStep_s;
    const double first = std::ceil(figure.window.from_s / step_s - 1e-9);
    for (double k = first; k * step_s <= figure.window.to_s * (1 + 1e-9); ++k)
        frame.times.push_back(
            {.at_px = figure.timeToView(k * step_s), .text = clockText(k * step_s)});
}

void fillMarks(TimeFigure& figure, const TimeChartContent& content)
{
    ChartFrame& frame = figure.frame;
    const auto inView = [&figure](double time_s) {
        return time_s >= figure.window.from_s && time_s <= figure.window.to_s;
    };
    for (const double time_s : content.marks_s)
        if (inView(time_s))
            frame.marks_px.push_back(figure.timeToView(time_s));
    frame.marksTitle = content.marksTitle;
    if (hasPoints(content))
        for (const ReferenceLine& reference : content.references)
            frame.references.push_back(
                {.at_px = figure.toView({}, {0, reference.value}).y(), .text = reference.label});
    if (content.cursor_s && inView(*content.cursor_s))
        frame.cursor_px = figure.timeToView(*content.cursor_s);
}

} // namespace

double TimeFigure::timeToView(double time_s) const
{
    return frame.plot.left() + frame.plot.width() * (time_s - window.from_s) / window.length_s();
}

double TimeFigure::viewToTime(double x_px) const
{
    const double part = (x_px - frame.plot.left()) / frame.plot.width();
    return window.from_s + std::clamp(part, 0.0, 1.0) * window.length_s();
}

QPointF TimeFigure::toView(const TimeLine& line, const QPointF& p) const
{
    const NiceTicks& axis = axisOf(line);
    const double part = (p.y() - axis.start()) / (axis.end() - axis.start());
    return {timeToView(p.x()), frame.plot.bottom() - frame.plot.height() * part};
}

bool hasPoints(const TimeChartContent& content)
{
    return std::any_of(content.lines.begin(), content.lines.end(), isShown);
}

int chartColumns(double width_px)
{
    return std::max(1, static_cast<int>(width_px) - static_cast<int>(2 * kChartSide_px));
}

bool isOneOfMany(const TimeLine& line)
{
    return line.role == LineRole::Sigma || line.role == LineRole::Uav;
}

TimeFigure timeFigure(const TimeChartContent& content, const TimeFigureStyle& style)
{
    TimeFigure figure;
    figure.window = style.window;
    figure.frame.size = style.size_px;
    figure.frame.title = style.hasTitle ? content.title : QString();
    figure.drawn = linesInView(content, style.window, chartColumns(style.size_px.width()));
    setValueAxes(figure, content);
    setPlot(figure, content, style);
    figure.timeStep_s =
        timeStep_s(style.window.length_s(),
                   std::max(1, static_cast<int>(figure.frame.plot.width() / kTimeSpacing_px)));
    simplifyLines(figure, content);
    fillTitles(figure.frame, content, style);
    fillTicks(figure, content, style.locale);
    fillMarks(figure, content);
    return figure;
}

} // namespace berg
