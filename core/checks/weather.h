#pragma once

#include "core/scenario/scenario.h"

namespace berg {

class Findings;

/**
 * Returns true if ice may form on an aircraft at `height_m` above the sea: temperature below 0 degC
 * in nearly saturated air (dew point within 2 degC, a relative humidity of some 87 %). The
 * temperature falls by 6.5 degC and the dew point by 1.8 degC per kilometre. Returns false if
 * either is unknown.
 */
[[nodiscard]] bool isIcing(const Weather& weather, double height_m);

/**
 * Reports a warning for each UAV whose limits the weather of the scenario exceeds. With a forecast
 * it is that of the run (`weatherOfArea`), and a hint reports weather near a limit or unknown.
 */
void adviseWeather(const Scenario& scenario, Findings& findings);

} // namespace berg
