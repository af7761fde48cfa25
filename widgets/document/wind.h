#pragma once

#include "core/scenario/scenario.h"

namespace berg {

/** Returns the airspeed of the slowest UAV, which exceeds every valid wind, m/s; 0 without UAVs. */
[[nodiscard]] double slowestAirspeed_mps(const Scenario& scenario);

/** Returns the direction a wind blows from, degrees clockwise from north in [0, 360); 0 in calm. */
[[nodiscard]] double windFrom_deg(const Point& wind_mps);

/** Returns the wind vector of a speed and direction, rounded to 0.001 m/s. */
[[nodiscard]] Point windOf(double speed_mps, double from_deg);

/** Returns the largest multiple of the step below the airspeed, m/s; 0 if there is none. */
[[nodiscard]] double fastestWind_mps(double airspeed_mps, double step_mps);

} // namespace berg
