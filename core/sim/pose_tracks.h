#pragma once

#include "core/vehicle/dubins.h"

#include <optional>
#include <span>
#include <vector>

namespace berg {

/** Pose of a UAV at the end of a step, in place of the Dubins model. */
struct ExternalPose
{
    DubinsState pose;
    bool hasView = true; ///< False if nothing that the camera may show there counts as seen.
    /** True if the UAV was simulated up to the step before, so that it jumps to this pose. */
    bool isJump = false;
};

/** Pose of a UAV at one instant of a run, as reported by its aircraft or predicted for it. */
struct PoseFix
{
    double time_s = 0; ///< run time
    int uav = 0;       ///< index in the scenario
    DubinsState pose;
    /** False for a predicted pose, such as one without contact: then nothing counts as seen. */
    bool isMeasured = true;
    /** True if the flight up to this fix was simulated, so that no path leads to it. */
    bool isFirst = false;
    bool operator==(const PoseFix&) const = default;
};

/**
 * Paths of real aircraft, from which a mission takes the poses of UAVs. Between two fixes the pose
 * is interpolated. Before the first fix of a path and after the last one there is none, and the UAV
 * is simulated. The poses of a step depend on the fixes only, so that a replay repeats them.
 */
class PoseTracks
{
public:
    explicit PoseTracks(std::size_t uavs) : m_tracks(uavs) {}

    /**
     * Adds a fix of a flight that has been flown up to `now_s` and sets its `isFirst`. A fix that
     * is not later than `now_s` and the previous fix of its UAV is dropped, and so is one beyond
     * `kLargestCoordinate_m`, which a run file cannot hold. Throws `std::out_of_range` if there is
     * no such UAV.
     */
    void add(PoseFix fix, double now_s);
    /** Replaces all fixes by recorded ones, in the order of `all`. Throws as `add`. */
    void restore(std::span<const PoseFix> fixes);

    /**
     * Returns the poses by UAV at the end of the step of `step_s` that ends at `time_s`; it is
     * empty if no UAV has one.
     */
    [[nodiscard]] std::vector<std::optional<ExternalPose>> posesAt(double time_s,
                                                                   double step_s) const;
    /**
     * Returns the time up to which the flight can be flown: that of the last fix of the UAV whose
     * last fix is oldest, or nullopt without fixes. UAVs whose last fix is more than `kPatience_s`
     * older than the newest one are not waited for.
     */
    [[nodiscard]] std::optional<double> knownUntil_s() const;
    /**
     * Returns the fixes by UAV, those of each UAV in the order of time, up to its first one at or
     * after `until_s`: all that matter for a flight up to then.
     */
    [[nodiscard]] std::vector<PoseFix> until(double until_s) const;

    static constexpr double kPatience_s = 3;

private:
    std::vector<std::vector<PoseFix>> m_tracks; ///< by UAV, ascending times
};

} // namespace berg
