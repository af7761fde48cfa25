#pragma once

#include "core/vehicle/return_path.h"

#include <memory>
#include <span>
#include <utility>

namespace berg {

/** Slower autopilots do not come home for sure, nor can it be told when they must be gone. */
inline constexpr double kSlowestHoming_s = 1;

/** What the guard knows of its UAV. */
struct GuardedUav
{
    Motion motion;
    std::optional<SortieSpec> sortie;      ///< none: unlimited endurance
    std::shared_ptr<const Geofence> fence; ///< null: none
    CommandClock clock;
};

/** Where a UAV stands between two landings. */
struct SortieState
{
    bool isAloft = true;
    double aloft_s = 0;  ///< since take-off
    double ground_s = 0; ///< left to stand when it is not
    /** Endurance that plans leave unused, so that the UAV arrives in its recovery slot. */
    double withheld_s = 0;
    /** With fence and endurance: a proven path home from the next command on. */
    std::optional<ReturnPath> returnPath;
};

/**
 * What a UAV may be commanded: inside its fence, and so that it is home in time. State and wish in,
 * command out; it knows nothing of icebergs and plans. Keeps the clocks of the sortie and the
 * proven path home.
 */
class SafetyGuard
{
public:
    explicit SafetyGuard(GuardedUav uav) : m_uav(std::move(uav)) {}

    [[nodiscard]] const GuardedUav& uav() const { return m_uav; }
    [[nodiscard]] const SortieState& sortie() const { return m_sortie; }
    /** The fence is made anew for the wind. */
    void setWind(const Point& wind_mps);
    /** Made for the wind that blows; null: none from now on. */
    void setFence(std::shared_ptr<const Geofence> fence) { m_uav.fence = std::move(fence); }

    /**
     * From now on it can come home, although its endurance is unlimited, and is commanded no slower
     * than `kSlowestHoming_s`.
     */
    void needHome(const SortieSpec& home);

    /** The command for this wish, from now on; none: it has to go home, `homeCommand_radps`. */
    [[nodiscard]] std::optional<double> command_radps(const DubinsState& pose, double wished_radps);
    /**
     * Along the proven path; without one, which only a new wind or a bad start leaves, as well as
     * it goes. `maySearch`: for one, which takes long.
     */
    [[nodiscard]] double homeCommand_radps(const DubinsState& pose, bool maySearch);

    /** Looks for a path home from the next command on, whatever there was before; `u_radps` is held
     * until then, in time step `step`. */
    void proveReturn(const DubinsState& pose, double u_radps, std::int64_t step);
    /**
     * Endurance left when it would be home, flying there from the next command on; none: unlimited,
     * or on the ground. Below 0: home cannot be reached in time any more.
     */
    [[nodiscard]] std::optional<double> homeMargin_s(const DubinsState& pose, double u_radps,
                                                     std::int64_t step) const;
    /** Of this sortie; on the ground, of the next. There must be a limit. */
    [[nodiscard]] double enduranceLeft_s() const;
    /** Until the UAV has to be home for its recovery slot: `enduranceLeft_s` without one. */
    [[nodiscard]] double slotLeft_s() const { return enduranceLeft_s() - m_sortie.withheld_s; }
    /** Plans and returns reckon with so much less endurance, until it lands. */
    void withhold(double withheld_s) { m_sortie.withheld_s = withheld_s; }
    /** How many of the places, as they are now, can be visited in this order before home must be
     * reached; none: unlimited. */
    [[nodiscard]] std::optional<int> visitsInTime(const DubinsState& pose,
                                                  std::span<const MovingPlace> places) const;

    /** One time step of a UAV with a limited endurance; true: it ends in this step. */
    [[nodiscard]] bool tick();
    /** Whether a UAV on its way home lands between these places. */
    [[nodiscard]] bool isLanding(const Point& from_m, const Point& to_m) const;
    void land();
    /** The heading to start with; none: it would not come home, and tries again later. */
    [[nodiscard]] std::optional<double> takeOff(const DubinsState& pose);

    /**
     * The turn rate, or the one nearest to it that leaves room inside the fence: as there was room
     * before, there is one, round the circle that was inside. When rounding has used it up, the one
     * that leaves most. Outside the one that comes back.
     */
    [[nodiscard]] double limitedToFence_radps(const DubinsState& pose, double u_radps) const;
    [[nodiscard]] double backInside_radps(const DubinsState& pose) const;

    /** The path to a place that drifts, round the fence. */
    [[nodiscard]] std::optional<Path> pathTo(const DubinsState& from,
                                             const MovingPlace& place) const;
    /** How long the way home takes, with what the fence may add; needs a sortie. */
    [[nodiscard]] std::optional<double> timeHome_s(const DubinsState& from) const;
    /** Whether home can be reached within `left_s` after one command at this rate. */
    [[nodiscard]] bool homeInTimeAfter(const DubinsState& pose, double u_radps,
                                       double left_s) const;
    /** Turn rate that begins the way home. */
    [[nodiscard]] double homeRate_radps(const DubinsState& pose) const;

    /** A path home from there, however long; none: no one is known. */
    [[nodiscard]] std::optional<ReturnPath> returnPath(const DubinsState& pose) const
    {
        return search().anyPath(pose);
    }
    [[nodiscard]] double time_s(const ReturnPath& path) const
    {
        return static_cast<double>(path.commands()) * m_uav.clock.command_s();
    }
    /** The heading nearest to that of the pose with a path home within `left_s`; for take-off. */
    [[nodiscard]] std::optional<double> safeHeading_rad(const DubinsState& pose,
                                                        double left_s) const;

    /** The pose after so many time steps at this rate, bit for bit as it is flown. */
    [[nodiscard]] DubinsState heldFor(const DubinsState& pose, double u_radps,
                                      std::int64_t steps) const;

private:
    /** Whether a command may be given to a UAV with a fence and a limited endurance. */
    enum class Return
    {
        InTime,
        Late,   ///< there is a path home, which takes too long
        Unknown ///< none is known that stays inside
    };
    /** What a command leads to, and the path home from there. */
    struct Outlook
    {
        Return back = Return::Unknown;
        std::optional<ReturnPath> path; ///< `InTime` only
    };

    /** Whether the UAV has a fence and a home, so that a path home is proven at each command. */
    [[nodiscard]] bool provesReturn() const { return m_uav.fence && m_uav.sortie; }
    /** Whether a path home inside the fence is proven after one command at this rate. */
    [[nodiscard]] Outlook outlookAfter(const DubinsState& pose, double u_radps,
                                       double left_s) const;
    [[nodiscard]] std::optional<double> provenCommand_radps(const DubinsState& pose,
                                                            double wished_radps);
    [[nodiscard]] double roomAfter_m(const DubinsState& pose, double u_radps) const;
    [[nodiscard]] std::int64_t stepsHeld(std::int64_t step) const;
    [[nodiscard]] ReturnSearch search() const
    {
        return {*m_uav.fence, m_uav.clock, m_uav.sortie->home_m};
    }

    GuardedUav m_uav;
    SortieState m_sortie;
};

} // namespace berg
