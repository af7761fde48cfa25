#include "core/plan/policy/policy.h"
#include "core/presets/presets.h"
#include "core/sim/clusters.h"
#include "tests/bench/world_parts.h"
#include "tests/support/flight/flown_plans.h"

#include <string>
#include <tuple>

namespace berg::bench {

namespace {

/** Values: zeta, visits, plans, ms of solving, legs to a cluster, such legs ended early. */
Row flown(const Scenario& scenario)
{
    Mission mission(scenario, {.record = false});
    mission.advance(scenario.duration_s);
    double solving_s = 0;
    double legs = 0;
    double missed = 0;
    bool isCluster = false; // type of the leg that a plan ends
    for (const test::FlownPlan& plan : test::flownPlans(mission)) {
        solving_s += plan.plan->outcome.elapsed_s;
        missed += isCluster && plan.reason == PlanReason::Overdue ? 1 : 0;
        isCluster = !clusterOfTarget(plan).empty();
        legs += isCluster ? 1 : 0;
    }
    const Metrics metrics = mission.metrics();
    return {metrics.zeta_m2s,
            static_cast<double>(metrics.visits),
            static_cast<double>(metrics.replans),
            1e3 * solving_s,
            legs,
            missed};
}

} // namespace

void clusters(int scenarios)
{
    std::printf("%-24s %11s %11s %11s %11s %11s %11s\n", "clusters", "zeta", "visits", "plans",
                "solving ms", "legs there", "missed");
    const FieldSpec near{.size_m = Point(2500, 2000)};
    const FieldSpec dense{.icebergs = 20, .size_m = Point(2500, 2000)};
    const FieldSpec wide{.icebergs = 40};
    const std::tuple<const char*, FieldSpec, int> fields[] = {
        {"12 in 5000 x 4000 m", {}, 1},
        {"12 in 2500 x 2000 m", near, 1},
        {"20 in 2500 x 2000 m", dense, 1},
        {"12 in 5000 x 4000 m, 2 UAVs", {}, 2},
        {"20 in 2500 x 2000 m, 2 UAVs", dense, 2},
        {"40 in 5000 x 4000 m, 2 UAVs", wide, 2},
        {"40 in 5000 x 4000 m, 3 UAVs", wide, 3}};
    for (const auto& [name, field, uavs] : fields)
        for (const PolicyKind policy : {PolicyKind::Visitation, PolicyKind::Latency,
                                        PolicyKind::Nearest, PolicyKind::Uncertainty}) {
            std::vector<Row> without;
            std::vector<Row> with;
            for (int seed = 1; seed <= scenarios; ++seed) {
                Scenario scenario = withUavs(randomScenario(seed, field), uavs);
                scenario.planner.policy = policy;
                without.push_back(flown(scenario));
                scenario.clusters = true;
                with.push_back(flown(scenario));
            }
            std::printf("%s, %s\n", name, nameOf(kPolicyNames, policy).c_str());
            printMeans("  single icebergs", without);
            printMeans("  clusters", with);
            printDifference("  zeta", without, with);
        }
}

} // namespace berg::bench
