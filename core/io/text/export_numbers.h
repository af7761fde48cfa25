#pragma once

#include "core/base/geodesy.h"

namespace berg {

// Numbers as exported files hold them.

/** To nine decimals, 0.1 mm on the ground; never -0. */
[[nodiscard]] double roundedDegrees(double angle_deg);

/** `roundedDegrees` of both; the longitude stays in [-180, 180). */
[[nodiscard]] LatLon roundedPlace(LatLon place);

/** To milliseconds, which hides the rounding of step x dt; never -0. */
[[nodiscard]] double roundedSeconds(double time_s);

} // namespace berg
