#pragma once

#include "core/io/figure/figure_layout.h"
#include "widgets/charts/chart_content.h"
#include "widgets/charts/time_window.h"
#include "widgets/theme/theme.h"

#include <QLocale>
#include <QSizeF>

namespace berg {

/** What a chart over time is laid out for. Borrowed theme. */
struct TimeFigureStyle
{
    const Theme& theme;
    QLocale locale;
    QSizeF size_px;
    TimeWindow window; ///< in view; longer than 0
    bool hasTitle = true;
    bool hasNames = true;     ///< false: of lines; something beside the chart says them
    bool hasLines = true;     ///< false: of many lines the chart shows them itself
    double leastLeft_px = 0;  ///< of the plot from the edges, so that charts one below the other
    double leastRight_px = 0; ///< have one time axis
};

/** A chart over time as a figure, laid out. */
struct TimeFigure
{
    TimeWindow window;
    Figure figure;
    Drawing drawing;
    /** By line of the content: what is in view of it as at most two points for each column of
     * pixels, seconds and the unit of its axis. */
    std::vector<QList<QPointF>> drawn;

    [[nodiscard]] double viewToTime(double x_px) const; ///< within the window
    [[nodiscard]] const PlotScale& axisOf(const TimeLine& line) const
    {
        return line.onRightAxis ? drawing.right : drawing.y;
    }
    [[nodiscard]] Pixel toView(const TimeLine& line, const QPointF& p) const
    {
        return drawing.at({p.x(), p.y()}, line.onRightAxis);
    }
};

/** There are lines with points to see. */
[[nodiscard]] bool hasPoints(const TimeChartContent& content);

/** Number of columns for which lines in a chart of this width are worth having points. */
[[nodiscard]] int chartColumns(double width_px);

/**
 * Layout of a chart without the names beside the lines, which `placeLabels` of
 * its figure adds: in the right margin where there are many, as far as there is
 * room, those of the largest values first; else in the plot, clear of all
 * lines. Thread: any with a QGuiApplication.
 */
[[nodiscard]] TimeFigure timeFigure(const TimeChartContent& content, const TimeFigureStyle& style);

/** Lines by importance for names: emphasised first, then by the value at `points`. */
[[nodiscard]] std::vector<std::size_t>
byImportance(const TimeChartContent& content, const std::vector<std::optional<QPointF>>& points);

} // namespace berg
