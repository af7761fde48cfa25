#pragma once

#include "core/scenario/scenario.h"

namespace berg {

/** Airspeed of the slowest UAV: every wind of the scenario is slower; 0: there is no UAV. */
[[nodiscard]] double slowestAirspeed_mps(const Scenario& scenario);

/** Where a wind blows from, degrees clockwise from north in [0, 360); 0 in calm. */
[[nodiscard]] double windFrom_deg(const Point& wind_mps);

/** The wind of this speed from there, to the millimetre a second. */
[[nodiscard]] Point windOf(double speed_mps, double from_deg);

/** Largest multiple of the step that is slower than the UAV flies; 0: none is. */
[[nodiscard]] double fastestWind_mps(double airspeed_mps, double step_mps);

} // namespace berg
