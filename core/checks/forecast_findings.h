#pragma once

// Private to core/checks.

#include "core/checks/findings.h"

namespace berg {

/** Checks the values of the forecast of a scenario, its grid and its times, if there is one. */
void checkForecast(const Scenario& scenario, Findings& findings);

/**
 * Warns where the constant values of the scenario replace the forecast during the run (outside its
 * times, in gaps), of a forecast that is old, and of its wind and gusts above the limits of a UAV.
 */
void adviseForecast(const Scenario& scenario, Findings& findings);

/** Hints at an ice chart that is old at the start of the run, if there is one. */
void adviseIceChart(const Scenario& scenario, Findings& findings);

} // namespace berg
