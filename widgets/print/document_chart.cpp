#include "widgets/print/document_chart.h"

#include "widgets/charts/line_look.h"
#include "widgets/theme/painter_state.h"

#include <algorithm>
#include <numeric>

namespace berg {
namespace {

constexpr double kShortest_s = 1e-3; // an axis has to have a length

ChartStroke strokeOf(const TimeLine& line, const QList<QPointF>& drawn, const TimeFigure& figure,
                     const QColor& colour)
{
    ChartStroke stroke{.points = {}, .pen = {}, .area = {}, .key = line.key};
    stroke.points.reserve(drawn.size());
    for (const QPointF& point : drawn)
        stroke.points << figure.toView(line, point);
    if (line.role == LineRole::Momentary) {
        stroke.area = colour;
        stroke.area.setAlphaF(kAreaInk);
    }
    return stroke;
}

qsizetype segmentsOf(const std::vector<QList<QPointF>>& drawn)
{
    return std::accumulate(
        drawn.begin(), drawn.end(), qsizetype{0},
        [](qsizetype sum, const QList<QPointF>& points) { return sum + points.size(); });
}

void paintArea(QPainter& painter, const ChartStroke& stroke, const TimeFigure& figure)
{
    const double foot_px = figure.toView({}, {0, 0}).y();
    QPolygonF area = stroke.points;
    area << QPointF(area.back().x(), foot_px) << QPointF(area.front().x(), foot_px);
    painter.setPen(Qt::NoPen);
    painter.setBrush(stroke.area);
    painter.drawPolygon(area);
}

TimeWindow windowOf(const TimeChartContent& content)
{
    return {.from_s = 0, .to_s = std::max(kShortest_s, content.duration_s)};
}

DocumentChart documentChart(const TimeChartContent& content, const TimeFigureStyle& style)
{
    DocumentChart chart{.figure = timeFigure(content, style), .strokes = {}};
    placeLabels(chart.figure, content, style.theme);
    const bool crowded = isCrowded(segmentsOf(chart.figure.drawn));
    for (std::size_t i = 0; i < content.lines.size(); ++i) {
        const TimeLine& line = content.lines[i];
        if (chart.figure.drawn[i].isEmpty())
            continue;
        QColor colour = lineColour(line, style.theme, content.sigmaFull_m2);
        ChartStroke stroke = strokeOf(line, chart.figure.drawn[i], chart.figure, colour);
        if (crowded && line.role == LineRole::Sigma)
            colour.setAlphaF(kFaintInk);
        stroke.pen = linePen(line, colour, crowded, Qt::FlatCap);
        chart.strokes.push_back(std::move(stroke));
    }
    return chart;
}

} // namespace

std::vector<DocumentChart> documentCharts(std::span<const TimeChartContent> contents,
                                          const Theme& theme, const QSizeF& size_px,
                                          const QLocale& locale)
{
    TimeFigureStyle style{.theme = theme, .locale = locale, .size_px = size_px, .window = {}};
    double left_px = 0;
    double right_px = 0;
    for (const TimeChartContent& content : contents) {
        style.window = windowOf(content);
        const QRectF plot = timeFigure(content, style).frame.plot;
        left_px = std::max(left_px, plot.left());
        right_px = std::max(right_px, size_px.width() - plot.right());
    }
    style.leastLeft_px = left_px;
    style.leastRight_px = right_px;
    std::vector<DocumentChart> charts;
    for (const TimeChartContent& content : contents) {
        style.window = windowOf(content);
        charts.push_back(documentChart(content, style));
    }
    return charts;
}

void paintDocumentChart(QPainter& painter, const QPointF& at, const DocumentChart& chart,
                        const Theme& theme)
{
    const PainterState saved(painter);
    painter.translate(at);
    painter.setRenderHint(QPainter::Antialiasing);
    paintChartGrid(painter, chart.figure.frame, theme);
    for (const ChartStroke& stroke : chart.strokes) // areas first: no line disappears below one
        if (stroke.area.isValid())
            paintArea(painter, stroke, chart.figure);
    painter.setBrush(Qt::NoBrush);
    for (const ChartStroke& stroke : chart.strokes) {
        painter.setPen(stroke.pen);
        painter.drawPolyline(stroke.points);
    }
    paintChartFrame(painter, chart.figure.frame, theme);
}

} // namespace berg
