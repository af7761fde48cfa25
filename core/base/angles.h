#pragma once

#include <cmath>
#include <numbers>

namespace berg {

inline constexpr double kPi = std::numbers::pi;

[[nodiscard]] constexpr double radFromDeg(double angle_deg)
{
    return angle_deg * (kPi / 180.0);
}

[[nodiscard]] constexpr double degFromRad(double angle_rad)
{
    return angle_rad * (180.0 / kPi);
}

/** Returns the angle brought into [-pi, pi]. */
[[nodiscard]] inline double wrapPi(double angle_rad)
{
    if (std::abs(angle_rad) <= kPi)
        return angle_rad; // equals the remainder, which is slow to compute
    return std::remainder(angle_rad, 2 * kPi);
}

/**
 * Returns the paper's psi (counter-clockwise from the x = east axis) for a heading clockwise from
 * north.
 */
[[nodiscard]] inline double psiFromHeading(double heading_deg)
{
    return wrapPi(radFromDeg(90.0 - heading_deg));
}

/** Returns the heading in [0, 360) degrees clockwise from north for the paper's psi. */
[[nodiscard]] inline double headingFromPsi(double psi_rad)
{
    const double heading_deg = std::fmod(90.0 - degFromRad(psi_rad), 360.0);
    const double positive_deg = heading_deg < 0 ? heading_deg + 360.0 : heading_deg;
    return positive_deg >= 360.0 ? 0.0 : positive_deg;
}

} // namespace berg
