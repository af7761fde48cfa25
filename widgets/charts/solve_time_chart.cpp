#include "widgets/charts/solve_time_chart.h"

#include "widgets/charts/figure_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kShortest_s = 1e-6; // shorter times are drawn here
constexpr double kMarker_px = 3.4;

/** Translation context of free functions, which lupdate would otherwise omit. */
struct SolveTimeText
{
    Q_DECLARE_TR_FUNCTIONS(SolveTimeText)
};

/** Time with three digits in a suitable unit. */
QString timeText(double time_s, const QLocale& locale)
{
    if (time_s < 1e-3)
        return SolveTimeText::tr("%1 µs").arg(significantText(1e6 * time_s, 3, locale));
    if (time_s < 1)
        return SolveTimeText::tr("%1 ms").arg(significantText(1e3 * time_s, 3, locale));
    return SolveTimeText::tr("%1 s").arg(significantText(time_s, 3, locale));
}

/** Power of ten without redundant digits. */
QString powerText(double time_s, const QLocale& locale)
{
    const double power = std::round(std::log10(time_s));
    const double unit = power < -3 ? -6 : (power < 0 ? -3 : 0);
    const QString number = fixedText(std::pow(10.0, power - unit), 0, locale);
    if (unit < -3)
        return SolveTimeText::tr("%1 µs").arg(number);
    return unit < 0 ? SolveTimeText::tr("%1 ms").arg(number)
                    : SolveTimeText::tr("%1 s").arg(number);
}

Ink inkOf(const SolveTimeLine& line)
{
    const auto named =
        std::find_if(kBenchmarkSolverNames.begin(), kBenchmarkSolverNames.end(),
                     [&](const auto& solver) { return solver.value == line.solver; });
    const auto place = static_cast<double>(named - kBenchmarkSolverNames.begin());
    return {.of = InkOf::Solver, .value = line.solver ? place : -1};
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
        return theme.toned(theme.isDark ? 0xc792ea : 0x7b3fa0);
    case Formulation::Printed:
        return theme.comparison;
    case Formulation::Reduced:
        return theme.toned(theme.isDark ? 0x46c9a2 : 0x0b7a5b);
    }
    return {};
}

SolveTimeChart::SolveTimeChart(const Theme& theme, QWidget* parent)
    : FigureView(theme, parent), m_lines(paperLine())
{
    setTitleShown(true);
}

void SolveTimeChart::setRows(const std::vector<BenchmarkRow>& rows)
{
    m_lines = solveTimeLines(rows);
    refresh();
}

Figure SolveTimeChart::figure() const
{
    Figure figure{.name = utf8(tr("Solution time against the number of icebergs")),
                  .title = utf8(tr("Solution time"))};
    figure.leftTitles = {utf8(tr("Time for one plan, logarithmic"))};
    figure.rightTitles = {utf8(tr("Line: median. Dashed: worst. Hollow: some were cut short.")),
                          {}};
    figure.x = {.ends = AxisEnds::Exact,
                .largest = 0,
                .spacing_px = 56,
                .text = numberText(locale()),
                .title = utf8(tr("Number of icebergs")),
                .isWhole = true};
    figure.y = {.ends = AxisEnds::Powers,
                .least = 1,
                .spacing_px = 24,
                .text = [locale = locale()](double time_s, int /*decimals*/) {
                    return utf8(powerText(time_s, locale));
                }};
    for (const SolveTimeLine& line : m_lines)
        addLine(figure, line);
    return figure;
}

void SolveTimeChart::addLine(Figure& figure, const SolveTimeLine& line) const
{
    const Ink ink = inkOf(line);
    PlotLine middle{.points = {}, .ink = ink, .width_px = 2};
    PlotLine worst{.points = {}, .ink = ink, .width_px = 1.2, .dash_px = {4.8, 3.6}};
    for (const SolveTimePoint& point : line.points) {
        const auto icebergs = static_cast<double>(point.icebergs);
        const PlotPoint at{icebergs, point.middle_s};
        middle.points.push_back(at);
        worst.points.push_back({icebergs, point.worst_s});
        figure.marks.push_back({.at = at,
                                .radius_px = point.complete ? kMarker_px + 0.6 : kMarker_px,
                                .ink = ink,
                                .isHollow = !point.complete});
        figure.items.push_back(
            {.id = figure.items.size(), .at = at, .readout = readout(line, point)});
        figure.x.largest = std::max(figure.x.largest, icebergs);
        figure.y.least = std::min(figure.y.least, std::max(point.middle_s, kShortest_s));
        figure.y.largest = std::max(figure.y.largest, point.worst_s);
    }
    const auto name = [&](const QString& text, const PlotLine& of) {
        figure.labels.push_back(
            {.text = utf8(text), .end = of.points.back(), .ink = ink, .place = LabelPlace::Free});
    };
    name(lineName(line), middle);
    if (!line.solver)
        name(tr("CPLEX, worst (paper)"), worst);
    figure.lines.push_back(std::move(worst));
    figure.lines.push_back(std::move(middle));
}

std::vector<std::string> SolveTimeChart::readout(const SolveTimeLine& line,
                                                 const SolveTimePoint& point) const
{
    QStringList lines{
        tr("%1, %n icebergs", nullptr, point.icebergs).arg(lineName(line)),
        (line.solver ? tr("median %1, worst %2") : tr("average %1, worst %2"))
            .arg(timeText(point.middle_s, locale()), timeText(point.worst_s, locale()))};
    if (point.instances)
        lines << tr("proven: %1 of %2").arg(point.proven).arg(*point.instances);
    return utf8(lines);
}

} // namespace berg
