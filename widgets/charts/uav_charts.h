#pragma once

#include "widgets/charts/mission_charts.h"

namespace berg {

// The charts of a mission that show what the UAVs do, as `emptyChart` has them: with one UAV a
// single line, with several a line for each in its colour, named by it.

void fillDistance(TimeChartContent& content, const FlightRecord& record, const QLocale& locale);
void fillTurnRate(TimeChartContent& content, const FlightRecord& record, const QLocale& locale);
void fillCrossTrack(TimeChartContent& content, const FlightRecord& record, const QLocale& locale);

/** `chartValue` of one of these kinds. */
[[nodiscard]] std::optional<double> uavChartValue(ChartKind kind, const Sample& sample,
                                                  std::size_t line);

} // namespace berg
