#pragma once

#include "widgets/charts/time_chart.h"

#include <QImage>

namespace berg {

/** The chart as an image of `size_px`; `scale` device pixels for each unit of the layout. */
[[nodiscard]] QImage chartImage(const TimeChartContent& content, const Theme& theme,
                                const QSize& size_px, double scale);

} // namespace berg
