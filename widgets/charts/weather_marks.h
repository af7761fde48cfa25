#pragma once

#include "widgets/charts/time_figure.h"

namespace berg {

/**
 * Adds the directions of wind and current to the figure of a chart of this size, which is not laid
 * out yet: wind barbs in a row above the lines, for which it reserves room, and arrows on the line
 * of the current. A chart too low for the row has none.
 */
void addWeatherMarks(TimeFigure& time, const TimeChartContent& content, const QSizeF& size_px);

} // namespace berg
