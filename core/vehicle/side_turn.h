#pragma once

#include "core/vehicle/path_home.h"

#include <limits>

namespace berg {

/** Largest turn of a path; the proof is at `pathTo`. */
inline constexpr double kMostTurn_rad = 18.85; // three full circles

/** Paths to a place that begin with a turn to one side; `pathTo` compares both sides. */
class SideTurn
{
public:
    /**
     * Prepares paths that turn to the left (`side` 1) or right (-1), with a command every
     * `command_s`. The wind relative to the place must be below the airspeed.
     */
    SideTurn(const DubinsState& start, const MovingPlace& place, const Motion& motion,
             double command_s, double side);

    /**
     * Returns the path with the smallest turn. Returns nullopt if its turn takes longer than
     * `within_s`, or if no turn to this side of up to `kMostTurn_rad` reaches the required heading.
     * The required heading turns no faster than the bearing of the place can, so no step along the
     * turn passes over an answer. Turns of whole commands can: with commands of one second, one
     * start in ten thousand, all within three circles of the place, gets a later answer one command
     * later than predicted.
     */
    [[nodiscard]] std::optional<Path>
    find(double within_s = std::numeric_limits<double>::infinity()) const;

    /** Returns the state after a turn by `turn_rad` >= 0 to this side. */
    [[nodiscard]] DubinsState turned(double turn_rad) const { return after(turn_rad).state; }

private:
    struct Turned
    {
        DubinsState state;
        double time_s = 0;
    };
    struct Miss
    {
        /** Required heading minus the heading of the turn, -pi to pi, 0 over the place. */
        double miss_rad = 0;
        double away_m = 0; ///< distance to the place
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
    double m_fastest_mps; ///< largest speed towards the place
    double m_crabGain; ///< largest ratio of the turn of the required heading to that of the bearing
};

} // namespace berg
