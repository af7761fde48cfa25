#include "widgets/study/study_estimate.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <thread>

namespace berg {
namespace {

constexpr double kStep_s = 1.5e-7; ///< CPU time of a step of the UAV
constexpr double kTrack_s = 2e-8;  ///< CPU time of an iceberg in a step
constexpr double kBetweenPlans_s = 20;
/** Plans of `coverage`: aimed legs in runs of this length at most, patrols in longer ones. */
constexpr double kLongestOfLegs_s = 1000;
constexpr double kFirstLegs_s = 0.2;
constexpr double kNextLegs_s = 0.005;
constexpr double kFirstPatrol_s = 0.5;

/** CPU time of one plan. */
struct PlanCost
{
    double icebergs;
    double cpu_s;
};
constexpr PlanCost kVisitation[] = {{4, 5e-6},  {12, 5e-5}, {16, 5e-4}, {20, 1.2e-3},
                                    {30, 6e-3}, {40, 3e-2}, {60, 0.2},  {100, 1}};
constexpr PlanCost kLatency[] = {{4, 5e-6},  {12, 8e-5}, {16, 2e-3}, {20, 5e-3},
                                 {30, 5e-2}, {40, 0.2},  {60, 1},    {100, 1}};

constexpr PlanCost kNextPatrol[] = {{40, 9e-3}, {100, 1.8e-2}, {300, 4e-2}};

/** Interpolates linearly in the logarithms between the rows of the table; constant beyond them. */
double costOf(std::span<const PlanCost> table, double icebergs)
{
    const auto after = std::find_if(table.begin(), table.end(), [icebergs](const PlanCost& row) {
        return row.icebergs >= icebergs;
    });
    if (after == table.begin())
        return table.front().cpu_s;
    if (after == table.end())
        return table.back().cpu_s;
    const PlanCost& before = *(after - 1);
    const double t =
        std::log(icebergs / before.icebergs) / std::log(after->icebergs / before.icebergs);
    return before.cpu_s * std::pow(after->cpu_s / before.cpu_s, t);
}

double planning_s(PolicyKind policy, double icebergs, double duration_s)
{
    const PolicyTraits& traits = traitsOf(policy);
    double plans = duration_s / kBetweenPlans_s;
    if (traits.method == PolicyMethod::PredictedZeta)
        return duration_s <= kLongestOfLegs_s
                   ? kFirstLegs_s + plans * kNextLegs_s
                   : kFirstPatrol_s + plans * costOf(kNextPatrol, icebergs);
    if (!traits.solves())
        return 0;
    if (traits.replanRule == ReplanRule::ToItsEnd)
        plans = 1 + plans / std::max(1.0, icebergs);
    else if (traits.replanRule == ReplanRule::WholeFlight)
        plans = 1;
    const bool isLatency = traits.criterion == Criterion::Latency;
    return plans * (isLatency ? costOf(kLatency, icebergs) : costOf(kVisitation, icebergs));
}

/** CPU time of every setting of one case. */
double caseTime_s(const std::vector<StudySetting>& settings, const Scenario& scenario)
{
    const auto icebergs = static_cast<double>(scenario.icebergs.size());
    const double flying_s = scenario.duration_s / scenario.dt_s * (kStep_s + icebergs * kTrack_s);
    double time_s = 0;
    for (const StudySetting& setting : settings)
        time_s += flying_s + planning_s(setting.policy, icebergs, scenario.duration_s);
    return time_s;
}

} // namespace

double estimatedTime_s(const StudySpec& spec)
{
    const std::vector<StudySetting> settings = settingsOf(spec);
    double time_s = 0;
    for (const Scenario& scenario : spec.scenarios)
        time_s += caseTime_s(settings, scenario);
    if (spec.random > 0)
        time_s += spec.random * caseTime_s(settings, randomScenario(spec.firstSeed, spec.field));
    const double cores = std::max(1U, std::thread::hardware_concurrency());
    return time_s * spec.runs / cores;
}

} // namespace berg
