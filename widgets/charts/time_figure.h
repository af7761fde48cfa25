#pragma once

#include "core/base/nice_ticks.h"
#include "widgets/charts/chart_content.h"
#include "widgets/charts/chart_frame.h"
#include "widgets/charts/time_window.h"

#include <QLocale>

#include <span>

namespace berg {

/** What a chart over time is laid out for. Borrowed theme. */
struct TimeFigureStyle
{
    const Theme& theme;
    QLocale locale;
    QSizeF size_px;
    TimeWindow window; ///< in view; longer than 0
    bool hasTitle = true;
    double leastLeft_px = 0;  ///< of the plot from the edges, so that charts one below the other
    double leastRight_px = 0; ///< have one time axis
};

/** Where everything of a chart over time goes, device-independent pixels. */
struct TimeFigure
{
    TimeWindow window;
    double timeStep_s = 1; ///< between the times written
    NiceTicks left;
    NiceTicks right;
    ChartFrame frame;
    /** By line of the content: what is in view of it as at most two points for each column of
     * pixels, seconds and the unit of its axis. */
    std::vector<QList<QPointF>> drawn;

    [[nodiscard]] const NiceTicks& axisOf(const TimeLine& line) const
    {
        return line.onRightAxis ? right : left;
    }
    [[nodiscard]] double timeToView(double time_s) const;
    [[nodiscard]] double viewToTime(double x_px) const; ///< within the window
    [[nodiscard]] QPointF toView(const TimeLine& line, const QPointF& p) const;
};

/** There are lines with points to see. */
[[nodiscard]] bool hasPoints(const TimeChartContent& content);

/** Number of columns for which lines in a chart of this width are worth having points. */
[[nodiscard]] int chartColumns(double width_px);

/** Layout of a chart without the names beside the lines. Thread: any with a QGuiApplication. */
[[nodiscard]] TimeFigure timeFigure(const TimeChartContent& content, const TimeFigureStyle& style);

/**
 * Names the lines: in the right margin where there are many, as far as there is room, those of the
 * largest values first; else in the plot, clear of all lines and of `taken`.
 */
void placeLabels(TimeFigure& figure, const TimeChartContent& content, const Theme& theme,
                 std::span<const QRectF> taken = {});

/** Width of the margin for names; 0: they are in the plot. */
[[nodiscard]] double labelMargin_px(const TimeChartContent& content, const Theme& theme,
                                    double chartWidth_px);

/** Lines by importance for names: emphasised first, then by the value at `points`. */
[[nodiscard]] std::vector<std::size_t>
byImportance(const TimeChartContent& content, const std::vector<std::optional<QPointF>>& points);

/** Has its name in the margin, and a colour that is not that of the axis. */
[[nodiscard]] bool isOneOfMany(const TimeLine& line);

} // namespace berg
