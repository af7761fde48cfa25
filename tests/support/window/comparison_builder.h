#pragma once

#include "core/presets/presets.h"
#include "widgets/study/run_list.h"

namespace berg::test {

/** Returns planner settings for a policy. */
inline PlannerSettings policy(PolicyKind kind, double tau = 1)
{
    return {.policy = kind, .tau = tau};
}

/** Flies the scenario with these settings until `until_s`, in the calling thread. */
inline Mission flownWith(Scenario scenario, const PlannerSettings& planner, double until_s = 1e9)
{
    scenario.planner = planner;
    Mission mission(scenario);
    mission.advance(until_s);
    return mission;
}

inline FlightRecord flownRecord(const Scenario& scenario, const PlannerSettings& planner,
                                double until_s = 1e9)
{
    return recordOf(flownWith(scenario, planner, until_s));
}

/** Returns an iceberg that the scenarios do not have. */
inline Iceberg newIceberg()
{
    Iceberg iceberg;
    iceberg.id = "added";
    iceberg.position_m = Point(900, 1200);
    return iceberg;
}

/** Returns five minutes of a random scenario, which is flown quickly. */
inline Scenario shortScenario(int seed = 3)
{
    Scenario scenario = randomScenario(seed);
    scenario.duration_s = 300;
    return scenario;
}

/** Returns two runs with these values of zeta, one sample a second. */
inline RunComparison comparisonOf(const std::vector<double>& reference_m2s,
                                  const std::vector<double>& other_m2s)
{
    const auto run = [](const std::vector<double>& zeta_m2s, PolicyKind policy) {
        ComparedRun made{.planner = {.policy = policy}};
        for (const double zeta : zeta_m2s)
            made.samples.push_back(
                {.time_s = static_cast<double>(made.samples.size()), .zeta_m2s = zeta});
        made.flown_s = made.samples.back().time_s;
        made.scenario.duration_s = made.flown_s;
        made.metrics.zeta_m2s = zeta_m2s.back();
        return std::make_shared<const ComparedRun>(std::move(made));
    };
    RunComparison comparison{.reference = run(reference_m2s, PolicyKind::Visitation),
                             .other = run(other_m2s, PolicyKind::Tour)};
    comparison.until_s = std::min(comparison.reference->flown_s, comparison.other->flown_s);
    return comparison;
}

} // namespace berg::test
