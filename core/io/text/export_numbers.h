#pragma once

#include "core/base/geodesy.h"

#include <cmath>

namespace berg {

// Numbers as exported files hold them.

/** To nine decimals, 0.1 mm on the ground; never -0. */
[[nodiscard]] inline double roundedDegrees(double angle_deg)
{
    return std::round(angle_deg * 1e9) / 1e9 + 0.0; // + 0.0 turns -0 into 0
}

/** `roundedDegrees` of both; the longitude stays in [-180, 180). */
[[nodiscard]] inline LatLon roundedPlace(LatLon place)
{
    const double longitude_deg = roundedDegrees(place.longitude_deg);
    return {.latitude_deg = roundedDegrees(place.latitude_deg),
            .longitude_deg = longitude_deg >= 180 ? longitude_deg - 360 : longitude_deg};
}

/** To milliseconds, which hides the rounding of step x dt; never -0. */
[[nodiscard]] inline double roundedSeconds(double time_s)
{
    return std::round(time_s * 1e3) / 1e3 + 0.0;
}

} // namespace berg
