#pragma once

#include <optional>

namespace berg {

inline constexpr double kGravity_mps2 = 9.81;

/** What the aircraft can do. Degrees because a user sets them; everything derived is in radians. */
struct UavSpec
{
    double airspeed_mps = 22;
    double maxBank_deg = 25;
    double altitude_m = 120;
    double endurance_s = 0;          ///< 0: unlimited
    double reservePercent = 20;      ///< of the endurance, kept for what is not foreseen
    std::optional<double> reserve_s; ///< in place of the percentage
    double climb_s = 0;              ///< from take-off to the altitude of the flight
    double landing_s = 0;            ///< from there, over home, to the ground
    double autopilot_s = 0; ///< between two commands of the autopilot; 0: one each time step
    bool operator==(const UavSpec&) const = default;
};

/** Part of the endurance, seconds, that no flight is planned to use. */
[[nodiscard]] double reserve_s(const UavSpec& spec);
/** What is left of the endurance to fly at altitude: without reserve, climb and landing; 0 when it
 * is unlimited. */
[[nodiscard]] double usableEndurance_s(const UavSpec& spec);

/** |u| <= g/U tan(bank limit), Table 3 of the paper: 0.2079 rad/s by default. */
[[nodiscard]] double maxTurnRate_radps(const UavSpec& spec);
/** U / max turn rate: 105.8 m by default. */
[[nodiscard]] double turnRadius_m(const UavSpec& spec);

} // namespace berg
