// Tests whether tau has the same meaning for any number of UAVs.

#include "core/presets/presets.h"
#include "tests/bench/world_parts.h"

#include <array>

namespace berg::bench {

namespace {

constexpr std::array kTaus{1.0, 0.25, 0.5, 0.7, 1.4, 2.0}; ///< the first is the reference

double zetaOf(Scenario scenario, double tau)
{
    scenario.planner.tau = tau;
    Mission mission(scenario, {.record = false});
    mission.advance(scenario.duration_s);
    return mission.metrics().zeta_m2s;
}

/** Prints a line with the mean zeta for each tau relative to that for tau = 1, in %, with the
 * standard error of the difference. */
void compareTaus(int icebergs, int uavs, int fields)
{
    std::array<std::vector<double>, kTaus.size()> zetas;
    double base = 0;
    for (int seed = 1; seed <= fields; ++seed) {
        const Scenario field = withUavs(randomScenario(seed, {.icebergs = icebergs}), uavs);
        for (std::size_t k = 0; k < kTaus.size(); ++k)
            zetas[k].push_back(zetaOf(field, kTaus[k]));
        base += zetas.front().back() / fields;
    }
    std::printf("%2d icebergs, %d UAVs %9.0f", icebergs, uavs, base);
    for (std::size_t k = 1; k < kTaus.size(); ++k) {
        std::vector<double> share;
        for (std::size_t i = 0; i < zetas[k].size(); ++i)
            share.push_back(100 * (zetas[k][i] - zetas.front()[i]) / base);
        const Summary change = summarise(share);
        std::printf("  %+6.1f +-%4.1f", change.mean, change.standardError);
    }
    std::printf("\n");
    std::fflush(stdout);
}

} // namespace

void tau(int scenarios)
{
    std::printf("%-20s %9s", "", "tau = 1");
    for (std::size_t k = 1; k < kTaus.size(); ++k)
        std::printf("  %6g +- se ", kTaus[k]);
    std::printf("\n");
    for (const int icebergs : {12, 20})
        for (int uavs = 1; uavs <= 5; ++uavs)
            compareTaus(icebergs, uavs, scenarios);
}

} // namespace berg::bench
