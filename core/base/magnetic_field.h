#pragma once

#include "core/base/geodesy.h"

#include <optional>

namespace berg {

/** The Earth's main field at a place, nT. */
struct MagneticField
{
    double east_nanotesla = 0;
    double north_nanotesla = 0;
    double up_nanotesla = 0;
};

/**
 * By the World Magnetic Model 2025 at `year` (2026.5 is the middle of 2026) and a height above the
 * ellipsoid. Returns nullopt outside 2025 to 2030, for which the model is made.
 */
[[nodiscard]] std::optional<MagneticField> magneticField(LatLon place, double height_m,
                                                         double year);

/**
 * Magnetic declination at sea level: how far east of true north a compass points, degrees in
 * (-180, 180]. Returns nullopt outside the years of the model, and where the horizontal field is
 * below 2000 nT, where a compass is of no use (the model's blackout zone near the magnetic poles).
 */
[[nodiscard]] std::optional<double> magneticDeclination_deg(LatLon place, double year);

} // namespace berg
