#pragma once

#include "core/study/benchmark.h"
#include "widgets/charts/figure_view.h"

#include <optional>
#include <vector>

namespace berg {

/** Solution times for one number of icebergs, seconds. */
struct SolveTimePoint
{
    int icebergs = 0;
    double middle_s = 0; ///< median; the paper's values are averages
    double worst_s = 0;
    std::optional<int> instances{}; ///< nullopt for the paper, which does not state it
    int proven = 0;
    bool complete = true; ///< no run was stopped by the time budget
};

/** Line of one solver; without a `solver` it is the paper's CPLEX. */
struct SolveTimeLine
{
    std::optional<BenchmarkSolver> solver;
    std::vector<SolveTimePoint> points; ///< ascending sizes
};

/** The paper's times first, then a line per solver with times, in order of appearance. */
[[nodiscard]] std::vector<SolveTimeLine> solveTimeLines(const std::vector<BenchmarkRow>& rows);

/** Translated name of a solver. */
[[nodiscard]] QString benchmarkSolverName(const BenchmarkSolver& solver);
/** Colour of a solver's line, without a solver that of the paper; contrast at least 3 : 1. */
[[nodiscard]] QColor benchmarkSolverColour(const std::optional<BenchmarkSolver>& solver,
                                           const Theme& theme);

/**
 * Solution time against the number of icebergs on a logarithmic axis, as in Figure 3 of the paper:
 * the median of each solver with a marker per size, hollow if the budget stopped a run, the worst
 * time dashed; average and worst of the paper's CPLEX in grey. Lines are labelled at their ends.
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
