#pragma once

#include "widgets/charts/mission_charts.h"

namespace berg {

// Parts of `emptyChart` for quantities of UAVs: one line for a single UAV, in a fleet a line per
// UAV in its colour and with its name. Each function sets titles, lines, limits and summary.

void fillDistance(TimeChartContent& content, const FlightRecord& record, const QLocale& locale);
void fillTurnRate(TimeChartContent& content, const FlightRecord& record, const QLocale& locale);
void fillCrossTrack(TimeChartContent& content, const FlightRecord& record, const QLocale& locale);

/** Value for `chartValue` of one of these kinds; nullopt if there is no such line. */
[[nodiscard]] std::optional<double> uavChartValue(ChartKind kind, const Sample& sample,
                                                  std::size_t line);

} // namespace berg
