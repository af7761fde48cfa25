// Distance of the lower bound from the zeta that the policy coverage flies, and the bound's cost.
// bench_bound [ICEBERGS [SPEED [SCENARIOS [WIND [WORK]]]]]
#include "core/bound/zeta_bound.h"
#include "core/mission/mission.h"
#include "core/presets/presets.h"

#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace {

double argument(int argc, char** argv, int i, double fallback)
{
    return i < argc ? std::atof(argv[i]) : fallback;
}

double flownZeta_m2s(const berg::Scenario& scenario)
{
    berg::MissionOptions options;
    options.record = false;
    berg::Mission mission(scenario, options);
    mission.advance(scenario.duration_s);
    return mission.metrics().zeta_m2s;
}

} // namespace

int main(int argc, char** argv)
{
    const int scenarios = static_cast<int>(argument(argc, argv, 3, 5));
    double ratioSum = 0;
    for (int seed = 1; seed <= scenarios; ++seed) {
        berg::FieldSpec field;
        field.icebergs = static_cast<int>(argument(argc, argv, 1, 12));
        field.speedMax_mps = argument(argc, argv, 2, 0);
        berg::Scenario scenario = berg::randomScenario(seed, field);
        scenario.wind_mps = {argument(argc, argv, 4, 0), 0};
        scenario.planner.policy = berg::PolicyKind::Coverage;
        berg::ZetaBoundOptions options;
        options.workLimit = static_cast<std::int64_t>(
            argument(argc, argv, 5, static_cast<double>(options.workLimit)));
        const double flown_m2s = flownZeta_m2s(scenario);
        const std::clock_t before = std::clock();
        const berg::ZetaBound bound = berg::zetaLowerBound(scenario, options);
        const double ratio = bound.zeta_m2s / flown_m2s;
        ratioSum += ratio;
        std::printf("seed %3d  flown %7.0f  bound %7.0f  ratio %.3f  %5.2f s CPU  %5.2f G units\n",
                    seed, flown_m2s, bound.zeta_m2s, ratio,
                    static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC,
                    static_cast<double>(bound.work) * 1e-9);
        std::fflush(stdout);
    }
    std::printf("mean ratio %.3f\n", ratioSum / scenarios);
}
