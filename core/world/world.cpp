#include "core/world/world.h"

#include "core/scenario/initial_truth.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

/** Memory limit of the noise drawn in advance. */
constexpr std::size_t kMostNoise_bytes = 32'000'000;

std::shared_ptr<const ScenarioWorld> conditionsOf(const Scenario& scenario)
{
    auto conditions = std::make_shared<ScenarioWorld>();
    conditions->origin = scenario.origin;
    conditions->seed = scenario.seed;
    conditions->noise = scenario.noise;
    conditions->wind_mps = scenario.wind_mps;
    conditions->current_mps = scenario.current_mps;
    conditions->observer = scenario.observer;
    return conditions;
}

} // namespace

std::vector<DriftNoise> drawNoise(const Scenario& scenario)
{
    const std::size_t share =
        kMostNoise_bytes / sizeof(Point) / std::max<std::size_t>(1, scenario.icebergs.size());
    const auto seconds = static_cast<std::size_t>(std::ceil(scenario.duration_s)) + 1;
    std::vector<DriftNoise> noise;
    for (const Iceberg& iceberg : scenario.icebergs)
        noise.emplace_back(static_cast<std::uint64_t>(scenario.seed), iceberg.id,
                           scenario.noise && iceberg.track.empty() ? std::min(seconds, share) : 0);
    return noise;
}

World::World(const Scenario& scenario)
    : m_dt_s(scenario.dt_s)
    , m_lastStep(std::max<std::int64_t>(1, std::llround(scenario.duration_s / scenario.dt_s)))
    , m_stepsPerSecond(std::max<std::int64_t>(1, std::llround(1 / scenario.dt_s)))
    , m_seed(static_cast<std::uint64_t>(scenario.seed))
    , m_noise(scenario.noise)
    , m_observer(scenario.observer)
    , m_asset(scenario.asset)
    , m_conditions(conditionsOf(scenario))
    , m_weather(weatherOf(scenario))
{
    for (const Uav& uav : scenario.uavs)
        m_uavs.push_back(uav.id);
}

IcebergIndex World::add(const Iceberg& iceberg, DriftNoise noise, double start_s,
                        std::int64_t appearsStep)
{
    m_drift.emplace_back(trueDrift(*m_conditions, iceberg, m_weather, start_s), std::move(noise),
                         m_noise);
    m_forcing.push_back(forcingOf(m_weather, iceberg));
    m_appearsStep.push_back(appearsStep);
    const Track start = trackAtStart(*m_conditions, iceberg, m_weather, start_s);
    const auto assigned = std::ranges::find(m_uavs, iceberg.uav);
    m_parameters.push_back(
        {.stream = stableHash(iceberg.id + "/look"), // a new name would change every run
         .radius_m = iceberg.radius_m,
         .start = start,
         .assignedUav = iceberg.uav.empty() || assigned == m_uavs.end()
                            ? std::nullopt
                            : std::optional(static_cast<int>(assigned - m_uavs.begin()))});
    return IcebergIndex::of(m_parameters.size() - 1);
}

Point World::truth_m(IcebergIndex iceberg) const
{
    const DriftModel& drift = m_drift[toIndex(iceberg)];
    return drift.at(age(iceberg) >= 0 ? time_s() : drift.start_s());
}

void World::advanceDrift()
{
    for (std::size_t i = 0; i < m_drift.size(); ++i)
        if (m_appearsStep[i] <= m_step)
            m_drift[i].advanceTo(time_s());
}

void World::goTo(std::int64_t step)
{
    m_step = step;
    m_inSecond = step % m_stepsPerSecond;
    advanceDrift();
}

SampleDraw World::sampleDraw(IcebergIndex iceberg, std::int64_t sample) const
{
    return m_noise ? berg::sampleDraw(m_seed, parameters(iceberg).stream, sample) : SampleDraw{};
}

} // namespace berg
