#include "core/scenario/presets.h"
#include "core/study/study.h"
#include "tests/support/approx.h"
#include "tests/support/scenario_builder.h"

#include <algorithm>
#include <set>

using namespace berg;
using test::addIceberg;
using test::emptySea;

namespace {

/** Six icebergs for 300 s: short, but with several visits. */
Scenario smallField(std::int64_t seed)
{
    Scenario scenario = randomScenario(seed, {.icebergs = 6, .size_m = {3000, 2500}});
    scenario.duration_s = 300;
    return scenario;
}

SweepSpec smallSweep()
{
    return {.scenarios = {smallField(1), smallField(2), smallField(3)},
            .taus = {0.5, 2},
            .policies = {PolicyKind::Nearest, PolicyKind::Visitation, PolicyKind::Path},
            .runs = 2};
}

/** One mission as anybody would fly it. */
Metrics flown(Scenario scenario, std::int64_t seed, PolicyKind policy, double tau)
{
    scenario.seed = seed;
    scenario.planner.policy = policy;
    scenario.planner.tau = tau;
    Mission mission(scenario);
    mission.advance(scenario.duration_s);
    return mission.metrics();
}

SweepRow onlyRow(const Scenario& scenario, PolicyKind policy)
{
    const SweepResult result =
        sweep({.scenarios = {scenario}, .taus = {1}, .policies = {policy}}, {});
    return result.rows.at(0);
}

} // namespace

class TestStudy : public QObject
{
    Q_OBJECT

private slots:
    void rowsInOrder()
    {
        const SweepResult result = sweep(smallSweep(), {.threads = 2});
        QVERIFY(result.complete);
        QCOMPARE(result.rows.size(), std::size_t{4});
        // Visitation by tau as given, then the others as given.
        QCOMPARE(result.rows[0].policy, PolicyKind::Visitation);
        QVERIFY(result.rows[0].tau == 0.5);
        QCOMPARE(result.rows[1].policy, PolicyKind::Visitation);
        QVERIFY(result.rows[1].tau == 2.0);
        QCOMPARE(result.rows[2].policy, PolicyKind::Nearest);
        QVERIFY(!result.rows[2].tau);
        QCOMPARE(result.rows[3].policy, PolicyKind::Path);
        for (const SweepRow& row : result.rows) {
            QCOMPARE(row.zeta_m2s.size(), std::size_t{6});
            QCOMPARE(row.visits.size(), std::size_t{6});
            QCOMPARE(row.summary.n, 6);
            COMPARE_NEAR(row.summary.mean, summarise(row.zeta_m2s).mean, 0);
            COMPARE_NEAR(row.summary.standardError, summarise(row.zeta_m2s).standardError, 0);
        }
    }

    void sameForAnyNumberOfThreads()
    {
        const SweepResult one = sweep(smallSweep(), {.threads = 1});
        const SweepResult four = sweep(smallSweep(), {.threads = 4});
        QCOMPARE(one.rows.size(), four.rows.size());
        for (std::size_t i = 0; i < one.rows.size(); ++i) { // bit for bit
            QVERIFY(one.rows[i].zeta_m2s == four.rows[i].zeta_m2s);
            QVERIFY(one.rows[i].visits == four.rows[i].visits);
            QCOMPARE(one.rows[i].summary.mean, four.rows[i].summary.mean);
            QCOMPARE(one.rows[i].stuckShare, four.rows[i].stuckShare);
        }
    }

    /** Case by case in every row: the same icebergs and noise, scenario-major, then run. */
    void casesArePaired()
    {
        const SweepSpec spec = smallSweep();
        const SweepResult result = sweep(spec, {});
        std::set<double> different;
        for (const SweepRow& row : result.rows)
            for (std::size_t c = 0; c < 6; ++c) {
                const Scenario& scenario = spec.scenarios[c / 2];
                const std::int64_t seed = seedOfRun(scenario.seed, static_cast<int>(c % 2));
                const Metrics expected = flown(scenario, seed, row.policy, row.tau.value_or(1));
                QCOMPARE(row.zeta_m2s[c], expected.zeta_m2s);
                QCOMPARE(row.visits[c], static_cast<double>(expected.visits));
                different.insert(row.zeta_m2s[c]);
            }
        // Settings, scenarios and noise all matter, so hardly any two are equal.
        QVERIFY(different.size() >= 20);
    }

    void withoutNoiseRunsAreEqual()
    {
        SweepSpec spec = smallSweep();
        spec.policies = {PolicyKind::Nearest};
        spec.runs = 3;
        for (Scenario& scenario : spec.scenarios)
            scenario.noise = false;
        const SweepResult result = sweep(spec, {});
        const std::vector<double>& zeta_m2s = result.rows.at(0).zeta_m2s;
        QCOMPARE(zeta_m2s.size(), std::size_t{9});
        for (std::size_t c = 0; c < 9; ++c)
            QCOMPARE(zeta_m2s[c], zeta_m2s[c - c % 3]);
    }

    void tauOfTheScenarioIsNotUsed()
    {
        SweepSpec spec = smallSweep();
        spec.policies = {PolicyKind::Visitation};
        const SweepResult before = sweep(spec, {});
        for (Scenario& scenario : spec.scenarios)
            scenario.planner.tau = 77;
        const SweepResult after = sweep(spec, {});
        QVERIFY(before.rows.at(1).zeta_m2s == after.rows.at(1).zeta_m2s);
    }

    void missionsAreCounted()
    {
        SweepSpec spec = smallSweep();
        QCOMPARE(missionCount(spec), std::size_t{24}); // (2 taus + 2 policies) x 3 x 2
        spec.policies = {PolicyKind::Nearest};
        QCOMPARE(missionCount(spec), std::size_t{6});
        spec.policies = {PolicyKind::Visitation};
        spec.runs = 5;
        QCOMPARE(missionCount(spec), std::size_t{30});
        spec.scenarios.clear();
        QCOMPARE(missionCount(spec), std::size_t{0});
        QCOMPARE(missionCount({}), std::size_t{0});
    }

    void progressCountsMissions()
    {
        std::vector<std::size_t> progress;
        const SweepSpec spec = smallSweep();
        const auto onProgress = [&](std::size_t done) { progress.push_back(done); };
        (void)sweep(spec, {.threads = 3, .onProgress = onProgress});
        QCOMPARE(progress.size(), missionCount(spec));
        QVERIFY(std::is_sorted(progress.begin(), progress.end()));
        QCOMPARE(progress.back(), missionCount(spec));
    }

    void stoppedSweepHasNoRows()
    {
        std::stop_source source;
        const auto onProgress = [&](std::size_t done) {
            if (done == 2)
                source.request_stop();
        };
        const SweepResult result = sweep(
            smallSweep(), {.threads = 2, .stop = source.get_token(), .onProgress = onProgress});
        QVERIFY(!result.complete);
        QVERIFY(result.rows.empty());
    }

    void badScenarioIsReported()
    {
        SweepSpec spec = smallSweep();
        spec.scenarios[1].wind_mps = {30, 0}; // faster than the UAV
        QVERIFY_EXCEPTION_THROWN((void)sweep(spec, {}), Error);
    }

    /** Options reach the missions; recording does not change a result. */
    void optionsReachTheMissions()
    {
        SweepSpec spec = smallSweep();
        const SweepResult plain = sweep(spec, {});
        spec.options.record = true;
        spec.options.warmStart = false;
        const SweepResult other = sweep(spec, {});
        // Exact at this size: without warm start the same plans.
        QVERIFY(plain.rows.at(0).zeta_m2s == other.rows.at(0).zeta_m2s);
        spec.options.workLimit = 0; // no plan from the solver: the nearest one is flown to
        const SweepResult limited = sweep(spec, {});
        QVERIFY(plain.rows.at(0).zeta_m2s != limited.rows.at(0).zeta_m2s);
    }

    void seedsOfRuns()
    {
        QCOMPARE(seedOfRun(42, 0), 42);
        std::set<std::int64_t> seeds;
        for (std::int64_t seed = 0; seed < 30; ++seed)
            for (int run = 0; run < 30; ++run) {
                const std::int64_t value = seedOfRun(seed, run);
                QVERIFY(value >= 0 && value <= (std::int64_t{1} << 53));
                QCOMPARE(seedOfRun(seed, run), value);
                seeds.insert(value);
            }
        QCOMPARE(seeds.size(), std::size_t{900});
        // From the stream named by seed and run, as the header of Random describes it.
        QCOMPARE(seedOfRun(42, 3), static_cast<std::int64_t>(Random(42, 3).bits() >> 11U));
    }

    /** Between two of three icebergs, the third so far that nearest-first never goes there. */
    void stuckOnTwo()
    {
        Scenario scenario = emptySea(1000);
        addIceberg(scenario, 1500, 0);
        addIceberg(scenario, 2600, 0);
        addIceberg(scenario, 2000, 9000);
        QCOMPARE(onlyRow(scenario, PolicyKind::Nearest).stuckShare, 1.0);
        scenario.icebergs[2].position_m = {2000, 1000};
        QCOMPARE(onlyRow(scenario, PolicyKind::Path).stuckShare, 0.0);
    }

    /** Circling while both are in view is no third iceberg. */
    void stuckOnTwoThatAreSeenTogether()
    {
        Scenario scenario = emptySea(1000);
        addIceberg(scenario, 2000, 0);
        addIceberg(scenario, 2500, 0);
        Mission mission(scenario);
        mission.advance(1000);
        std::set<int> targets;
        for (const PlanEvent& plan : mission.plans())
            if (plan.time_s >= 500)
                targets.insert(plan.target);
        QVERIFY((targets == std::set<int>{-1, 0, 1})); // the case asked for
        QCOMPARE(onlyRow(scenario, PolicyKind::Visitation).stuckShare, 1.0);
    }
};

QTEST_APPLESS_MAIN(TestStudy)
#include "tst_study.moc"
