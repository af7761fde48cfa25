#pragma once

#include "core/vehicle/return_path.h"
#include "core/vehicle/wind_series.h"

#include <memory>
#include <span>
#include <utility>

namespace berg {

/**
 * Longest command interval with which a UAV is sure to come home in time, and for which the latest
 * time to head home can be calculated.
 */
inline constexpr double kSlowestHoming_s = 1;

/** Parameters of the UAV that a guard protects. */
struct GuardedUav
{
    Motion motion;
    std::optional<SortieSpec> sortie;      ///< nullopt means unlimited endurance
    std::shared_ptr<const Geofence> fence; ///< null means no fence
    CommandClock clock;
};

/** Progress of a UAV between two landings. */
struct SortieState
{
    bool isAloft = true;
    double aloft_s = 0;  ///< time since take-off
    double ground_s = 0; ///< remaining time on the ground, if not aloft
    /** Endurance that plans leave unused, so that the UAV arrives in its recovery slot. */
    double withheld_s = 0;
    /** Proven path home from the next command on; only for a UAV with both a fence and a home. */
    std::optional<ReturnPath> returnPath;
};

/**
 * Limits the commands of one UAV so that it stays inside its fence and is home in time. It takes
 * the state and the requested turn rate and returns a command; it does not depend on icebergs or
 * plans. It keeps the clocks of the sortie and the proven path home.
 */
class SafetyGuard
{
public:
    explicit SafetyGuard(GuardedUav uav) : m_uav(std::move(uav)) {}

    [[nodiscard]] const GuardedUav& uav() const { return m_uav; }
    [[nodiscard]] const SortieState& sortie() const { return m_sortie; }
    /**
     * Sets a wind that will not change, and rebuilds the fence for it. The proven path home must be
     * proven again.
     */
    void setWind(const Point& wind_mps);
    /**
     * Sets the wind of now and what is known of the wind to come, none of it stronger than
     * `windLimit_mps`. From then on the way home counts with the worst wind between now and the end
     * of the endurance (`timeHome_s`). Returns whether the wind has changed: the proven path home
     * must then be proven again before it is flown.
     */
    bool followWind(const WindAhead& wind, double windLimit_mps);
    /** Sets the landing place of a UAV with a sortie. The path home must be proven again. */
    void setHome(const Point& home_m)
    {
        if (m_uav.sortie)
            m_uav.sortie->home_m = home_m;
    }
    /** Replaces the fence; it must be made for the present wind. Null removes the fence. */
    void setFence(std::shared_ptr<const Geofence> fence) { m_uav.fence = std::move(fence); }

    /**
     * Makes a UAV with unlimited endurance able to return to `home`, and limits its command
     * interval to `kSlowestHoming_s`. Does nothing if it has a home.
     */
    void requireHome(const SortieSpec& home);

    /**
     * Returns the command for the requested turn rate, rad/s. Returns nullopt if the UAV has to
     * return now: fly `homeCommand_radps` instead.
     */
    [[nodiscard]] std::optional<double> command_radps(const DubinsState& pose,
                                                      double requested_radps);
    /**
     * Returns the next command along the proven path home, rad/s. Without such a path (no fence, or
     * after a change of wind or a bad start), it steers home as well as the fence allows;
     * `maySearch` permits a search for a path first, which takes milliseconds. Requires a sortie.
     */
    [[nodiscard]] double homeCommand_radps(const DubinsState& pose, bool maySearch);

    /**
     * Replaces the proven path home by one from the next command on, or clears it if none is found.
     * `u_radps` is held until then; `step` is the present time step.
     */
    void proveReturn(const DubinsState& pose, double u_radps, std::int64_t step);
    /**
     * Returns the endurance, s, that would be left on arrival if the UAV flew home from the next
     * command on; negative if it cannot be home in time, minus the whole endurance if the wind is
     * too strong to come home. Returns nullopt if the endurance is unlimited or the UAV is on the
     * ground.
     */
    [[nodiscard]] std::optional<double> homeMargin_s(const DubinsState& pose, double u_radps,
                                                     std::int64_t step) const;
    /**
     * Returns the endurance, s, left of this sortie, or of the next one if on the ground. Requires
     * a sortie.
     */
    [[nodiscard]] double enduranceLeft_s() const;
    /**
     * Returns the time, s, until the UAV has to be home for its recovery slot: `enduranceLeft_s`
     * without one.
     */
    [[nodiscard]] double slotLeft_s() const { return enduranceLeft_s() - m_sortie.withheld_s; }
    /** Reduces the endurance for plans and returns by `withheld_s` until the UAV lands. */
    void withhold(double withheld_s) { m_sortie.withheld_s = withheld_s; }
    /**
     * Returns how many of the places, in this order from their present positions, can be visited
     * before the UAV has to be home, with `kHomeReserve_s` and `kVisitReserve_s` to spare. Returns
     * nullopt if the endurance is unlimited.
     */
    [[nodiscard]] std::optional<int> visitsInTime(const DubinsState& pose,
                                                  std::span<const MovingPlace> places) const;

    /**
     * Advances the clocks of a UAV with a limited endurance by one time step; returns whether the
     * endurance ends in this step, in flight. Requires a sortie.
     */
    [[nodiscard]] bool tick();
    /**
     * Returns whether a returning UAV lands between these places: the line passes home within
     * `kLandingRadius_m`. Requires a sortie.
     */
    [[nodiscard]] bool isLanding(const Point& from_m, const Point& to_m) const;
    /**
     * Starts the turnaround, ends `withhold` and clears the path home. Requires a sortie.
     */
    void land();
    /**
     * Starts the sortie and returns the heading psi to take off with, rad. Returns nullopt if a
     * fence leaves no heading with a path home in time; the UAV then stays on the ground for
     * another minute. Without a fence it is the heading of the pose. Requires a sortie.
     */
    [[nodiscard]] std::optional<double> takeOff(const DubinsState& pose);

    /**
     * Returns `u_radps`, or the nearest turn rate that keeps the UAV inside the fence: if there was
     * clearance before, a rate that circles inside exists. If rounding has used up the clearance,
     * returns the rate that leaves the most clearance. Outside the fence, returns
     * `backInside_radps`; without one, `u_radps`.
     */
    [[nodiscard]] double limitedToFence_radps(const DubinsState& pose, double u_radps) const;
    /** Returns the turn rate, rad/s, that steers to the nearest place inside. Requires a fence. */
    [[nodiscard]] double backInside_radps(const DubinsState& pose) const;

    /**
     * Returns the path to a drifting place, round the fence if there is one; nullopt if the place
     * may outrun the UAV.
     */
    [[nodiscard]] std::optional<Path> pathTo(const DubinsState& from,
                                             const MovingPlace& place) const;
    /**
     * Returns the time, s, of the path home, with one circle added for the fence. In a changing
     * wind it is the longest that any wind within the range of the forecast until the end of the
     * endurance gives: speed over ground on a course is a concave function of the wind, so one of
     * the corners of that range is the worst, and no flight that aims at home takes longer. The
     * drift during the first turn is added. With a fence, whose paths bend, the time in the wind
     * of now is multiplied by the largest loss of speed on any course. Requires a sortie. Returns
     * nullopt if the wind is too strong.
     */
    [[nodiscard]] std::optional<double> timeHome_s(const DubinsState& from) const;
    /**
     * Returns whether `timeHome_s` is at most `left_s`; quicker, because bounds of the paths often
     * answer. Requires a sortie.
     */
    [[nodiscard]] bool isHomeWithin(double left_s, const DubinsState& from) const;
    /**
     * Returns whether the UAV can be home within `left_s` from now, with `kHomeReserve_s` to spare,
     * if it first flies one command at this rate, whose duration counts. With a fence the time
     * includes one circle (`timeHome_s`). Requires a sortie.
     */
    [[nodiscard]] bool homeInTimeAfter(const DubinsState& pose, double u_radps,
                                       double left_s) const;
    /**
     * Returns the turn rate, rad/s, of the next command on the path home; 0 if there is none.
     * Requires a sortie.
     */
    [[nodiscard]] double homeRate_radps(const DubinsState& pose) const;

    /**
     * Returns a path home inside the fence from there, of any duration, or nullopt if none is
     * found. Requires a fence and a sortie.
     */
    [[nodiscard]] std::optional<ReturnPath> returnPath(const DubinsState& pose) const
    {
        return search().anyPath(pose);
    }
    /** Returns the duration of a path home, s. */
    [[nodiscard]] double time_s(const ReturnPath& path) const
    {
        return static_cast<double>(path.commands()) * m_uav.clock.command_s();
    }
    /**
     * Returns the heading nearest to that of the pose from which a path home within `left_s`
     * exists with `kHomeReserve_s` to spare, for take-off; nullopt if none is found. Requires a
     * fence and a sortie.
     */
    [[nodiscard]] std::optional<double> safeHeading_rad(const DubinsState& pose,
                                                        double left_s) const;

    /** Returns the pose after `steps` time steps at this rate, bit for bit as it is flown. */
    [[nodiscard]] DubinsState heldFor(const DubinsState& pose, double u_radps,
                                      std::int64_t steps) const;

private:
    /** Verdict on a command for a UAV with a fence and a limited endurance. */
    enum class Return
    {
        InTime,
        Late,   ///< a path home exists but takes too long
        Unknown ///< no path home inside the fence is known
    };
    /** Consequence of a command, and the path home after it. */
    struct Outlook
    {
        Return back = Return::Unknown;
        std::optional<ReturnPath> path; ///< set for `InTime` only
    };

    /**
     * Returns whether the UAV has a fence and a home, so that a path home is proven at each
     * command.
     */
    [[nodiscard]] bool provesReturn() const { return m_uav.fence && m_uav.sortie; }
    /** Returns whether a path home within `left_s` is proven after one command at this rate. */
    [[nodiscard]] Outlook outlookAfter(const DubinsState& pose, double u_radps,
                                       double left_s) const;
    [[nodiscard]] std::optional<double> provenCommand_radps(const DubinsState& pose,
                                                            double requested_radps);
    [[nodiscard]] double clearanceAfter_m(const DubinsState& pose, double u_radps) const;
    [[nodiscard]] std::int64_t stepsHeld(std::int64_t step) const;
    [[nodiscard]] ReturnSearch search() const
    {
        return {*m_uav.fence, m_uav.clock, m_uav.sortie->home_m};
    }

    void weighWind();
    /** Returns the time, s, of a path home in the worst wind to come. */
    [[nodiscard]] double worstTime_s(double time_s) const
    {
        return time_s * m_slowdown + m_turnDrift_s;
    }

    GuardedUav m_uav;
    SortieState m_sortie;
    WindAhead m_ahead;           ///< set if the wind changes
    std::vector<Motion> m_worst; ///< winds at the corners of the range; empty if it is constant
    double m_longestTurn_s = 0;  ///< `longestPath_s` of no distance in the worst of `m_worst`
    double m_slowest_mps = 0;    ///< least speed over ground in any of `m_worst`, 0 if it is empty
    double m_slowdown = 1;       ///< largest ratio of the speed over ground to the least to come
    double m_turnDrift_s = 0;    ///< time lost by drifting during the first turn
};

} // namespace berg
