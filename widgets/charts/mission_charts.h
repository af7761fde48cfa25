#pragma once

#include "widgets/charts/time_chart.h"
#include "widgets/model/flight_record.h"

namespace berg {

/** Zeta together with the sum of sigma over the mission so far; visits as marks. */
[[nodiscard]] TimeChartContent zetaContent(const FlightRecord& record, const QLocale& locale);

/** Sigma of every iceberg over the mission so far. */
[[nodiscard]] TimeChartContent sigmaContent(const FlightRecord& record, const QLocale& locale);

} // namespace berg
