#pragma once

#include "widgets/charts/time_figure.h"

#include <span>

namespace berg {

/**
 * Returns complete charts as in `TimeChart` for paper and other paint devices. Each has this size;
 * the plots are aligned above each other. Runs on any thread with a QGuiApplication.
 */
[[nodiscard]] std::vector<TimeFigure> documentCharts(std::span<const TimeChartContent> contents,
                                                     const Theme& theme, const QSizeF& size_px,
                                                     const QLocale& locale);

} // namespace berg
