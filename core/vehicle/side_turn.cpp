#include "core/vehicle/side_turn.h"

#include "core/base/angles.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

constexpr double kLeastStep_rad = 0.01;
/** The commands after the turn correct heading errors below this. */
constexpr double kHeading_rad = 0.02;

} // namespace

SideTurn::SideTurn(const DubinsState& start, const MovingPlace& place, const Motion& motion,
                   double command_s, double side)
    : m_start(start)
    , m_place(place)
    , m_motion(motion)
    , m_command_s(command_s)
    , m_side(side)
    , m_relativeWind_mps(motion.wind_mps - place.drift_mps)
    , m_fastest_mps(motion.airspeed_mps + m_relativeWind_mps.norm())
    , m_crabGain(1 +
                 m_relativeWind_mps.norm() / std::sqrt(motion.airspeed_mps * motion.airspeed_mps -
                                                       m_relativeWind_mps.squaredNorm()))
{
}

std::optional<Path> SideTurn::find(double within_s) const
{
    double low_rad = 0;
    Miss low = missAfter(0);
    while (low.miss_rad != 0) {
        const double high_rad = low_rad + safeStep_rad(low);
        const Miss high = missAfter(high_rad);
        const bool changes = (low.miss_rad > 0) != (high.miss_rad > 0);
        // A sign change counts only if it is not on the far side of the compass.
        if (changes && std::abs(low.miss_rad - high.miss_rad) < kPi) {
            low_rad = root(low_rad, low.miss_rad, high_rad, high.miss_rad);
            if (std::abs(missAfter(low_rad).miss_rad) < kHeading_rad)
                break;
        }
        low_rad = high_rad;
        low = high;
        if (low_rad > kMostTurn_rad || low_rad > within_s * m_motion.limit_radps)
            return std::nullopt;
    }
    return pathAfter(low_rad);
}

/** Advances the state exactly along an arc, or straight on. */
void SideTurn::fly(Turned& turned, double rate_radps, double time_s) const
{
    const double half_rad = rate_radps * time_s / 2;
    const double chord_m =
        m_motion.airspeed_mps * time_s * (half_rad == 0 ? 1 : std::sin(half_rad) / half_rad);
    const double middle_rad = turned.state.psi_rad + half_rad;
    turned.state.position_m +=
        chord_m * Point(std::cos(middle_rad), std::sin(middle_rad)) + m_motion.wind_mps * time_s;
    turned.state.psi_rad += 2 * half_rad;
    turned.time_s += time_s;
}

SideTurn::Turned SideTurn::after(double turn_rad) const
{
    Turned turned{.state = m_start};
    const double whole = std::floor(turn_rad / (m_motion.limit_radps * m_command_s));
    fly(turned, m_side * m_motion.limit_radps, whole * m_command_s);
    const double rest_rad = turn_rad - whole * m_motion.limit_radps * m_command_s;
    if (rest_rad > 0)
        fly(turned, m_side * rest_rad / m_command_s, m_command_s);
    return turned;
}

Point SideTurn::toPlace_m(const Turned& turned) const
{
    return m_place.place_m + m_place.drift_mps * turned.time_s - turned.state.position_m;
}

SideTurn::Miss SideTurn::missAfter(double turn_rad) const
{
    const Turned turned = after(turn_rad);
    const Point path_m = toPlace_m(turned);
    const double away_m = path_m.norm();
    const double across = cross(path_m, m_relativeWind_mps) / away_m;
    if (!std::isfinite(across))
        return {}; // the UAV is over the place
    const double wanted_rad =
        std::atan2(path_m.y(), path_m.x()) - std::asin(across / m_motion.airspeed_mps);
    return {.miss_rad = wrapPi(m_side * (wanted_rad - turned.state.psi_rad)), .away_m = away_m};
}

/**
 * Returns a step, at least `kLeastStep_rad`, within which no turn ends with the required heading.
 */
double SideTurn::safeStep_rad(const Miss& now) const
{
    const double nearer_m = m_fastest_mps / m_motion.limit_radps; // per radian
    // Bounds the turn of the required heading per radian of turn, while half the distance is left.
    const double swing = 2 * m_crabGain * nearer_m / now.away_m;
    const double ahead_rad = now.miss_rad > 0 ? now.miss_rad : now.miss_rad + 2 * kPi;
    double step_rad = std::min(ahead_rad / (1 + swing), now.away_m / (2 * nearer_m));
    if (swing > 1)
        step_rad = std::min(step_rad, (2 * kPi - ahead_rad) / (swing - 1));
    return std::max(kLeastStep_rad, step_rad);
}

/**
 * Finds the root by regula falsi, Illinois variant. A miss beyond both ends is on the far side of
 * the compass.
 */
double SideTurn::root(double low_rad, double low, double high_rad, double high) const
{
    constexpr int kMostRounds = 60;
    double middle_rad = low_rad;
    for (int round = 0; round < kMostRounds; ++round) {
        middle_rad = (low_rad * high - high_rad * low) / (high - low);
        const double middle = missAfter(middle_rad).miss_rad;
        const double farther = std::max({std::abs(low), std::abs(high), kPi / 2});
        if (std::abs(middle) < 1e-9 || std::abs(middle) > farther)
            break;
        if ((middle > 0) == (high > 0)) {
            low /= 2;
        } else {
            low_rad = high_rad;
            low = high;
        }
        high_rad = middle_rad;
        high = middle;
    }
    return middle_rad;
}

Path SideTurn::pathAfter(double turn_rad) const
{
    Turned turned = after(turn_rad);
    const double straight_s =
        flightTime_s(toPlace_m(turned), m_motion.airspeed_mps, m_relativeWind_mps);
    fly(turned, 0, straight_s);
    turned.state.psi_rad = wrapPi(turned.state.psi_rad);
    return {.turn_rad = m_side * turn_rad, .time_s = turned.time_s, .end = turned.state};
}

} // namespace berg
