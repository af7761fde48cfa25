// Several UAVs.

#include "core/plan/policy/policy.h"
#include "core/presets/presets.h"
#include "tests/bench/world_parts.h"

#include <cmath>

namespace berg::bench {

namespace {

/** Assigns each iceberg to the UAV that the latency policy assigns it to at the start, because that
 * policy shares the work evenly. */
Scenario partitioned(Scenario scenario)
{
    Scenario start = scenario;
    start.planner.policy = PolicyKind::Latency;
    const Plan plan = planFromStart(start);
    for (std::size_t uav = 0; uav < plan.uavs.size(); ++uav)
        for (const IcebergIndex iceberg : plan.uavs[uav].order)
            scenario.icebergs[toIndex(iceberg)].uav = scenario.uavs[uav].id;
    return scenario;
}

Row fly(const Scenario& scenario)
{
    Mission mission(scenario, {.record = false});
    mission.advance(scenario.duration_s);
    const Metrics metrics = mission.metrics();
    return {metrics.zeta_m2s, static_cast<double>(metrics.visits),
            static_cast<double>(metrics.replans), metrics.flown_m / 1000};
}

/** Flies each UAV separately with its assigned icebergs; it does not share its sightings. */
Row flyApart(const Scenario& scenario)
{
    Row sum(4, 0.0);
    for (const Uav& uav : scenario.uavs) {
        Scenario alone = scenario;
        alone.uavs = {uav};
        std::erase_if(alone.icebergs, [&](const Iceberg& i) { return i.uav != uav.id; });
        const Row row = fly(alone);
        for (std::size_t column = 0; column < row.size(); ++column)
            sum[column] += row[column];
    }
    return sum;
}

void compare(int icebergs, int uavs, PolicyKind policy, int scenarios, std::vector<Row>& alone)
{
    std::vector<Row> together;
    std::vector<Row> kept;
    std::vector<Row> apart;
    for (int seed = 1; seed <= scenarios; ++seed) {
        // The field with 40 icebergs has the density of that with 12.
        const double stretch = std::sqrt(icebergs / 12.0);
        FieldSpec field{.icebergs = icebergs};
        field.size_m *= stretch;
        Scenario scenario = withUavs(randomScenario(seed, field), uavs);
        scenario.planner.policy = policy;
        together.push_back(fly(scenario));
        if (uavs == 1)
            continue;
        const Scenario parts = partitioned(scenario);
        kept.push_back(fly(parts));
        apart.push_back(flyApart(parts));
    }
    std::printf("%d icebergs, %d UAVs, %s\n", icebergs, uavs,
                std::string(nameOf(kPolicyNames, policy)).c_str());
    printMeans("  planned together", together);
    if (uavs == 1) {
        alone = together;
        return;
    }
    printMeans("  fixed partition", kept);
    printMeans("  each for itself", apart);
    printDifference("  together / partition", kept, together);
    printDifference("  together / for itself", apart, together);
    printDifference("  together / one UAV", alone, together);
}

void compareFleets(PolicyKind policy, int scenarios)
{
    std::printf("%-24s %11s %11s %11s %11s\n", "", "zeta", "visits", "plans", "km flown");
    for (const int icebergs : {12, 40}) {
        std::vector<Row> alone;
        for (const int uavs : {1, 2, 3, 5})
            compare(icebergs, uavs, policy, scenarios, alone);
    }
}

} // namespace

void fleet(int scenarios)
{
    compareFleets(PolicyKind::Visitation, scenarios);
}

void fleetCoverage(int scenarios)
{
    compareFleets(PolicyKind::Coverage, scenarios);
}

} // namespace berg::bench
