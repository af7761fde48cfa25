#pragma once

#include "widgets/charts/figure_view.h"
#include "widgets/study/run_list.h"

namespace berg {

/**
 * Zeta of two runs over time, as in Figure 5 of the paper: the reference in the colour of zeta, the
 * other run in that of comparisons, named at their ends. The difference is shaded: plain where the
 * reference has less, hatched where the other run has less. Less is better.
 */
class ComparisonChart : public FigureView
{
    Q_OBJECT

public:
    explicit ComparisonChart(const Theme& theme, QWidget* parent = nullptr);

    /** Shows a comparison; nullopt shows a hint instead. */
    void setComparison(const std::optional<RunComparison>& comparison);
    /** Sets the cursor to the time shown on the map; nullopt removes it. */
    void setCursor_s(std::optional<double> time_s);

    [[nodiscard]] QSize minimumSizeHint() const override { return {200, 130}; }

protected:
    [[nodiscard]] Figure figure() const override;

private:
    void addRun(Figure& figure, const ComparedRun& run, const QList<QPointF>& line,
                InkOf ink) const;

    std::optional<RunComparison> m_comparison;
    std::optional<double> m_cursor_s;
};

/** "Tour has 8.0 % more than τ 1.00": compares the runs at their common end. */
[[nodiscard]] QString verdictText(const RunComparison& comparison, const QLocale& locale);

} // namespace berg
