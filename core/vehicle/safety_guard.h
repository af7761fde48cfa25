#pragma once

#include "core/vehicle/return_path.h"

namespace berg {

/** What the guard knows of its UAV; all that is referred to outlives the guard. */
struct GuardedUav
{
    const Motion& motion;
    const std::optional<SortieSpec>& sortie; ///< none: unlimited endurance
    const Geofence* fence = nullptr;         ///< null: none
    CommandClock clock;
};

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

/**
 * What a UAV may be commanded: inside its fence, and so that it is home in time. State and wish in,
 * command out; it knows nothing of icebergs and plans. Cheap: made anew for each command.
 */
class SafetyGuard
{
public:
    explicit SafetyGuard(const GuardedUav& uav) : m_uav(uav) {}

    /**
     * The turn rate, or the one nearest to it that leaves room inside the fence: as there was room
     * before, there is one, round the circle that was inside. When rounding has used it up, the one
     * that leaves most.
     */
    [[nodiscard]] double limitedToFence_radps(const DubinsState& pose, double u_radps) const;

    /** The path to a place that drifts, round the fence. */
    [[nodiscard]] std::optional<Way> wayTo(const DubinsState& from, const MovingPlace& place) const;
    /** How long the way home takes, with what the fence may add; needs a sortie. */
    [[nodiscard]] std::optional<double> timeHome_s(const DubinsState& from) const;
    /** Whether home can be reached within `left_s` after one command at this rate. */
    [[nodiscard]] bool homeInTimeAfter(const DubinsState& pose, double u_radps,
                                       double left_s) const;
    /** Turn rate that begins the way home. */
    [[nodiscard]] double homeRate_radps(const DubinsState& pose) const;

    /** Whether the UAV has a fence and a home, so that a path home is proven at each command. */
    [[nodiscard]] bool provesReturn() const
    {
        return m_uav.fence != nullptr && m_uav.sortie.has_value();
    }
    /** Whether a path home inside the fence is proven after one command at this rate. */
    [[nodiscard]] Outlook outlookAfter(const DubinsState& pose, double u_radps,
                                       double left_s) const;
    /** A path home from there, however long; none: no one is known. */
    [[nodiscard]] std::optional<ReturnPath> returnPath(const DubinsState& pose) const;
    [[nodiscard]] double time_s(const ReturnPath& path) const;
    /** The heading nearest to that of the pose with a path home within `left_s`; for take-off. */
    [[nodiscard]] std::optional<double> safeHeading_rad(const DubinsState& pose,
                                                        double left_s) const;

    /** The pose after so many time steps at this rate, bit for bit as it is flown. */
    [[nodiscard]] DubinsState heldFor(const DubinsState& pose, double u_radps,
                                      std::int64_t steps) const;

private:
    [[nodiscard]] double roomAfter_m(const DubinsState& pose, double u_radps) const;
    [[nodiscard]] ReturnSearch search() const;

    GuardedUav m_uav;
};

} // namespace berg
