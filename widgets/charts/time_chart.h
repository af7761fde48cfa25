#pragma once

#include "widgets/charts/chart_frame.h"
#include "widgets/charts/nice_ticks.h"
#include "widgets/theme/theme.h"

#include <QChartView>
#include <QLocale>

#include <vector>

class QAbstractSeries;
class QAreaSeries;
class QLineSeries;
class QValueAxis;

namespace berg {

/** What a line stands for; decides colour and width. */
enum class LineRole
{
    Accumulated, ///< zeta
    Momentary,   ///< sum of sigma, with a light area below
    Sigma        ///< sigma of one iceberg, coloured by its value
};

struct TimeLine
{
    QString label;               ///< written beside the line
    std::vector<QPointF> points; ///< x seconds, y in the unit of its axis, >= 0
    LineRole role = LineRole::Momentary;
    bool onRightAxis = false;
};

/** Everything a chart over time shows, as plain values. */
struct TimeChartContent
{
    QString title;
    QString leftTitle;  ///< quantity and unit
    QString rightTitle; ///< empty: no right axis
    double duration_s = 1000;
    std::vector<TimeLine> lines;
    std::vector<double> marks_s; ///< small ticks below the plot, e.g. visits
    QString marksTitle;
    double sigmaFull_m2 = 10; ///< end of the colour scale for `LineRole::Sigma`
    QString emptyText;        ///< shown when no line has a point
};

/**
 * Chart over time in the look of the program: no frame, light grid, times as mm:ss, the unit above
 * each axis, labels at the lines in place of a legend. Lines are decimated to the pixels there are;
 * nothing is animated.
 */
class TimeChart : public QChartView
{
    Q_OBJECT

public:
    explicit TimeChart(const Theme& theme, QWidget* parent = nullptr);

    void setContent(const TimeChartContent& content);
    void setTheme(const Theme& theme);
    [[nodiscard]] const TimeChartContent& content() const { return m_content; }

    /** Direct labels in their places, for tests; empty rectangles: not shown. */
    [[nodiscard]] std::vector<QRectF> labelRects() const;
    /** Series as drawn, after decimation, in the order of `content().lines`. */
    [[nodiscard]] std::vector<QList<QPointF>> drawnPoints() const;

protected:
    void resizeEvent(QResizeEvent* event) override;
    void drawBackground(QPainter* painter, const QRectF& rect) override;
    void drawForeground(QPainter* painter, const QRectF& rect) override;

private:
    void rebuild();
    void addSeries(QAbstractSeries* series, const TimeLine& line);
    void layOut();
    void setPlot(const NiceTicks& left, const NiceTicks& right);
    void fillFrame(const NiceTicks& left, const NiceTicks& right);
    void replacePoints();
    void styleLines();
    void placeMarginLabels();
    void placeInnerLabels();
    [[nodiscard]] bool hasPoints() const;
    [[nodiscard]] bool labelsInMargin() const;
    [[nodiscard]] double largest(bool onRightAxis) const;
    [[nodiscard]] std::vector<ChartTick> valueTicks(const NiceTicks& ticks) const;
    [[nodiscard]] double timeToView(double time_s) const;
    [[nodiscard]] QPointF toView(const TimeLine& line, const QPointF& p) const;
    [[nodiscard]] QColor lineColour(const TimeLine& line) const;

    Theme m_theme;
    TimeChartContent m_content;
    QValueAxis* m_time = nullptr;
    QValueAxis* m_left = nullptr;
    QValueAxis* m_right = nullptr;
    std::vector<QLineSeries*> m_series;
    std::vector<QAreaSeries*> m_areas;
    ChartFrame m_frame;
};

} // namespace berg
