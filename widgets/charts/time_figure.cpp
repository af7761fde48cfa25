#include "widgets/charts/time_figure.h"

#include "widgets/charts/decimate.h"
#include "widgets/charts/figure_painter.h"
#include "widgets/charts/figure_text.h"
#include "widgets/charts/line_style.h"
#include "widgets/charts/weather_marks.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kSimplify_px = 0.1;
constexpr double kReferenceGap_px = 6; // distance of its name from the plot's end
constexpr double kReferenceUp_px = 9;  // distance of its name's middle above the line

/** Translation context; lupdate would omit the namespace of the class's own context. */
struct TimeChartText
{
    Q_DECLARE_TR_FUNCTIONS(TimeChartText)
};

bool hasRightAxis(const TimeChartContent& content)
{
    if (content.rightTitle.isEmpty() || content.lines.empty())
        return !content.rightTitle.isEmpty();
    return std::any_of(content.lines.begin(), content.lines.end(),
                       [](const TimeLine& line) { return line.onRightAxis && line.isShown(); });
}

/** Cuts lines at the edges of the view, because SVG, for one, does not clip. */
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

/** Returns whether the line is named in the margin and has a colour other than the axis. */
bool isOneOfMany(const TimeLine& line)
{
    return line.role == LineRole::Sigma || line.role == LineRole::Uav;
}

PlotAxis valueAxis(const TimeFigure& time, const TimeChartContent& content, const QLocale& locale,
                   bool onRightAxis)
{
    PlotAxis axis{.ends = AxisEnds::Around0,
                  .largest = 0,
                  .spacing_px = 52,
                  .fewSpacing_px = 30,
                  .text = numberText(locale)};
    const auto include = [&axis](double value) {
        axis.least = std::min(axis.least, value);
        axis.largest = std::max(axis.largest, value);
    };
    for (std::size_t i = 0; i < time.drawn.size(); ++i)
        if (content.lines[i].onRightAxis == onRightAxis)
            for (const QPointF& p : time.drawn[i])
                include(p.y());
    if (!onRightAxis && hasPoints(content))
        for (const ReferenceLine& reference : content.references)
            include(reference.value);
    return axis;
}

void addAxes(TimeFigure& time, const TimeChartContent& content, const TimeFigureStyle& style)
{
    Figure& figure = time.figure;
    figure.x = timeAxis(content.clock, style.window.from_s, style.window.to_s,
                        TimeChartText::tr("Time, UTC"),
                        style.window.to_s >= 3600 ? TimeChartText::tr("Time, h:mm:ss")
                                                  : TimeChartText::tr("Time, mm:ss"));
    figure.y = valueAxis(time, content, style.locale, false);
    figure.leftTitles = {utf8(content.leftTitle)};
    if (hasRightAxis(content)) {
        figure.right = valueAxis(time, content, style.locale, true);
        const bool isZeta = content.rightTitle.contains(u"%1"_s);
        const ShownUnit unit = isZeta ? zetaUnit(figure.right->largest) : ShownUnit();
        figure.right->inUnit = unit.inSi;
        figure.rightTitles = {
            utf8(isZeta ? content.rightTitle.arg(unit.name) : content.rightTitle)};
    }
    const auto inkOf = [&](bool onRightAxis) {
        for (const TimeLine& line : content.lines)
            if (line.onRightAxis == onRightAxis && !isOneOfMany(line) && !line.hidden)
                return lineInk(line, content.sigmaFull_m2);
        return Ink{.of = InkOf::Muted};
    };
    figure.leftInk = inkOf(false);
    figure.rightInk = inkOf(true);
}

/** Long ramps become one segment. */
void simplifyLines(TimeFigure& time, const TimeChartContent& content, double height_px)
{
    for (std::size_t i = 0; i < time.drawn.size(); ++i) {
        const PlotAxis& axis =
            content.lines[i].onRightAxis && time.figure.right ? *time.figure.right : time.figure.y;
        const double unit = (axis.largest - axis.least) / std::max(10.0, height_px);
        time.drawn[i] = simplified(time.drawn[i], kSimplify_px * unit);
    }
}

void addLine(Figure& figure, const TimeLine& line, const QList<QPointF>& drawn, double sigmaFull_m2,
             bool crowded)
{
    PlotLine out{.points = {},
                 .ink = lineInk(line, sigmaFull_m2),
                 .width_px = lineWidth_px(line, crowded),
                 .onRightAxis = line.onRightAxis,
                 .key = utf8(line.key)};
    if (isDashed(line.role))
        out.dash_px = {4 * out.width_px, 2 * out.width_px};
    if (crowded && line.role == LineRole::Sigma)
        out.ink.strength = kFaintInk;
    for (const QPointF& p : drawn)
        out.points.push_back({p.x(), p.y()});
    if (line.role == LineRole::Momentary && !drawn.isEmpty()) {
        PlotArea area{.outline = out.points, .ink = out.ink, .opacity = kAreaInk};
        area.outline.push_back({drawn.back().x(), 0});
        area.outline.push_back({drawn.front().x(), 0});
        figure.areas.push_back(std::move(area));
    }
    figure.lines.push_back(std::move(out));
}

/** Last visible point of a polyline; nullopt if it ends before the view. */
std::optional<QPointF> endOf(const QList<QPointF>& points, const TimeWindow& view)
{
    if (points.empty() || points.back().x() > view.to_s)
        return pointAt(points, view.to_s);
    return points.back().x() < view.from_s ? std::nullopt : std::optional(points.back());
}

void addNames(TimeFigure& time, const TimeChartContent& content)
{
    const bool areMany = std::any_of(content.lines.begin(), content.lines.end(), isOneOfMany);
    std::vector<std::optional<QPointF>> ends;
    for (const QList<QPointF>& points : time.drawn)
        ends.push_back(endOf(points, time.window));
    std::vector<std::size_t> order =
        byImportance(content, ends); // important names first if lines crowd
    if (!areMany)
        std::sort(order.begin(), order.end());
    for (const std::size_t i : order) {
        const TimeLine& line = content.lines[i];
        if (line.isContinued)
            continue;
        time.figure.labels.push_back({.text = utf8(line.label),
                                      .shortText = utf8(line.name.value_or(QString())),
                                      .end = {ends[i]->x(), ends[i]->y()},
                                      .ink = lineInk(line, content.sigmaFull_m2),
                                      .place = areMany ? LabelPlace::AtEnd : LabelPlace::Inside,
                                      .onRightAxis = line.onRightAxis,
                                      .isStrong = line.emphasis == LineEmphasis::Strong,
                                      .isQuiet = line.role == LineRole::Bound,
                                      .needsMargin = areMany,
                                      .line = i,
                                      .key = utf8(line.key)});
    }
}

/** Adds visits at the bottom, limits across, and the cursor. */
void addMarks(TimeFigure& time, const TimeChartContent& content)
{
    const auto inView = [&time](double time_s) {
        return time_s >= time.window.from_s && time_s <= time.window.to_s;
    };
    Figure& figure = time.figure;
    const auto over = [&figure](const PlotPoint& from, const PlotPoint& to, double width_px) {
        figure.lines.push_back({.points = {from, to},
                                .ink = {.of = InkOf::Uav},
                                .width_px = width_px,
                                .isOver = true});
    };
    for (const double time_s : content.marks_s)
        if (inView(time_s))
            over({time_s, -kPlotEdge, 0, -kFootMark_px}, {time_s, -kPlotEdge}, 1.6);
    if (!figure.lines.empty() && figure.lines.back().isOver)
        figure.markKey = utf8(content.marksTitle);
    for (const ReferenceLine& reference : content.references) {
        over({-kPlotEdge, reference.value}, {kPlotEdge, reference.value}, 1);
        figure.lines.back().ink = {.of = InkOf::Muted};
        figure.lines.back().dash_px = {4, 2};
        figure.labels.push_back(
            {.text = utf8(reference.label),
             .end = {kPlotEdge, reference.value, -kReferenceGap_px, -kReferenceUp_px},
             .ink = {.of = InkOf::Muted},
             .place = LabelPlace::Left,
             .needsMargin = false});
        if (reference.label.isEmpty())
            figure.labels.pop_back();
    }
    if (content.cursor_s && inView(*content.cursor_s))
        over({*content.cursor_s, -kPlotEdge}, {*content.cursor_s, kPlotEdge}, 1.2);
}

qsizetype segmentsOf(const std::vector<QList<QPointF>>& drawn)
{
    qsizetype segments = 0;
    for (const QList<QPointF>& points : drawn)
        segments += points.size();
    return segments;
}

} // namespace

double TimeFigure::viewToTime(double x_px) const
{
    const double part = (x_px - drawing.plot.left) / drawing.plot.width();
    return window.from_s + std::clamp(part, 0.0, 1.0) * window.length_s();
}

bool hasPoints(const TimeChartContent& content)
{
    return std::ranges::any_of(content.lines, &TimeLine::isShown);
}

int chartColumns(double width_px)
{
    return std::max(1, static_cast<int>(width_px) - static_cast<int>(2 * kFigureSide_px));
}

std::vector<std::size_t> byImportance(const TimeChartContent& content,
                                      const std::vector<std::optional<QPointF>>& points)
{
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i])
            order.push_back(i);
    const auto isStrong = [&content](std::size_t i) {
        return content.lines[i].emphasis == LineEmphasis::Strong;
    };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return isStrong(a) != isStrong(b) ? isStrong(a) : points[a]->y() > points[b]->y();
    });
    return order;
}

TimeFigure timeFigure(const TimeChartContent& content, const TimeFigureStyle& style)
{
    TimeFigure time{.window = style.window};
    time.figure.title = style.hasTitle ? utf8(content.title) : std::string();
    time.figure.leastLeft_px = style.leastLeft_px;
    time.figure.leastRight_px = style.leastRight_px;
    time.drawn = linesInView(content, style.window, chartColumns(style.size_px.width()));
    addAxes(time, content, style);
    simplifyLines(time, content, style.size_px.height() - kFigureTop_px - kFigureBottom_px);
    const bool crowded = isCrowded(segmentsOf(time.drawn));
    const bool areMany = std::any_of(content.lines.begin(), content.lines.end(), isOneOfMany);
    if (style.hasLines || !areMany)
        for (std::size_t i = 0; i < time.drawn.size(); ++i)
            addLine(time.figure, content.lines[i], time.drawn[i], content.sigmaFull_m2, crowded);
    if (hasPoints(content)) {
        if (style.hasNames)
            addNames(time, content);
        addMarks(time, content);
        addWeatherMarks(time, content, style.size_px);
    } else {
        time.figure.emptyText = utf8(content.emptyText);
    }
    time.drawing = layOutPlot(time.figure, {style.size_px.width(), style.size_px.height()},
                              figureFonts(style.theme));
    return time;
}

} // namespace berg
