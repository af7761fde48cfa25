#pragma once

#include "core/study/benchmark.h"
#include "widgets/charts/chart_frame.h"
#include "widgets/theme/theme.h"

#include <QWidget>

#include <optional>
#include <span>
#include <vector>

namespace berg {

/** Times of one size, seconds. */
struct SolveTimePoint
{
    int icebergs = 0;
    double middle_s = 0; ///< median; the paper's are averages
    double worst_s = 0;
    int instances = 0; ///< 0: unknown (the paper)
    int proven = 0;
    bool complete = true; ///< none was cut by the budget
};

/** One contestant; without a `solver` the paper's CPLEX. */
struct SolveTimeLine
{
    std::optional<BenchmarkSolver> solver;
    std::vector<SolveTimePoint> points; ///< ascending sizes
};

/** The paper's times first, then a line for each solver that has times, in order of appearance. */
[[nodiscard]] std::vector<SolveTimeLine> solveTimeLines(const std::vector<BenchmarkRow>& rows);

/** Name of a contestant in the user's words. */
[[nodiscard]] QString benchmarkSolverName(const BenchmarkSolver& solver);
/** Colour of its line; of the paper's without a solver. At least 3 : 1 on the chart. */
[[nodiscard]] QColor benchmarkSolverColour(const std::optional<BenchmarkSolver>& solver,
                                           const Theme& theme);

/**
 * Solution time against the number of icebergs on a logarithmic axis, as Figure 3 of the paper:
 * the median of each solver with a marker at each size, hollow where the budget cut some, the worst
 * dashed; average and worst of the paper's CPLEX in grey. Lines are labelled where they end.
 */
class SolveTimeChart : public QWidget
{
    Q_OBJECT

public:
    explicit SolveTimeChart(const Theme& theme, QWidget* parent = nullptr);

    void setRows(const std::vector<BenchmarkRow>& rows);
    void setTheme(const Theme& theme);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

    /** Place of a time in the widget, pixels. */
    [[nodiscard]] QPointF toView(double icebergs, double time_s) const;
    /** What the marker at a place stands for, for its tooltip; empty where there is none. */
    [[nodiscard]] QString pointText(const QPointF& at) const;
    /** Direct labels as shown, for tests. */
    [[nodiscard]] const std::vector<ChartLabel>& labels() const { return m_frame.labels; }
    /** Numbers at the time axis, for tests. */
    [[nodiscard]] const std::vector<ChartTick>& timeTicks() const { return m_frame.left; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

private:
    void layOut();
    void setRange();
    void setTicks();
    void placeLabels();
    void placeLabel(ChartLabel label, std::span<const QPolygonF> lines);
    void paintLine(QPainter& painter, const SolveTimeLine& line) const;
    [[nodiscard]] QPolygonF polygon(const SolveTimeLine& line, bool worst) const;

    Theme m_theme;
    std::vector<SolveTimeLine> m_lines;
    double m_mostIcebergs = 20;
    double m_lowest = -6; ///< powers of ten of a second at the ends of the axis
    double m_highest = 5;
    ChartFrame m_frame;
};

} // namespace berg
