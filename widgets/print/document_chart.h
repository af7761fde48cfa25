#pragma once

#include "widgets/charts/time_figure.h"

#include <QPen>
#include <QPolygonF>

namespace berg {

/** A line of a chart as it is painted. */
struct ChartStroke
{
    QPolygonF points;
    QPen pen;
    QColor area; ///< below it; invalid: none
    QString key; ///< of its line
};

/** The chart that `TimeChart` shows, all of it, for paper and other paint devices. */
struct DocumentChart
{
    TimeFigure figure;
    std::vector<ChartStroke> strokes; ///< by line of the content, without those of no points
};

/** Charts of this size, their plots one below the other. Thread: any with a QGuiApplication. */
[[nodiscard]] std::vector<DocumentChart> documentCharts(std::span<const TimeChartContent> contents,
                                                        const Theme& theme, const QSizeF& size_px,
                                                        const QLocale& locale);

/** Chart with its top left at `at`; the painter is left as it was. */
void paintDocumentChart(QPainter& painter, const QPointF& at, const DocumentChart& chart,
                        const Theme& theme);

} // namespace berg
