#pragma once

#include "widgets/charts/figure_view.h"
#include "widgets/model/run_list.h"

namespace berg {

/**
 * Zeta of two runs over time, as Figure 5 of the paper: the reference in the colour of zeta, the
 * other one in that of comparisons, named where they end; between them the difference is shaded,
 * plain where the reference has less and hatched where the other one has. Less is better.
 */
class ComparisonChart : public FigureView
{
    Q_OBJECT

public:
    explicit ComparisonChart(const Theme& theme, QWidget* parent = nullptr);

    /** None: says how to get two runs. */
    void setComparison(const std::optional<RunComparison>& comparison);
    /** The instant shown on the map; none: no cursor. */
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

/** "Tour has 8.0 % more than τ 1.00": the other run beside the reference at the common time. */
[[nodiscard]] QString verdictText(const RunComparison& comparison, const QLocale& locale);

} // namespace berg
