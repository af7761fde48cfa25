#pragma once

#include "widgets/charts/chart_frame.h"
#include "widgets/model/run_list.h"

#include <QWidget>

#include <optional>

namespace berg {

/**
 * Zeta of two runs over time, as Figure 5 of the paper: the reference in the colour of zeta, the
 * other one in that of comparisons, named where they end; between them the difference is shaded,
 * plain where the reference has less and hatched where the other one has. Less is better.
 */
class ComparisonChart : public QWidget
{
    Q_OBJECT

public:
    explicit ComparisonChart(const Theme& theme, QWidget* parent = nullptr);

    /** None: says how to get two runs. */
    void setComparison(const std::optional<RunComparison>& comparison);
    void setTheme(const Theme& theme);
    /** Without it the plot has its room: for a chart inside something that has a title. */
    void setTitleShown(bool shown);
    /** The instant shown on the map; none: no cursor. */
    void setCursor_s(std::optional<double> time_s);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

    /** Place of a value in the widget, pixels. */
    [[nodiscard]] QPointF toView(double time_s, double zeta_m2s) const;
    /** Direct labels as shown, for tests. */
    [[nodiscard]] const std::vector<ChartLabel>& labels() const { return m_frame.labels; }
    /** Who is ahead, in words, as shown; empty: nothing is compared. */
    [[nodiscard]] const QString& verdict() const { return m_frame.rightTitle; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void layOut();
    void setAxes();
    void placeLabels();
    void setVerdict();
    [[nodiscard]] ChartLabel labelInPlot(const ComparedRun& run, const ComparedRun& beside) const;
    [[nodiscard]] bool endsAtMargin(const ComparedRun& run) const;
    void paintDifference(QPainter& painter) const;
    [[nodiscard]] QPolygonF polygon(const ComparedRun& run) const;

    Theme m_theme;
    std::optional<RunComparison> m_comparison;
    bool m_titleShown = true;
    std::optional<double> m_cursor_s;
    double m_duration_s = 1; ///< ends of the axes
    double m_zetaEnd_m2s = 1;
    ChartFrame m_frame;
};

/** "Tour has 8.0 % more than τ 1.00": the other run beside the reference at the common time. */
[[nodiscard]] QString verdictText(const RunComparison& comparison, const QLocale& locale);

} // namespace berg
