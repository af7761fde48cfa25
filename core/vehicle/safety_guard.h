#pragma once

#include "core/vehicle/geofence.h"

#include <cstdint>

namespace berg {

/** What the guard knows of its UAV; all that is referred to outlives the guard. */
struct GuardedUav
{
    const Motion& motion;
    const std::optional<SortieSpec>& sortie; ///< none: unlimited endurance
    const Geofence* fence = nullptr;         ///< null: none
    double dt_s = 0;
    std::int64_t autopilotSteps = 1; ///< that one command is held
    double command_s = 0;            ///< the same in seconds
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

    /** The pose after so many time steps at this rate, bit for bit as it is flown. */
    [[nodiscard]] DubinsState heldFor(const DubinsState& pose, double u_radps,
                                      std::int64_t steps) const;

private:
    [[nodiscard]] double roomAfter_m(const DubinsState& pose, double u_radps) const;

    GuardedUav m_uav;
};

} // namespace berg
