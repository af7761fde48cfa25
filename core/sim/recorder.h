#pragma once

#include "core/sim/iceberg_rows.h"
#include "core/sim/plan_forecast.h"

#include <functional>
#include <string>
#include <vector>

namespace berg {

/**
 * What one re-planning tells one UAV, with what the solver said. Of several UAVs each has an event
 * of its own, one after another; the solve is that of all of them.
 */
struct PlanEvent
{
    double time_s = 0;
    int uav = 0;
    bool sameSolve = false; ///< the event before is of the same re-planning, for another UAV
    PlanReason reason = PlanReason::None;
    int target = -1;                         ///< index of the iceberg flown to; -1: circling
    std::vector<int> order;                  ///< iceberg indices
    std::vector<std::vector<int>> clusters;  ///< planned as one point each, two icebergs and more
    std::optional<int> thisSortie;           ///< so many of the order before going home; none: all
    std::vector<AimedLeg> legs;              ///< how it is flown; empty: straight to the target
    std::optional<double> predictedZeta_m2s; ///< what `legs` were judged by
    std::optional<AimedOutlook> outlook;     ///< of `legs`
    double zeta_m2s = 0;                     ///< Eq. (24) until then
    SolveStatus status = SolveStatus::None;
    StopReason stop = StopReason::Finished;
    AnswerSource source = AnswerSource::None;
    Criterion criterion = Criterion::Visitation; ///< what `objective` and `bound` measure
    double mu = 0;
    double objective = 0;
    std::optional<double> bound;
    std::optional<double> gap; ///< relative
    double distance_m = 0;
    double elapsed_s = 0; ///< of the solve; the one thing that differs between equal runs
    bool warmStarted = false;
    bool fellBack = false;
    bool interim = false; ///< the autopilot goes on with the last plan while the next one is made
    std::optional<PlanChange> change; ///< against the rest of the plan before, until the end; of
                                      ///< missions that keep a record
};

/** Whether it goes on with a search by plan: while the next plan is made, and where it orders the
 * places itself but its first leg has been overtaken. */
[[nodiscard]] inline bool keepsSearch(const PlanEvent& plan)
{
    return plan.interim || (plan.source == AnswerSource::Coverage && plan.target >= 0);
}

/** Whether it is one of `Metrics::replans`: not interim, and of several UAVs the first. */
[[nodiscard]] inline bool isReplan(const PlanEvent& plan)
{
    return !plan.interim && !plan.sameSolve;
}

/** The last one of them for the UAV; null: none. */
[[nodiscard]] const PlanEvent* lastPlanOf(std::span<const PlanEvent> plans, int uav);

/** The aim of the leg that the plan starts with, if it has any. */
[[nodiscard]] std::optional<AimedLeg> firstAim(const PlanEvent& plan);

/** One UAV at the instant of a sample. */
struct UavSample
{
    DubinsState pose;
    double u_radps = 0;
    double crossTrack_m = 0;
    double flown_m = 0; ///< through the air
    int target = -1;
    bool onGround = false;
};

[[nodiscard]] std::vector<UavSample> uavSamples(const WorldState& state);

/** UAVs and totals at one instant. */
struct Sample
{
    double time_s = 0;
    std::vector<UavSample> uavs;
    double sigmaSum_m2 = 0;
    double weightedSum_m2 = 0; ///< sigmas times their priorities; as `sigmaSum_m2` with no asset
    double zeta_m2s = 0;
    double flown_m = 0; ///< through the air, all UAVs
};

/** Takes a sample and the icebergs at its instant, by index. */
using SampleSink = std::function<void(const Sample&, std::span<const IcebergSample>)>;

/**
 * History of a mission: samples at a fixed interval (and at the last step), the state of every
 * iceberg at each of them, keyframes. Row `i` of icebergs belongs to sample `i`; an iceberg added
 * in flight has no entry in the rows before. Keyframes are bounded:
 * whenever they hold more than `kMostKeyframeTracks`, every other one goes, so that a flight twice
 * as long is looked back at with twice the time between them.
 */
class Recorder
{
public:
    /** Of all keyframes but the last, a UAV counted as two and a search as 70: about 60 MB, or 15
     * MB of a file. */
    static constexpr std::size_t kMostKeyframeTracks = 100'000;

    /** `interval_s` between samples, `keyframe_s` between keyframes; both rounded to steps. */
    Recorder(double interval_s, double keyframe_s, double dt_s);

    /** To be called at time 0 and after every step; keeps what is due. */
    void record(const Simulation& simulation);

    /** From now on samples are handed on and not kept; those that are kept already come first. */
    void handOn(SampleSink sink);

    [[nodiscard]] const std::vector<Sample>& samples() const { return m_samples; }
    /** Icebergs at sample `row`, by index; for many rows `reader` is faster. */
    [[nodiscard]] std::vector<IcebergSample> icebergs(std::size_t row) const
    {
        return reader().at(row);
    }
    /** Until the next sample is recorded. */
    [[nodiscard]] IcebergReader reader() const { return {m_rows, m_keyframes}; }
    /** From each of them the mission can be flown on, bit for bit; a plan may be due at once. The
     * first and the last that was due are always among them. */
    [[nodiscard]] const std::vector<Simulation>& keyframes() const { return m_keyframes; }

private:
    void keep(const Simulation& keyframe);

    std::int64_t m_sampleSteps;
    std::int64_t m_keyframeSteps;
    std::size_t m_keyframeCount = 0; ///< of all that were due
    std::size_t m_keyframeTracks = 0;
    std::size_t m_stride = 1;  ///< of each so many the first is kept
    bool m_wholeRowDue = true; ///< a keyframe was due since the last row
    std::vector<Sample> m_samples;
    IcebergRows m_rows;
    std::vector<Simulation> m_keyframes;
    SampleSink m_sink; ///< none: they are kept
};

} // namespace berg
