#pragma once

#include "core/study/benchmark.h"
#include "widgets/charts/figure_view.h"

#include <optional>
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
class SolveTimeChart : public FigureView
{
    Q_OBJECT

public:
    explicit SolveTimeChart(const Theme& theme, QWidget* parent = nullptr);

    void setRows(const std::vector<BenchmarkRow>& rows);

    [[nodiscard]] QSize sizeHint() const override { return {760, 420}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {280, 200}; }

protected:
    [[nodiscard]] Figure figure() const override;

private:
    void addLine(Figure& figure, const SolveTimeLine& line) const;
    [[nodiscard]] std::vector<std::string> readout(const SolveTimeLine& line,
                                                   const SolveTimePoint& point) const;

    std::vector<SolveTimeLine> m_lines;
};

} // namespace berg
