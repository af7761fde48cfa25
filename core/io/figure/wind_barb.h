#pragma once

#include "core/geometry/geometry.h"
#include "core/io/figure/figure_layout.h"

namespace berg {

/** Speed of the wind that a barb shows: knots, rounded to five. */
[[nodiscard]] int barbSpeed_kn(const Point& wind_mps);

/**
 * Wind barb of the WMO, in pixels around the station, y down: the shaft points to where the wind
 * comes from; half a barb is 5 kn, a barb 10 kn, a pennant 50 kn, and calm is a circle.
 */
struct WindBarb
{
    std::vector<std::vector<Pixel>> lines;    ///< shaft and barbs
    std::vector<std::vector<Pixel>> pennants; ///< triangles to be filled
    std::optional<double> calm_px;            ///< radius of the circle in calm
};

/**
 * Returns the barb of a wind towards east and north. `shaft_px` is the length of the shaft; the
 * barbs are to the left of the wind, and in the southern hemisphere to its right.
 */
[[nodiscard]] WindBarb windBarb(const Point& wind_mps, double shaft_px, bool isSouthern);

/** Returns an arrow of this length around its middle that points towards `velocity_mps`, which is
 * not zero: a line, and its head. */
[[nodiscard]] std::vector<std::vector<Pixel>> velocityArrow(const Point& velocity_mps,
                                                            double length_px);

} // namespace berg
