#pragma once

#include "widgets/charts/time_figure.h"

#include <span>

namespace berg {

/**
 * The charts that `TimeChart` shows, all of them, for paper and other paint
 * devices: of this size, their plots one below the other. Thread: any with a
 * QGuiApplication.
 */
[[nodiscard]] std::vector<TimeFigure> documentCharts(std::span<const TimeChartContent> contents,
                                                     const Theme& theme, const QSizeF& size_px,
                                                     const QLocale& locale);

} // namespace berg
