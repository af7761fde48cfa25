#pragma once

#include "widgets/charts/chart_content.h"
#include "widgets/flight/flight_record.h"

#include <QLocale>

namespace berg {

/**
 * Part of `emptyChart` for wind, gusts and current: titles, lines with their points over the whole
 * run, limits of the UAVs, directions, and the instant shown. A gap of a forecast is a gap of its
 * line; a reference line and the title give the constant wind and current that are flown there.
 * Works before take-off, too.
 */
void fillWeather(TimeChartContent& content, const FlightRecord& record, const QLocale& locale);

/** Velocity between those of a list; nullopt where it has a gap or ends. */
[[nodiscard]] std::optional<Point> velocityAt_mps(const std::vector<TimeVelocity>& velocities,
                                                  double time_s);

} // namespace berg
