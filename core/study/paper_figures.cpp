#include "core/study/paper_figures.h"

namespace berg {

namespace {

constexpr int kFigure3Instances = 50; // Table 1, "Number of Optimizations"
constexpr double kTable1Tau = 0.5;
constexpr int kFigure4LastTenth = 40; // tau = 4

} // namespace

BenchmarkSpec figure3(std::vector<BenchmarkSolver> solvers)
{
    BenchmarkSpec spec{
        .solvers = std::move(solvers), .repeat = kFigure3Instances, .tau = kTable1Tau};
    for (const PaperTime& time : paperTable2())
        spec.sizes.push_back(time.icebergs);
    return spec;
}

StudySpec figure4(const Scenario& scenario)
{
    StudySpec spec{.name = "Figure 4",
                   .scenarios = {scenario},
                   .policies = {PolicyKind::Visitation, PolicyKind::Path}};
    if (!scenario.name.empty())
        spec.name += ": " + scenario.name;
    for (int tenth = 0; tenth <= kFigure4LastTenth; ++tenth)
        spec.taus.push_back(tenth / 10.0); // exact decimals, unlike multiples of 0.1
    return spec;
}

std::optional<Figure5> figure5(const StudySummary& summary)
{
    const SettingSummary* best = nullptr;
    for (const SettingSummary& s : summary.settings) {
        if (!s.setting.tau)
            continue;
        const double zeta_m2s = s.zeta_m2s.mean;
        if (best == nullptr || zeta_m2s < best->zeta_m2s.mean ||
            (zeta_m2s == best->zeta_m2s.mean && s.setting.tau < best->setting.tau))
            best = &s;
    }
    if (best == nullptr || summary.cases.empty())
        return std::nullopt;
    return Figure5{.best = best->setting, .tsp = {.policy = PolicyKind::Path}};
}

} // namespace berg
