#include "widgets/charts/chart_labels.h"
#include "widgets/charts/decimate.h"
#include "widgets/charts/line_look.h"
#include "widgets/charts/time_figure.h"

#include <QFontMetricsF>

#include <algorithm>

namespace berg {
namespace {

constexpr double kLabelHeight_px = 15;
constexpr double kLeader_px = 16;        // between the end of a line and its label in the margin
constexpr double kFarthestLabel_px = 32; // from the end of its line
constexpr double kWidestShare = 0.2;     // of the chart, that the names may take

/** Where the polyline ends within a view that ends at `to`. */
std::optional<QPointF> endOf(const QList<QPointF>& points, const TimeWindow& view)
{
    if (points.empty() || points.back().x() > view.to_s)
        return pointAt(points, view.to_s);
    return points.back().x() < view.from_s ? std::nullopt : std::optional(points.back());
}

QFont labelFont(const Theme& theme, bool isStrong)
{
    QFont font = theme.small();
    font.setBold(isStrong);
    return font;
}

void placeMarginLabels(TimeFigure& figure, const TimeChartContent& content, const Theme& theme)
{
    // Where lines crowd, the most uncertain ones are named.
    std::vector<std::optional<QPointF>> ends;
    for (const QList<QPointF>& points : figure.drawn)
        ends.push_back(endOf(points, figure.window));
    const std::vector<std::size_t> named = byImportance(content, ends);
    const QRectF& plot = figure.frame.plot;
    const LabelColumn column{.top = plot.top() - kLabelHeight_px / 2,
                             .bottom = plot.bottom() + kLabelHeight_px / 2,
                             .spacing = kLabelHeight_px};
    const double widest_px = kWidestShare * figure.frame.size.width();
    std::vector<double> wanted;
    for (const std::size_t i : named)
        wanted.push_back(figure.toView(content.lines[i], *ends[i]).y());
    const std::vector<std::optional<double>> middles =
        nameableLabels(wanted, column, kFarthestLabel_px);
    for (std::size_t k = 0; k < named.size(); ++k) {
        if (!middles[k])
            continue;
        const TimeLine& line = content.lines[named[k]];
        const QPointF end = figure.toView(line, *ends[named[k]]);
        const bool isStrong = line.emphasis == LineEmphasis::Strong;
        const QFontMetricsF metrics(labelFont(theme, isStrong));
        const QString text = metrics.elidedText(line.label, Qt::ElideRight, widest_px);
        figure.frame.labels.push_back(
            {.text = text,
             .rect = QRectF(end.x() + kLeader_px, *middles[k] - kLabelHeight_px / 2,
                            metrics.horizontalAdvance(text) + 2, kLabelHeight_px),
             .end = end,
             .colour = lineColour(line, theme, content.sigmaFull_m2),
             .inMargin = true,
             .strong = isStrong,
             .key = line.key});
    }
}

void placeInnerLabels(TimeFigure& figure, const TimeChartContent& content, const Theme& theme,
                      std::vector<QRectF> taken)
{
    const QRectF& plot = figure.frame.plot;
    std::vector<QPolygonF> polygons;
    for (std::size_t i = 0; i < figure.drawn.size(); ++i) {
        QPolygonF polygon;
        for (const QPointF& p : figure.drawn[i])
            polygon << figure.toView(content.lines[i], p);
        polygons.push_back(polygon);
    }
    for (const ChartReference& reference : figure.frame.references) {
        const double width_px = QFontMetricsF(theme.small()).horizontalAdvance(reference.text);
        taken.emplace_back(plot.right() - width_px - 6, reference.at_px - 17, width_px, 17);
    }
    if (figure.frame.cursor_px)
        taken.emplace_back(*figure.frame.cursor_px - 1, plot.top(), 2, plot.height());
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const TimeLine& line = content.lines[i];
        const bool isQuiet = line.role == LineRole::Bound;
        const QFontMetricsF metrics(isQuiet ? theme.small() : theme.strong());
        const QSizeF size(metrics.horizontalAdvance(line.label) + 2, metrics.height());
        const auto rect = labelBesideLine(polygons[i], polygons, taken, size,
                                          plot.adjusted(4, 0, -4, -kChartMark_px - 2));
        if (!rect)
            continue;
        taken.push_back(*rect);
        figure.frame.labels.push_back({.text = line.label,
                                       .rect = *rect,
                                       .end = polygons[i].back(),
                                       .colour = lineColour(line, theme, content.sigmaFull_m2),
                                       .quiet = isQuiet,
                                       .key = line.key});
    }
}

} // namespace

double labelMargin_px(const TimeChartContent& content, const Theme& theme, double chartWidth_px)
{
    if (std::none_of(content.lines.begin(), content.lines.end(), isOneOfMany))
        return 0;
    double width_px = 0;
    for (const bool isStrong : {false, true}) {
        const QFontMetricsF metrics(labelFont(theme, isStrong));
        for (const TimeLine& line : content.lines)
            if (!line.hidden && (line.emphasis == LineEmphasis::Strong) == isStrong)
                width_px = std::max(width_px, metrics.horizontalAdvance(line.label));
    }
    return kLeader_px + std::min(width_px, kWidestShare * chartWidth_px);
}

void placeLabels(TimeFigure& figure, const TimeChartContent& content, const Theme& theme,
                 std::span<const QRectF> taken)
{
    if (std::any_of(content.lines.begin(), content.lines.end(), isOneOfMany))
        placeMarginLabels(figure, content, theme);
    else
        placeInnerLabels(figure, content, theme, {taken.begin(), taken.end()});
}

std::vector<std::size_t> byImportance(const TimeChartContent& content,
                                      const std::vector<std::optional<QPointF>>& points)
{
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i])
            order.push_back(i);
    const auto isStrong = [&content](std::size_t i) {
        return content.lines[i].emphasis == LineEmphasis::Strong;
    };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return isStrong(a) != isStrong(b) ? isStrong(a) : points[a]->y() > points[b]->y();
    });
    return order;
}

} // namespace berg
