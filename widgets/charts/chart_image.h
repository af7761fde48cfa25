#pragma once

#include "widgets/charts/time_chart.h"

#include <QImage>

namespace berg {

/** Renders the chart to an image of `size_px`, with `scale` device pixels per layout unit. */
[[nodiscard]] QImage chartImage(const TimeChartContent& content, const Theme& theme,
                                const QSize& size_px, double scale);

/** Size and time range of a chart on a page. */
struct ChartPage
{
    QSize size_px{1120, 490};         ///< layout size at 96 per inch; PNG has twice as many pixels
    std::optional<TimeWindow> window; ///< part in view; nullopt shows all
};

/**
 * Writes the chart to `path` in the format given by its file name extension. Throws `Error`:
 * Unsupported for an extension other than `kPictureEndings`, FileUnwritable.
 */
void writeChartPicture(const TimeChartContent& content, const Theme& theme, const ChartPage& page,
                       const QString& path);

} // namespace berg
