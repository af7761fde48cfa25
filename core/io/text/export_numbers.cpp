#include "core/io/text/export_numbers.h"

#include <cmath>

namespace berg {

double roundedDegrees(double angle_deg)
{
    return std::round(angle_deg * 1e9) / 1e9 + 0.0; // + 0.0 turns -0 into 0
}

LatLon roundedPlace(LatLon place)
{
    LatLon rounded{.latitude_deg = roundedDegrees(place.latitude_deg),
                   .longitude_deg = roundedDegrees(place.longitude_deg)};
    if (rounded.longitude_deg >= 180)
        rounded.longitude_deg -= 360;
    return rounded;
}

double roundedSeconds(double time_s)
{
    return std::round(time_s * 1e3) / 1e3 + 0.0;
}

} // namespace berg
