#pragma once

#include "core/earth/geodesy.h"

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
 * Returns the field by the World Magnetic Model 2025 at a height above the ellipsoid, m. `year` has
 * a fraction: 2026.5 is the middle of 2026. Returns nullopt outside 2025 to 2030, the range of the
 * model.
 */
[[nodiscard]] std::optional<MagneticField> magneticField(LatLon place, double height_m,
                                                         double year);

/**
 * Returns the magnetic declination at sea level: the angle of compass north east of true north,
 * degrees in (-180, 180]. Returns nullopt outside the years of the model, and where the horizontal
 * field is below 2000 nT, so that a compass is useless (the model's blackout zone near the magnetic
 * poles).
 */
[[nodiscard]] std::optional<double> magneticDeclination_deg(LatLon place, double year);

} // namespace berg
