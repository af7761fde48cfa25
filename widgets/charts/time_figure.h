#pragma once

#include "core/io/figure/figure_layout.h"
#include "widgets/charts/chart_content.h"
#include "widgets/charts/time_window.h"
#include "widgets/theme/theme.h"

#include <QLocale>
#include <QSizeF>

namespace berg {

/** Layout parameters of a chart over time. The theme is borrowed. */
struct TimeFigureStyle
{
    const Theme& theme;
    QLocale locale;
    QSizeF size_px;
    TimeWindow window; ///< part in view; its length is positive
    bool hasTitle = true;
    bool hasNames = true; ///< false if names of lines are shown beside the chart
    bool hasLines = true; ///< false if the caller draws the lines of fleets and icebergs itself
    /** Smallest margins of the plot, which align the time axes of charts above each other. */
    double leastLeft_px = 0;
    double leastRight_px = 0;
};

/** Laid-out figure of a chart over time. */
struct TimeFigure
{
    TimeWindow window;
    Figure figure;
    Drawing drawing;
    /** Visible part of each line, at most two points per pixel column; seconds, unit of its axis.
     */
    std::vector<QList<QPointF>> drawn;

    /** Time at an abscissa, clamped to the window. */
    [[nodiscard]] double viewToTime(double x_px) const;
    /** Scale of the axis of a line. */
    [[nodiscard]] const PlotScale& axisOf(const TimeLine& line) const
    {
        return line.onRightAxis ? drawing.right : drawing.y;
    }
    /** Position of a point of a line on the screen. */
    [[nodiscard]] Pixel toView(const TimeLine& line, const QPointF& p) const
    {
        return drawing.at({p.x(), p.y()}, line.onRightAxis);
    }
};

/** Returns whether any line is shown and has points. */
[[nodiscard]] bool hasPoints(const TimeChartContent& content);

/** Number of pixel columns that lines should be decimated to in a chart of this width. */
[[nodiscard]] int chartColumns(double width_px);

/**
 * Lays out a chart. The names of lines are added by `placeLabels` of its figure: in the right
 * margin if there are many lines, as far as there is room, largest values first; otherwise in the
 * plot, clear of all lines. Runs on any thread with a QGuiApplication.
 */
[[nodiscard]] TimeFigure timeFigure(const TimeChartContent& content, const TimeFigureStyle& style);

/** Indices of lines with a point, by importance of their names: emphasised first, then by value. */
[[nodiscard]] std::vector<std::size_t>
byImportance(const TimeChartContent& content, const std::vector<std::optional<QPointF>>& points);

} // namespace berg
