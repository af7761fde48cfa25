#include "widgets/charts/solve_time_chart.h"

#include "core/base/nice_ticks.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kShortest_s = 1e-6; ///< what is shorter is drawn there
constexpr double kTickSpacing_px = 24;
constexpr double kSizeSpacing_px = 56;
constexpr double kMarker_px = 3.4;
constexpr double kLabelGap_px = 10; ///< between the end of a line and its label
constexpr double kLabelHeight_px = 14;
constexpr int kLabelPlaces = 24; ///< tried for each label
constexpr double kReach_px = 12; ///< of the pointer round a marker

/** Context of the texts of free functions, which lupdate would leave out. */
struct SolveTimeText
{
    Q_DECLARE_TR_FUNCTIONS(SolveTimeText)
};

/** Three digits, in the unit that suits. */
QString timeText(double time_s, const QLocale& locale)
{
    if (time_s < 1e-3)
        return SolveTimeText::tr("%1 µs").arg(significantText(1e6 * time_s, 3, locale));
    if (time_s < 1)
        return SolveTimeText::tr("%1 ms").arg(significantText(1e3 * time_s, 3, locale));
    return SolveTimeText::tr("%1 s").arg(significantText(time_s, 3, locale));
}

/** A power of ten, without digits that say nothing. */
QString powerText(double power, const QLocale& locale)
{
    const double unit = power < -3 ? -6 : (power < 0 ? -3 : 0);
    const QString number = fixedText(std::pow(10.0, power - unit), 0, locale);
    if (unit < -3)
        return SolveTimeText::tr("%1 µs").arg(number);
    return unit < 0 ? SolveTimeText::tr("%1 ms").arg(number)
                    : SolveTimeText::tr("%1 s").arg(number);
}

/** Whether a line, of ascending abscissas, runs through a rectangle. */
bool crosses(const QPolygonF& line, const QRectF& rect)
{
    for (qsizetype k = 0; k + 1 < line.size(); ++k) {
        const QPointF& a = line[k];
        const QPointF& b = line[k + 1];
        if (b.x() <= rect.left() || a.x() >= rect.right() || b.x() <= a.x())
            continue;
        const auto at = [&](double x) {
            return a.y() + (b.y() - a.y()) * (x - a.x()) / (b.x() - a.x());
        };
        const double y1 = at(std::max(a.x(), rect.left()));
        const double y2 = at(std::min(b.x(), rect.right()));
        if (std::max(y1, y2) > rect.top() && std::min(y1, y2) < rect.bottom())
            return true;
    }
    return false;
}

QString lineName(const SolveTimeLine& line)
{
    return line.solver ? benchmarkSolverName(*line.solver)
                       : SolveTimeText::tr("CPLEX, average (paper)");
}

std::vector<SolveTimeLine> paperLine()
{
    SolveTimeLine paper;
    for (const PaperTime& time : paperTable2())
        paper.points.push_back(
            {.icebergs = time.icebergs, .middle_s = time.average_s, .worst_s = time.worst_s});
    return {paper};
}

} // namespace

std::vector<SolveTimeLine> solveTimeLines(const std::vector<BenchmarkRow>& rows)
{
    std::vector<SolveTimeLine> lines = paperLine();
    for (const BenchmarkRow& row : rows) {
        if (row.seconds.n == 0)
            continue;
        auto line = std::find_if(lines.begin(), lines.end(), [&row](const SolveTimeLine& known) {
            return known.solver == row.solver;
        });
        if (line == lines.end())
            line = lines.insert(lines.end(), {.solver = row.solver, .points = {}});
        line->points.push_back({.icebergs = row.icebergs,
                                .middle_s = row.seconds.median,
                                .worst_s = row.worst_s,
                                .instances = row.instances,
                                .proven = row.proven,
                                .complete = row.cut == 0});
    }
    return lines;
}

QString benchmarkSolverName(const BenchmarkSolver& solver)
{
    switch (solver.backend) {
    case Backend::Auto:
        return SolveTimeText::tr("Automatic");
    case Backend::Exact:
        return SolveTimeText::tr("Exact");
    case Backend::Heuristic:
        return SolveTimeText::tr("Local search");
    case Backend::Cbc:
        break;
    }
    switch (solver.formulation) {
    case Formulation::Position:
        return SolveTimeText::tr("CBC, by position");
    case Formulation::Printed:
        return SolveTimeText::tr("CBC, as printed");
    case Formulation::Reduced:
        return SolveTimeText::tr("CBC, reduced");
    }
    return {};
}

QColor benchmarkSolverColour(const std::optional<BenchmarkSolver>& solver, const Theme& theme)
{
    if (!solver)
        return theme.chartAxis;
    switch (solver->backend) {
    case Backend::Auto:
        return theme.text;
    case Backend::Exact:
        return theme.plan;
    case Backend::Heuristic:
        return theme.uav;
    case Backend::Cbc:
        break;
    }
    switch (solver->formulation) {
    case Formulation::Position:
        return theme.isDark ? QColor(0xc792ea) : QColor(0x7b3fa0);
    case Formulation::Printed:
        return theme.comparison;
    case Formulation::Reduced:
        return theme.isDark ? QColor(0x46c9a2) : QColor(0x0b7a5b);
    }
    return {};
}

SolveTimeChart::SolveTimeChart(const Theme& theme, QWidget* parent)
    : QWidget(parent), m_theme(theme), m_lines(paperLine())
{
    setAccessibleName(tr("Solution time against the number of icebergs"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    layOut();
}

void SolveTimeChart::setRows(const std::vector<BenchmarkRow>& rows)
{
    m_lines = solveTimeLines(rows);
    layOut();
    update();
}

void SolveTimeChart::setTheme(const Theme& theme)
{
    m_theme = theme;
    layOut();
    update();
}

QSize SolveTimeChart::sizeHint() const
{
    return {760, 420};
}

QSize SolveTimeChart::minimumSizeHint() const
{
    return {280, 200};
}

void SolveTimeChart::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    layOut();
}

void SolveTimeChart::layOut()
{
    setRange();
    m_frame.size = size();
    m_frame.title = tr("Solution time");
    m_frame.leftTitle = tr("Time for one plan, logarithmic");
    m_frame.rightTitle = tr("Line: median. Dashed: worst. Hollow: some were cut short.");
    m_frame.timeTitle = tr("Number of icebergs");
    m_frame.leftColour = m_theme.mutedText;
    m_frame.rightColour = m_theme.mutedText;
    const QFontMetricsF small(m_theme.small());
    if (small.horizontalAdvance(m_frame.leftTitle + m_frame.rightTitle) + 60 > width())
        m_frame.rightTitle.clear();

    double labels_px = 0;
    for (const SolveTimeLine& line : m_lines)
        labels_px = std::max(labels_px, small.horizontalAdvance(lineName(line)));
    const double left_px = kChartSide_px + small.horizontalAdvance(u"10 000 s"_s);
    const double right_px =
        std::max(left_px + 60, width() - kChartSide_px - labels_px - kLabelGap_px);
    m_frame.plot = QRectF(left_px, chartTop(m_frame), right_px - left_px,
                          std::max(40.0, height() - chartTop(m_frame) - kChartBottom_px));
    setTicks();
    placeLabels();
}

void SolveTimeChart::setRange()
{
    double shortest_s = 1;
    double longest_s = 1;
    m_mostIcebergs = 0;
    for (const SolveTimeLine& line : m_lines)
        for (const SolveTimePoint& point : line.points) {
            shortest_s = std::min(shortest_s, std::max(point.middle_s, kShortest_s));
            longest_s = std::max(longest_s, point.worst_s);
            m_mostIcebergs = std::max(m_mostIcebergs, static_cast<double>(point.icebergs));
        }
    constexpr double kHeadroom = 0.15; // of a power of ten
    m_lowest = std::floor(std::log10(shortest_s) + 1e-9);
    m_highest = std::log10(longest_s) + kHeadroom;
}

void SolveTimeChart::setTicks()
{
    m_frame.left.clear();
    const double powers = m_highest - m_lowest;
    const int step =
        std::max(1, static_cast<int>(std::ceil(powers * kTickSpacing_px / m_frame.plot.height())));
    for (double power = m_lowest; power <= m_highest; power += step) {
        m_frame.left.push_back(
            {.at_px = toView(0, std::pow(10.0, power)).y(), .text = powerText(power, locale())});
    }
    m_frame.times.clear();
    const NiceTicks sizes = niceTicks(
        m_mostIcebergs, std::max(1, static_cast<int>(m_frame.plot.width() / kSizeSpacing_px)));
    // Steps are 1, 2, 2.5 or 5 times a power of ten; icebergs are whole.
    const double wholeStep = std::max(1.0, sizes.decimals() > 0 ? 2 * sizes.step : sizes.step);
    for (double icebergs = 0; icebergs <= m_mostIcebergs; icebergs += wholeStep)
        m_frame.times.push_back(
            {.at_px = toView(icebergs, 1).x(), .text = fixedText(icebergs, 0, locale())});
}

QPointF SolveTimeChart::toView(double icebergs, double time_s) const
{
    const QRectF& plot = m_frame.plot;
    const double power = std::log10(std::max(time_s, kShortest_s));
    return {plot.left() + plot.width() * icebergs / m_mostIcebergs,
            plot.bottom() - plot.height() * (power - m_lowest) / (m_highest - m_lowest)};
}

QPolygonF SolveTimeChart::polygon(const SolveTimeLine& line, bool worst) const
{
    QPolygonF polygon;
    for (const SolveTimePoint& point : line.points)
        polygon << toView(point.icebergs, worst ? point.worst_s : point.middle_s);
    return polygon;
}

void SolveTimeChart::placeLabels()
{
    m_frame.labels.clear();
    std::vector<QPolygonF> lines;
    for (const SolveTimeLine& line : m_lines)
        for (const bool worst : {false, true})
            lines.push_back(polygon(line, worst));
    for (const SolveTimeLine& line : m_lines) {
        ChartLabel label{.text = lineName(line),
                         .end = polygon(line, false).back(),
                         .colour = benchmarkSolverColour(line.solver, m_theme)};
        placeLabel(label, lines);
        if (line.solver)
            continue;
        label.text = tr("CPLEX, worst (paper)");
        label.end = polygon(line, true).back();
        placeLabel(label, lines);
    }
}

/**
 * Right of the end of its line, moved up or down where another label or line is; else above the
 * end; else across lines. Not shown where other labels leave no room.
 */
void SolveTimeChart::placeLabel(ChartLabel label, std::span<const QPolygonF> lines)
{
    const QRectF room(0, m_frame.plot.top() - kLabelHeight_px, width(),
                      m_frame.plot.height() + kLabelHeight_px);
    const auto place = [&](bool acrossLines) {
        const auto taken = [&](const ChartLabel& other) {
            return other.rect.intersects(label.rect);
        };
        const auto crossed = [&](const QPolygonF& line) { return crosses(line, label.rect); };
        if (!room.contains(label.rect) ||
            std::any_of(m_frame.labels.begin(), m_frame.labels.end(), taken) ||
            (!acrossLines && std::any_of(lines.begin(), lines.end(), crossed)))
            return false;
        m_frame.labels.push_back(label);
        return true;
    };
    const auto placeRight = [&](bool acrossLines) {
        const double width_px = QFontMetricsF(m_theme.small()).horizontalAdvance(label.text) + 2;
        label.inMargin = true;
        for (int k = 0; k < kLabelPlaces; ++k) {
            // 0, 1 up, 1 down, 2 up, ... halves of a line
            const double shift_px = 0.5 * kLabelHeight_px * ((k + 1) / 2) * (k % 2 == 0 ? 1 : -1);
            label.rect =
                QRectF(label.end.x() + kLabelGap_px, label.end.y() + shift_px - kLabelHeight_px / 2,
                       width_px, kLabelHeight_px);
            if (place(acrossLines))
                return true;
        }
        return false;
    };
    const auto placeAbove = [&] {
        const double width_px = QFontMetricsF(m_theme.strong()).horizontalAdvance(label.text) + 2;
        const double left_px = std::max(m_frame.plot.left() + 4, label.end.x() - width_px / 2);
        label.inMargin = false;
        for (int k = 1; k <= kLabelPlaces; ++k) {
            const double top_px = label.end.y() - kLabelGap_px - 0.5 * kLabelHeight_px * (k + 2);
            label.rect = QRectF(left_px, top_px, width_px, kLabelHeight_px + 2);
            if (place(false))
                return true;
        }
        return false;
    };
    if (!placeRight(false) && !placeAbove())
        placeRight(true);
}

void SolveTimeChart::paintLine(QPainter& painter, const SolveTimeLine& line) const
{
    const QColor colour = benchmarkSolverColour(line.solver, m_theme);
    painter.setBrush(Qt::NoBrush);
    QPen dashed(colour, 1.2, Qt::CustomDashLine, Qt::FlatCap, Qt::RoundJoin);
    dashed.setDashPattern({4, 3});
    painter.setPen(dashed);
    painter.drawPolyline(polygon(line, true));
    const QPolygonF middle = polygon(line, false);
    painter.setPen(QPen(colour, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(middle);
    for (qsizetype k = 0; k < middle.size(); ++k) {
        const bool complete = line.points[static_cast<std::size_t>(k)].complete;
        painter.setPen(QPen(complete ? m_theme.chart : colour, complete ? 1.2 : 1.6));
        painter.setBrush(complete ? colour : m_theme.chart);
        const double radius_px = complete ? kMarker_px + 0.6 : kMarker_px;
        painter.drawEllipse(middle[k], radius_px, radius_px);
    }
}

void SolveTimeChart::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), m_theme.chart);
    const QRectF& plot = m_frame.plot;
    painter.setPen(QPen(m_theme.chartGrid, 1));
    for (const ChartTick& tick : m_frame.left)
        painter.drawLine(QPointF(plot.left(), tick.at_px), QPointF(plot.right(), tick.at_px));
    for (const ChartTick& tick : m_frame.times)
        painter.drawLine(QPointF(tick.at_px, plot.top()), QPointF(tick.at_px, plot.bottom()));
    painter.setRenderHint(QPainter::Antialiasing);
    for (const SolveTimeLine& line : m_lines)
        paintLine(painter, line);
    paintChartFrame(painter, m_frame, m_theme);
}

bool SolveTimeChart::event(QEvent* event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const QString text = pointText(help->pos());
    if (text.isEmpty())
        QToolTip::hideText();
    else
        QToolTip::showText(help->globalPos(), text, this);
    return true;
}

QString SolveTimeChart::pointText(const QPointF& at) const
{
    for (const SolveTimeLine& line : m_lines)
        for (const SolveTimePoint& point : line.points) {
            const QPointF away = toView(point.icebergs, point.middle_s) - at;
            if (std::hypot(away.x(), away.y()) > kReach_px)
                continue;
            QString text =
                tr("%1, %n icebergs", nullptr, point.icebergs).arg(lineName(line)) + u'\n' +
                (line.solver ? tr("median %1, worst %2") : tr("average %1, worst %2"))
                    .arg(timeText(point.middle_s, locale()), timeText(point.worst_s, locale()));
            if (line.solver)
                text += u'\n' + tr("proven: %1 of %2").arg(point.proven).arg(point.instances);
            return text;
        }
    return {};
}

} // namespace berg
