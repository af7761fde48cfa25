#pragma once

#include "core/earth/geodesy.h"

#include <cmath>

namespace berg {

// Rounded numbers for exported files.

/** Rounds to nine decimals (0.1 mm on the ground); never returns -0. */
[[nodiscard]] inline double roundedDegrees(double angle_deg)
{
    return std::round(angle_deg * 1e9) / 1e9 + 0.0; // + 0.0 turns -0 into 0
}

/** Rounds both angles by `roundedDegrees`; the longitude stays in [-180, 180). */
[[nodiscard]] inline LatLon roundedPlace(LatLon place)
{
    const double longitude_deg = roundedDegrees(place.longitude_deg);
    return {.latitude_deg = roundedDegrees(place.latitude_deg),
            .longitude_deg = longitude_deg >= 180 ? longitude_deg - 360 : longitude_deg};
}

/** Rounds to milliseconds, which hides the rounding error of step x dt; never returns -0. */
[[nodiscard]] inline double roundedSeconds(double time_s)
{
    return std::round(time_s * 1e3) / 1e3 + 0.0;
}

} // namespace berg
