#include "core/mission/recorder.h"

#include "core/sim/clusters.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace berg {

namespace {

/** Number of tracks of a keyframe that take as much of a file as one search. */
constexpr std::size_t kSearchTracks = 70;

double weightedSum_m2(const Simulation& simulation)
{
    if (!simulation.world().asset())
        return simulation.observer().sigmaSum_m2();
    double sum_m2 = 0;
    for (const IcebergIndex i : simulation.icebergs())
        if (simulation.active(i))
            sum_m2 += priority(simulation.observer(), i) * simulation.track(i).sigma_m2;
    return sum_m2;
}

std::int64_t stepsOf(double interval_s, double dt_s)
{
    return std::max<std::int64_t>(1, std::llround(interval_s / dt_s));
}

} // namespace

PlanPointer lastPlanOf(std::span<const PlanPointer> plans, int uav)
{
    for (std::size_t i = plans.size(); i-- > 0;)
        if (plans[i]->of(uav) != nullptr)
            return plans[i];
    return nullptr;
}

std::span<const IcebergIndex> clusterOfTarget(const UavPlan& plan)
{
    return plan.target() ? clusterWith(plan.clusters, *plan.target())
                         : std::span<const IcebergIndex>();
}

void startFlying(const Plan& plan, const UavPlan& own, Simulation& simulation)
{
    const bool isCoverage = plan.outcome.source == AnswerSource::Coverage;
    simulation.setTarget(own.uav, own.target(),
                         own.legs.empty() ? std::nullopt : std::optional(own.legs.front()),
                         clusterOfTarget(own), plan.interim || (isCoverage && own.target()));
}

Recorder::Recorder(double interval_s, double keyframe_s, double dt_s)
    : m_sampleSteps(stepsOf(interval_s, dt_s)), m_keyframeSteps(stepsOf(keyframe_s, dt_s))
{
}

std::vector<UavSample> uavSamples(const WorldState& state)
{
    std::vector<UavSample> samples;
    samples.reserve(state.uavs.size());
    for (const UavState& uav : state.uavs)
        samples.push_back({.pose = uav.pose,
                           .u_radps = uav.u_radps,
                           .crossTrack_m = uav.crossTrack_m,
                           .flown_m = uav.flown_m,
                           .target = uav.target,
                           .onGround = uav.mode == FlightMode::Ground});
    return samples;
}

/**
 * Stores a keyframe and thins them out. Strides are powers of two, so keyframes stored earlier
 * remain among those stored later.
 */
void Recorder::keep(const Simulation& keyframe)
{
    if (!m_keyframes.empty() && (m_keyframeCount - 1) % m_stride != 0)
        m_keyframes.pop_back(); // it was stored only as the last one
    m_keyframes.push_back(keyframe);
    m_snapshotDue = m_snapshotDue || m_keyframeCount % m_stride == 0;
    ++m_keyframeCount;
    m_keyframeTracks += toIndex(keyframe.icebergCount() + 2 * keyframe.uavCount()) +
                        kSearchTracks * keyframe.observer().searches().count();
    const std::size_t stride = std::bit_ceil(m_keyframeTracks / kMostKeyframeTracks + 1);
    if (stride == m_stride)
        return;
    const std::size_t last = m_keyframes.size() - 1;
    std::size_t i = 0;
    std::erase_if(m_keyframes, [&](const Simulation&) {
        const std::size_t at = i++;
        return at * m_stride % stride != 0 && at != last;
    });
    m_stride = stride;
}

void Recorder::record(const Simulation& simulation)
{
    const bool last = simulation.finished();
    if (last || simulation.step() % m_keyframeSteps == 0)
        keep(simulation);
    if (!last && simulation.step() % m_sampleSteps != 0)
        return;
    const WorldState state = simulation.state();
    Sample sample{.time_s = simulation.time_s(),
                  .uavs = uavSamples(state),
                  .sigmaSum_m2 = state.sigmaSum_m2,
                  .weightedSum_m2 = weightedSum_m2(simulation),
                  .zeta_m2s = state.zeta_m2s,
                  .flown_m = state.flown_m()};
    if (m_sink) {
        m_sink(sample, icebergsOf(simulation));
        return;
    }
    m_samples.push_back(std::move(sample));
    m_rows.add(simulation, std::exchange(m_snapshotDue, false));
}

void Recorder::streamTo(SampleSink sink)
{
    m_sink = std::move(sink);
    IcebergReader rows = reader();
    for (std::size_t row = 0; row < m_samples.size(); ++row)
        m_sink(m_samples[row], rows.at(row));
    m_samples.clear();
    m_rows = {};
}

} // namespace berg
