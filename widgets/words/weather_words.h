#pragma once

#include "core/checks/weather_gate.h"

#include <QLocale>
#include <QString>

namespace berg {

/** Returns the name of a state: "Go", "Marginal", "Not known" or "No-go". */
[[nodiscard]] QString weatherStateText(WeatherState state);

/** Returns the reason in the user's units, such as "wind 12 m/s, limit 10 m/s". */
[[nodiscard]] QString weatherReasonText(const WeatherReason& reason, const QLocale& locale);

/**
 * Returns the verdict in one line: "No-go: wind 12 m/s, limit 10 m/s, from 14:20 UTC". In a fleet
 * the UAV comes before its reason. Without a start time the time is that of the run.
 */
[[nodiscard]] QString weatherText(const ScenarioWorld& scenario, const WeatherVerdict& weather,
                                  const QLocale& locale);

} // namespace berg
