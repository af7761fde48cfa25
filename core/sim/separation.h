#pragma once

#include "core/sim/departure.h"

#include <limits>

namespace berg {

/**
 * Keeps UAVs of one altitude layer apart: wishes in, allowed turn rates out.
 *
 * Each UAV aloft has a reserved disc, in which it can circle over ground for ever, and the discs of
 * two UAVs of one layer are at least the separation apart. A UAV is only given a command after
 * which a disc tangent to its course, left or right, is clear of those of all others and inside its
 * fence; else it flies on round the one it has. So UAVs that begin apart stay apart, whatever they
 * wish (the generalized roundabout policy of Pallottino et al. 2007). They are asked one after
 * another; those that begin too near each other get no command that brings them nearer.
 *
 * Those that start too near each other depart together, see `departuresOf`: two of them that have
 * been the separation apart stay so.
 *
 * Of two that block each other one waits, and makes way after `kPatience_s`: see `precedes`. Those
 * that go after a UAV on its way home keep clear of the path ahead of it as well.
 */
class Separation
{
public:
    struct Wish
    {
        double rate_radps = 0;
        std::optional<Point> home_m; ///< where it flies to land; none: it does not
        /** Time of the run when it has to be home; infinity: it has no limit. */
        double due_s = std::numeric_limits<double>::infinity();
        bool hasGoal = true; ///< it is sent somewhere
    };

    /** A separation of 0: nobody is kept apart. By UAV, none of them aloft. */
    Separation(double separation_m, const std::vector<double>& altitudes_m);

    /** Whether there is anybody it must be kept apart from. */
    [[nodiscard]] bool concerns(int uav) const { return m_members[index(uav)].isConcerned; }
    [[nodiscard]] bool shareLayer(int a, int b) const;
    /** To be told before anything else, and of each new wind. */
    void setMotion(int uav, const SafetyGuard& guard);
    /** It is aloft there, whether or not there is room. */
    void enter(int uav, const SafetyGuard& guard, const DubinsState& pose);
    void leave(int uav);
    /** At the start of a flight, all of them entered: those that are too near each other fly apart
     * before anything else, where a way to do so is found. */
    void depart(std::span<const Departing> fleet);
    /** Whether there is room for it at the place, on any course. */
    [[nodiscard]] bool hasRoom(int uav, const Point& place_m) const;
    /** The turn rate to fly at until its next command. */
    [[nodiscard]] double command_radps(int uav, const SafetyGuard& guard, const DubinsState& pose,
                                       const Wish& wish);
    /** It has come to where it was sent, and does not wait any more. */
    void arrive(int uav) { m_members[index(uav)].waited_s = 0; }

private:
    static constexpr double kFar = std::numeric_limits<double>::infinity();

    struct Disc
    {
        Point middle_m;
        double radius_m = 0; ///< the UAV is inside until its next command, and can stay so
        double side = 1;     ///< where the UAV has the middle: 1 left, -1 right
    };
    struct Member
    {
        double altitude_m = 0;
        bool isConcerned = false;
        double radius_m = 0;           ///< of a disc in which it holds
        std::optional<Disc> disc;      ///< none: not aloft
        Point place_m = Point::Zero(); ///< at its last command
        /** When it is due home, of its first wish to fly there: the order of landing is fixed then.
         * None: it does not fly home. */
        std::optional<double> due_s;
        Departure departure; ///< what is left of it, or of a passage
        /** The path home ahead of it, which those that it precedes keep clear of as of its disc. */
        std::vector<Point> ahead_m;
        int blocker = -1;    ///< who denied its wish last
        double denied_s = 0; ///< grows while it is denied, up to twice the patience, and shrinks
        double waits_s = 0; ///< since it began to wait until its path home is clear; 0: it does not
        double waited_s = 0; ///< in which its wish was denied, since it arrived somewhere
    };
    /** What comes of a turn rate. */
    struct Trial
    {
        double rate_radps = 0;
        std::optional<Disc> disc; ///< none: it is not allowed
        int blocker = -1;         ///< whose disc is nearest, by what is required
        Departure passage = {};   ///< flown to its end; empty: the turn rate alone
    };

    [[nodiscard]] static std::size_t index(int uav) { return static_cast<std::size_t>(uav); }
    [[nodiscard]] static double gap_m(const Member& them, const Disc& disc);
    [[nodiscard]] std::vector<double> gaps_m(int uav, const Disc& disc) const;
    [[nodiscard]] std::vector<int> nearby(int uav) const;
    [[nodiscard]] Trial trial(int uav, const SafetyGuard& guard, const DubinsState& pose,
                              double rate_radps, const std::vector<double>& least_m) const;
    [[nodiscard]] std::vector<Point> pathAhead_m(int uav, const SafetyGuard& guard,
                                                 const DubinsState& pose, const Wish& wish) const;
    [[nodiscard]] Trial passage(int uav, const SafetyGuard& guard, const DubinsState& pose,
                                double rate_radps) const;
    [[nodiscard]] bool precedes(int first, int second) const;
    [[nodiscard]] int avoided(int uav, const std::vector<double>& gaps) const;
    [[nodiscard]] Point placeToAvoid_m(int other, const Point& from_m) const;
    [[nodiscard]] bool waitsOn(int uav) const;
    void note(int uav, const Trial& wished, const Wish& wish, double command_s);

    double m_separation_m;
    std::vector<Member> m_members; ///< by UAV
};

} // namespace berg
