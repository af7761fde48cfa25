#pragma once

#include "core/vehicle/path_home.h"

#include <limits>

namespace berg {

/** No way turns further: the proof is at `pathTo`. */
inline constexpr double kMostTurn_rad = 18.85; // three full circles

/** Ways to a place that turn to one side: the half of `pathTo`. */
class SideTurn
{
public:
    /** `side` 1: to the left, -1: to the right. The relative wind must be below the airspeed. */
    SideTurn(const DubinsState& start, const MovingPlace& place, const Motion& motion,
             double command_s, double side);

    /**
     * The way with the least turn, one that takes so long at most. The heading wanted turns no
     * faster than the bearing of the place can, so no step along the turn passes over an answer.
     * Turns of whole commands can: with commands of a second one in ten thousand starts, all within
     * three circles of the place, finds a later answer a command later than it was foreseen.
     */
    [[nodiscard]] std::optional<Path>
    find(double within_s = std::numeric_limits<double>::infinity()) const;

    /** Where a turn by so much, >= 0, to this side ends. */
    [[nodiscard]] DubinsState turned(double turn_rad) const { return after(turn_rad).state; }

private:
    struct Turned
    {
        DubinsState state;
        double time_s = 0;
    };
    struct Miss
    {
        double miss_rad = 0; ///< what the turn is short of the heading wanted, -pi to pi
        double away_m = 0;   ///< distance of the place then
    };

    void fly(Turned& turned, double rate_radps, double time_s) const;
    [[nodiscard]] Turned after(double turn_rad) const;
    [[nodiscard]] Point toPlace_m(const Turned& turned) const;
    [[nodiscard]] Miss missAfter(double turn_rad) const;
    [[nodiscard]] double safeStep_rad(const Miss& now) const;
    [[nodiscard]] double root(double low_rad, double low, double high_rad, double high) const;
    [[nodiscard]] Path pathAfter(double turn_rad) const;

    DubinsState m_start;
    MovingPlace m_place;
    Motion m_motion;
    double m_command_s;
    double m_side;
    Point m_relativeWind_mps;
    double m_fastest_mps; ///< towards the place
    double m_crabGain;    ///< how much faster the heading wanted turns than the bearing
};

} // namespace berg
