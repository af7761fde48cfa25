#pragma once

#include "core/mission/plan_forecast.h"
#include "core/sim/iceberg_history.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace berg {

/**
 * One plan for one UAV, with the figures of its solve. When several UAVs are planned together, each
 * has an event of its own, one after another, and all share the solve.
 */
struct PlanEvent
{
    double time_s = 0;
    int uav = 0;
    bool sameSolve = false; ///< the previous event is of the same solve, for another UAV
    /** Reason for which this UAV needed the plan. */
    PlanReason reason = PlanReason::None;
    std::optional<int> target; ///< index of the iceberg to fly to; nullopt to circle
    std::vector<int> order;    ///< indices of the icebergs in visiting order
    /** Groups of two or more icebergs planned as one point. */
    std::vector<std::vector<int>> clusters;
    /**
     * Number of icebergs visited before the UAV turns home; nullopt if the endurance is unlimited.
     */
    std::optional<int> thisSortie;
    std::vector<AimedLeg> legs;              ///< aimed legs; empty means straight to the target
    std::optional<double> predictedZeta_m2s; ///< predicted zeta by which `legs` were chosen
    std::optional<AimedOutlook> outlook;     ///< predicted sightings on `legs`
    std::vector<PlannedVisit> laterVisits;   ///< as in `UavAnswer`; run files leave them out
    double zeta_m2s = 0;                     ///< Eq. (24) up to this instant
    SolveStatus status = SolveStatus::None;
    StopReason stop = StopReason::Finished;
    AnswerSource source = AnswerSource::None;
    Criterion criterion = Criterion::Visitation; ///< unit of `objective` and `bound`
    double mu = 0;
    double objective = 0;
    std::optional<double> bound;
    std::optional<double> gap; ///< relative gap
    /** Length of the whole plan in the distances of the request, m. */
    double distance_m = 0;
    /** Wall-clock time of the solve; the only member that differs between equal runs. */
    double elapsed_s = 0;
    bool warmStarted = false;
    /** True if the planner failed and the previous plan is continued. */
    bool fellBack = false;
    /** True for the rest of the previous plan, flown while the next one is being made. */
    bool interim = false;
    /** Comparison with the rest of the previous plan, to the end of the run; only with a record. */
    std::optional<PlanChange> change;
};

/**
 * Returns true if searches by plan continue under this plan: it is interim, or a coverage plan
 * whose first aimed leg has been overtaken by a sighting.
 */
[[nodiscard]] inline bool keepsSearch(const PlanEvent& plan)
{
    return plan.interim || (plan.source == AnswerSource::Coverage && plan.target);
}

/**
 * Returns true if the plan counts in `Metrics::replans`: it is not interim, and the first of its
 * solve.
 */
[[nodiscard]] inline bool isReplan(const PlanEvent& plan)
{
    return !plan.interim && !plan.sameSolve;
}

/** Returns the last of the plans that is for the UAV, or null if there is none. */
[[nodiscard]] const PlanEvent* lastPlanOf(std::span<const PlanEvent> plans, int uav);

/** Returns the members of the target's cluster; none for a single iceberg or without a target. */
[[nodiscard]] std::span<const int> clusterOfTarget(const PlanEvent& plan);

/** Returns the aim of the plan's first leg, or nullopt if it has no aimed legs. */
[[nodiscard]] std::optional<AimedLeg> firstAim(const PlanEvent& plan);

/** One UAV at the instant of a sample. */
struct UavSample
{
    DubinsState pose;
    double u_radps = 0;
    double crossTrack_m = 0;
    double flown_m = 0;        ///< distance flown through the air
    std::optional<int> target; ///< index of the target iceberg
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
