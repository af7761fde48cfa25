#pragma once

#include "widgets/charts/time_chart.h"

#include <QImage>

namespace berg {

/** The chart as an image of `size_px`; `scale` device pixels for each unit of the layout. */
[[nodiscard]] QImage chartImage(const TimeChartContent& content, const Theme& theme,
                                const QSize& size_px, double scale);

/** A stretch of a chart on a page. */
struct ChartPage
{
    QSize size_px{1120, 490};         ///< of the layout, at 96 to the inch; PNG has twice as many
    std::optional<TimeWindow> window; ///< none: everything
};

/**
 * Writes the chart as the picture that the end of `path` names. Throws `Error`: Unsupported for
 * another end than `kPictureEndings`, FileUnwritable.
 */
void writeChartPicture(const TimeChartContent& content, const Theme& theme, const ChartPage& page,
                       const QString& path);

} // namespace berg
