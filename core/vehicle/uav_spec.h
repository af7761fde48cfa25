#pragma once

#include <optional>

namespace berg {

/** Acceleration of gravity. */
inline constexpr double kGravity_mps2 = 9.81;

/**
 * Performance of a UAV. Angles are in degrees because users set them; derived values are in
 * radians.
 */
struct UavSpec
{
    double airspeed_mps = 22;
    double maxBank_deg = 25;
    double altitude_m = 120;
    double endurance_s = 0;          ///< 0 means unlimited
    double reservePercent = 20;      ///< percentage of the endurance kept for the unforeseen
    std::optional<double> reserve_s; ///< replaces the percentage
    double climb_s = 0;              ///< time from take-off to the flight altitude
    double landing_s = 0;            ///< time from the flight altitude, over home, to the ground
    /** Interval between two commands of the autopilot; 0 means one in each time step. */
    double autopilot_s = 0;
    bool operator==(const UavSpec&) const = default;
};

/**
 * Returns the reserve, s: the part of the endurance that no flight is planned to use; a share of it
 * unless the fixed reserve is set.
 */
[[nodiscard]] double reserve_s(const UavSpec& spec);
/**
 * Returns the endurance, s, for flight at altitude: without reserve, climb and landing; negative if
 * they take longer. Returns 0 if the endurance is unlimited.
 */
[[nodiscard]] double usableEndurance_s(const UavSpec& spec);

/**
 * Returns the largest turn rate, g/U tan(bank limit), Table 3 of the paper: 0.2079 rad/s by
 * default.
 */
[[nodiscard]] double maxTurnRate_radps(const UavSpec& spec);
/** Returns the smallest turn radius, U / max turn rate: 105.8 m by default. */
[[nodiscard]] double turnRadius_m(const UavSpec& spec);

} // namespace berg
