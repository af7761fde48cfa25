#pragma once

#include "core/sim/departure.h"

#include <limits>

namespace berg {

/**
 * Keeps UAVs of one altitude layer at the separation from each other: takes desired turn rates and
 * returns permitted ones.
 *
 * Each UAV aloft has a reserved disc in which it can circle over ground for ever. The discs of two
 * UAVs of one layer are at least the separation apart. A UAV only gets a command after which a disc
 * tangent to its course, left or right, is clear of all others and inside its fence; otherwise it
 * continues round its present disc. UAVs that start apart therefore stay apart whatever turns they
 * request (generalized roundabout policy, Pallottino et al. 2007). Commands are computed in the
 * order of the fleet. UAVs that start too close get no command that brings them closer.
 *
 * UAVs that start too close depart together (`departuresOf`): after two of them have reached the
 * separation, they keep it.
 *
 * If two UAVs block each other, one waits and yields after `kPatience_s`: see `precedes`. UAVs that
 * rank after one flying home also keep clear of the path ahead of it.
 */
class Separation
{
public:
    /** The turn that an autopilot commands, and its purpose. */
    struct DesiredTurn
    {
        double rate_radps = 0;
        std::optional<Point> home_m; ///< landing place if the UAV flies home
        std::optional<double> due_s; ///< run time by which the UAV must be home, s
        bool hasGoal = true;         ///< true if it flies to a target or home
    };

    /**
     * All UAVs start on the ground. `altitudes_m` is by UAV. A separation of 0 disables the rule.
     */
    Separation(double separation_m, const std::vector<double>& altitudes_m);

    /** Returns true if another UAV shares the layer and a separation is set. */
    [[nodiscard]] bool concerns(int uav) const { return m_members[index(uav)].isConcerned; }
    /** Returns true if the two UAVs fly in the same altitude layer. */
    [[nodiscard]] bool shareLayer(int a, int b) const;
    /** Sets the UAV's motion. Must be called first, and again for each new wind. */
    void setMotion(int uav, const SafetyGuard& guard);
    /** Marks the UAV as aloft at `pose`, whether or not there is room. */
    void enter(int uav, const SafetyGuard& guard, const DubinsState& pose);
    /** Marks the UAV as landed. */
    void leave(int uav);
    /**
     * Plans departures at the start of a flight for UAVs that are too close to each other, where
     * such departures exist. Every UAV must have entered.
     */
    void depart(std::span<const Departing> fleet);
    /** Returns true if the UAV has room at the place on any course. */
    [[nodiscard]] bool hasRoom(int uav, const Point& place_m) const;
    /** Returns the turn rate, rad/s, to fly until the UAV's next command. */
    [[nodiscard]] double command_radps(int uav, const SafetyGuard& guard, const DubinsState& pose,
                                       const DesiredTurn& desired);
    /** Records that the UAV reached its target, which resets its waiting time. */
    void arrive(int uav) { m_members[index(uav)].waited_s = 0; }

private:
    static constexpr double kFar = std::numeric_limits<double>::infinity();

    struct Disc
    {
        Point middle_m;
        /** Contains the UAV until its next command and permanently if it circles. */
        double radius_m = 0;
        double side = 1; ///< side of the UAV on which the disc lies: 1 left, -1 right
    };
    struct Member
    {
        double altitude_m = 0;
        bool isConcerned = false;
        double radius_m = 0;           ///< radius of the disc in which it holds
        std::optional<Disc> disc;      ///< nullopt on the ground
        Point place_m = Point::Zero(); ///< position at its last command
        /**
         * Run time by which it must be home, as it was when it set out: this fixes the order of
         * landing. Nullopt while it does not fly home.
         */
        std::optional<double> due_s;
        Departure departure; ///< rest of the present departure or passage
        /** Path home ahead; UAVs that rank after it keep clear of this path as of its disc. */
        std::vector<Point> ahead_m;
        std::optional<int> blocker; ///< UAV that last blocked its desired turn
        /**
         * Grows while its desired turn is denied, up to twice the patience, and shrinks otherwise.
         */
        double denied_s = 0;
        /** Time for which it has waited for its path home to be clear; 0 while it does not wait. */
        double waits_s = 0;
        double waited_s = 0; ///< time for which it was denied since its last arrival
    };
    /** Outcome of a turn rate. */
    struct Trial
    {
        double rate_radps = 0;
        std::optional<Disc> disc = {};   ///< nullopt if the turn rate is not permitted
        std::optional<int> blocker = {}; ///< UAV whose disc lacks the most distance
        Departure passage = {}; ///< passage to fly to its end; empty for the turn rate alone
    };

    [[nodiscard]] static std::size_t index(int uav) { return static_cast<std::size_t>(uav); }
    [[nodiscard]] static double gap_m(const Member& them, const Disc& disc);
    [[nodiscard]] std::vector<double> gaps_m(int uav, const Disc& disc) const;
    [[nodiscard]] std::vector<int> nearby(int uav) const;
    [[nodiscard]] Trial trial(int uav, const SafetyGuard& guard, const DubinsState& pose,
                              double rate_radps, const std::vector<double>& least_m) const;
    [[nodiscard]] std::vector<Point> pathAhead_m(int uav, const SafetyGuard& guard,
                                                 const DubinsState& pose,
                                                 const DesiredTurn& desired) const;
    [[nodiscard]] Trial passage(int uav, const SafetyGuard& guard, const DubinsState& pose,
                                double rate_radps) const;
    [[nodiscard]] bool precedes(int first, int second) const;
    [[nodiscard]] std::optional<int> avoided(int uav, const std::vector<double>& gaps) const;
    [[nodiscard]] Point placeToAvoid_m(int other, const Point& from_m) const;
    [[nodiscard]] bool waitsOn(int uav) const;
    void note(int uav, const Trial& result, const DesiredTurn& desired, double command_s);

    double m_separation_m;
    std::vector<Member> m_members; ///< by UAV
};

} // namespace berg
