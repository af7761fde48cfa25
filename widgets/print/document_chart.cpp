#include "widgets/print/document_chart.h"

#include "widgets/charts/figure_painter.h"

#include <algorithm>

namespace berg {
namespace {

constexpr double kShortest_s = 1e-3; // smallest length of an axis

} // namespace

std::vector<TimeFigure> documentCharts(std::span<const TimeChartContent> contents,
                                       const Theme& theme, const QSizeF& size_px,
                                       const QLocale& locale)
{
    TimeFigureStyle style{.theme = theme, .locale = locale, .size_px = size_px, .window = {}};
    const auto chartOf = [&style](const TimeChartContent& content) {
        style.window = {.from_s = 0, .to_s = std::max(kShortest_s, content.duration_s)};
        return timeFigure(content, style);
    };
    double left_px = 0;
    double right_px = 0;
    for (const TimeChartContent& content : contents) {
        const PixelRect plot = chartOf(content).drawing.plot;
        left_px = std::max(left_px, plot.left);
        right_px = std::max(right_px, size_px.width() - plot.right);
    }
    style.leastLeft_px = left_px;
    style.leastRight_px = right_px;
    std::vector<TimeFigure> charts;
    for (const TimeChartContent& content : contents) {
        charts.push_back(chartOf(content));
        placeLabels(charts.back().figure, figureFonts(theme), charts.back().drawing);
    }
    return charts;
}

} // namespace berg
