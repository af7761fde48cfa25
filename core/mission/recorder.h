#pragma once

#include "core/mission/plan_forecast.h"
#include "core/sim/iceberg_history.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace berg {

/** Returns the last of the plans that the UAV flies, or null if there is none. */
[[nodiscard]] PlanPointer lastPlanOf(std::span<const PlanPointer> plans, int uav);

/** Returns the members of the target's cluster; none for a single iceberg or without a target. */
[[nodiscard]] std::span<const IcebergIndex> clusterOfTarget(const UavPlan& plan);

/**
 * Sends one UAV of the plan to its target. Searches by plan continue under an interim plan, and
 * under a coverage plan whose first aimed leg has been overtaken by a sighting.
 */
void startFlying(const Plan& plan, const UavPlan& own, Simulation& simulation);

/** One UAV at the instant of a sample. */
struct UavSample
{
    DubinsState pose;
    double u_radps = 0;
    double crossTrack_m = 0;
    double flown_m = 0;                 ///< distance flown through the air
    std::optional<IcebergIndex> target; ///< index of the target iceberg
    bool onGround = false;
};

/** Returns the recorded UAVs as samples, by UAV. */
[[nodiscard]] std::vector<UavSample> uavSamples(const WorldState& state);

/** UAVs and totals at one instant. */
struct Sample
{
    double time_s = 0;
    std::vector<UavSample> uavs;
    double sigmaSum_m2 = 0;
    /** Sum of sigma times priority; equals `sigmaSum_m2` without an asset. */
    double weightedSum_m2 = 0;
    double zeta_m2s = 0;
    double flown_m = 0; ///< distance flown through the air, all UAVs
};

/** Receives a sample and the icebergs at its instant, by index. */
using SampleSink = std::function<void(const Sample&, std::span<const IcebergSample>)>;

/**
 * History of a mission: samples at a fixed interval and at the last step, the state of every
 * iceberg at each sample, and keyframes. Row `i` of icebergs belongs to sample `i`; an iceberg
 * added in flight is missing in the rows before.
 * The number of keyframes is bounded: whenever they exceed `kMostKeyframeTracks`, every other one
 * is dropped, so a flight twice as long has twice the time between keyframes.
 */
class Recorder
{
public:
    /**
     * Limit on the tracks in all keyframes but the last, where a UAV counts as two and a search as
     * 70: about 60 MB of memory or 15 MB of a file.
     */
    static constexpr std::size_t kMostKeyframeTracks = 100'000;

    /** Sets the time between samples and between keyframes, s, both rounded to steps. */
    Recorder(double interval_s, double keyframe_s, double dt_s);

    /** Records what is due. Must be called at time 0 and after every step. */
    void record(const Simulation& simulation);

    /**
     * Passes samples to `sink` from now on in place of storing them. Samples stored so far are
     * passed first and then discarded.
     */
    void streamTo(SampleSink sink);

    [[nodiscard]] const std::vector<Sample>& samples() const { return m_samples; }
    /**
     * Returns the icebergs at sample `row`, by index. `reader` is faster for many rows. Throws
     * `std::out_of_range` if there is no such row.
     */
    [[nodiscard]] std::vector<IcebergSample> icebergs(std::size_t row) const
    {
        return reader().at(row);
    }
    /** Returns a reader, valid until the next sample is recorded. */
    [[nodiscard]] IcebergReader reader() const { return {m_rows, m_keyframes}; }
    /**
     * Returns the keyframes, ascending. A mission continued from any of them repeats bit for bit; a
     * plan may be due at once. The first keyframe and the last one due are always among them.
     */
    [[nodiscard]] const std::vector<Simulation>& keyframes() const { return m_keyframes; }

private:
    void keep(const Simulation& keyframe);

    std::int64_t m_sampleSteps;
    std::int64_t m_keyframeSteps;
    std::size_t m_keyframeCount = 0; ///< number of keyframes that were due
    std::size_t m_keyframeTracks = 0;
    std::size_t m_stride = 1;  ///< one of this many keyframes is stored
    bool m_snapshotDue = true; ///< true if a keyframe was due since the last row
    std::vector<Sample> m_samples;
    IcebergHistory m_rows;
    std::vector<Simulation> m_keyframes;
    SampleSink m_sink; ///< empty if samples are stored
};

} // namespace berg
