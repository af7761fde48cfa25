#pragma once

#include "core/scenario/scenario.h"

namespace berg {

class Findings;

/**
 * Whether ice may form on what flies at that height above the sea: below 0 degC in air that is
 * nearly saturated (dew point within 2 degC, a relative humidity of some 87 %). Upwards the
 * temperature falls by 6.5 degC and the dew point by 1.8 degC a kilometre. False where either is
 * not known.
 */
[[nodiscard]] bool isIcing(const Weather& weather, double height_m);

/** Warnings for UAVs whose limits the weather of the scenario exceeds. */
void adviseWeather(const Scenario& scenario, Findings& findings);

} // namespace berg
