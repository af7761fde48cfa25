#include "core/study/study.h"

#include <algorithm>
#include <set>

namespace berg {

namespace {

struct Setting
{
    PolicyKind policy;
    std::optional<double> tau;
};

std::vector<Setting> settingsOf(const SweepSpec& spec)
{
    std::vector<Setting> settings;
    for (const PolicyKind policy : spec.policies)
        if (policy == PolicyKind::Visitation)
            for (const double tau : spec.taus)
                settings.push_back({policy, tau});
    for (const PolicyKind policy : spec.policies)
        if (policy != PolicyKind::Visitation)
            settings.push_back({policy, std::nullopt});
    return settings;
}

struct CaseResult
{
    Metrics metrics;
    bool stuck = false;
};

CaseResult fly(const Scenario& scenario, const MissionOptions& options)
{
    Mission mission(scenario, options);
    mission.advance(scenario.duration_s);
    std::set<int> targets;
    for (const PlanEvent& plan : mission.plans())
        if (plan.time_s >= scenario.duration_s / 2 && plan.target >= 0) // -1: circling
            targets.insert(plan.target);
    return {.metrics = mission.metrics(), .stuck = targets.size() <= 2};
}

} // namespace

std::int64_t seedOfRun(std::int64_t seed, int run)
{
    if (run == 0)
        return seed;
    Random random(static_cast<std::uint64_t>(seed), static_cast<std::uint64_t>(run));
    return static_cast<std::int64_t>(random.bits() >> 11U);
}

std::size_t missionCount(const SweepSpec& spec)
{
    return settingsOf(spec).size() * spec.scenarios.size() * static_cast<std::size_t>(spec.runs);
}

SweepResult sweep(const SweepSpec& spec, const ParallelOptions& parallel)
{
    const std::vector<Setting> settings = settingsOf(spec);
    const std::size_t cases = spec.scenarios.size() * static_cast<std::size_t>(spec.runs);
    MissionOptions options = spec.options;
    options.record = false;

    std::vector<CaseResult> results(settings.size() * cases);
    const auto flyOne = [&](std::size_t i) {
        const Setting& setting = settings[i / cases];
        const std::size_t run = i % static_cast<std::size_t>(spec.runs);
        Scenario scenario = spec.scenarios[i % cases / static_cast<std::size_t>(spec.runs)];
        scenario.seed = seedOfRun(scenario.seed, static_cast<int>(run));
        scenario.planner.policy = setting.policy;
        scenario.planner.tau = setting.tau.value_or(scenario.planner.tau);
        results[i] = fly(scenario, options);
    };

    SweepResult result;
    result.complete = forEachIndex(results.size(), flyOne, parallel);
    if (!result.complete)
        return result;
    for (std::size_t s = 0; s < settings.size(); ++s) {
        SweepRow row{.policy = settings[s].policy, .tau = settings[s].tau};
        double stuck = 0;
        for (std::size_t c = 0; c < cases; ++c) {
            const CaseResult& one = results[s * cases + c];
            row.zeta_m2s.push_back(one.metrics.zeta_m2s);
            row.visits.push_back(one.metrics.visits);
            stuck += one.stuck ? 1 : 0;
        }
        row.summary = summarise(row.zeta_m2s);
        row.stuckShare = cases > 0 ? stuck / static_cast<double>(cases) : 0;
        result.rows.push_back(std::move(row));
    }
    return result;
}

} // namespace berg
