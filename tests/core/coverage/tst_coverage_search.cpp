#include "core/coverage/coverage_search.h"
#include "core/mission/plan_requests.h"
#include "core/presets/presets.h"
#include "core/sim/simulation.h"
#include "tests/support/flight/scenario_builder.h"

#include <QTest>

#include <algorithm>

using namespace berg;
using test::addIceberg;
using test::emptySea;

namespace {

CoverageModel modelOf(const Scenario& scenario, double length_s = 1000)
{
    return CoverageModel(*planRequest(Simulation(scenario)).uavs[0].prediction,
                         {.length_s = length_s});
}

/** Returns the cost of a plan that is flown leg by leg without the search. */
double costOf(const CoverageModel& model, const CoveragePlan& plan)
{
    CoverageState state = model.start();
    for (const CoverageLeg& leg : plan)
        model.fly(state, leg);
    return model.total_m2s(state);
}

constexpr double kHeat = 0.001;

CoverageResult improved(const CoverageModel& model, std::int64_t work, std::uint64_t seed = 1,
                        const SolveOptions& options = {})
{
    CoverageSearch search(model, Random(seed));
    const CoverageResult start = search.completed({});
    return search.improved(start, search.work() + work, kHeat, SolveWatch(options));
}

CoveragePlan anyPlan(Random& random, int icebergs, std::size_t legs)
{
    CoveragePlan plan;
    for (std::size_t k = 0; k < legs; ++k)
        plan.push_back(
            {.iceberg = ModelPlace::of(random.below(static_cast<std::uint64_t>(icebergs))),
             .offset_m = random.uniform(-250, 250)});
    return plan;
}

} // namespace

class TestCoverageSearch : public QObject
{
    Q_OBJECT

private slots:
    void completedPlanReachesTheHorizon()
    {
        const CoverageModel model = modelOf(randomScenario(2));
        CoverageSearch search(model, Random(1));
        // The iceberg of the second leg is in view by then.
        const CoveragePlan wish{{3, 100}, {3, -100}, {7, 0}};
        const CoverageResult result = search.completed(wish);
        QVERIFY(result.plan.size() > 5);
        QVERIFY(result.plan[0] == wish[0]);
        QVERIFY(result.plan[1] == wish[2]);
        QVERIFY(std::abs(costOf(model, result.plan) / result.total_m2s - 1) < 1e-12);
        CoverageState state = model.start();
        for (const CoverageLeg& leg : result.plan)
            QVERIFY(model.fly(state, leg)); // Each leg takes time.
        QVERIFY(model.atEnd(state));
    }

    void totalsAreThoseOfThePlan()
    {
        for (int seed = 1; seed <= 5; ++seed) {
            const CoverageModel model = modelOf(randomScenario(seed));
            const CoverageResult result = improved(model, 200'000);
            QVERIFY(std::abs(costOf(model, result.plan) / result.total_m2s - 1) < 1e-12);
        }
    }

    void moreWorkIsBetter()
    {
        double greedy_m2s = 0;
        double some_m2s = 0;
        double much_m2s = 0;
        for (int seed = 1; seed <= 8; ++seed) {
            const CoverageModel model = modelOf(randomScenario(seed));
            greedy_m2s += CoverageSearch(model, Random(1)).completed({}).total_m2s;
            some_m2s += improved(model, 50'000).total_m2s;
            much_m2s += improved(model, 1'000'000).total_m2s;
        }
        QVERIFY(some_m2s < 0.97 * greedy_m2s);
        QVERIFY(much_m2s < 0.98 * some_m2s);
    }

    /** The result is never worse than the start, for any start and any work limit. */
    void neverWorseThanTheStart()
    {
        const CoverageModel model = modelOf(randomScenario(4));
        Random random(5);
        for (const std::int64_t work : {0, 1, 1000, 20'000}) {
            CoverageSearch search(model, Random(6));
            const CoverageResult start = search.completed(anyPlan(random, 12, 20));
            const CoverageResult result =
                search.improved(start, search.work() + work, 100 * kHeat, SolveWatch({}));
            QVERIFY(result.total_m2s <= start.total_m2s);
            if (work == 0)
                QVERIFY(result.plan == start.plan);
        }
    }

    /**
     * The listener receives plans of all starts, each better than the one before. The search gives
     * the same plan without a listener.
     */
    void listenerHearsOfBetterPlans()
    {
        const CoverageModel model = modelOf(randomScenario(7));
        std::vector<CoverageResult> reported;
        CoverageSearch search(model, Random(3));
        search.setListener([&](const CoverageResult& better) { reported.push_back(better); });
        CoverageSearch quiet(model, Random(3));
        double best_m2s = std::numeric_limits<double>::infinity();
        for (const CoveragePlan& start : {CoveragePlan{}, CoveragePlan{{2, 50}, {5, 0}}}) {
            const CoverageResult found = search.improved(
                search.completed(start), search.work() + 100'000, kHeat, SolveWatch({}));
            const CoverageResult alone = quiet.improved(
                quiet.completed(start), quiet.work() + 100'000, kHeat, SolveWatch({}));
            QVERIFY(found.plan == alone.plan);
            best_m2s = std::min(best_m2s, found.total_m2s);
        }
        QVERIFY(reported.size() > 5);
        for (std::size_t i = 1; i < reported.size(); ++i)
            QVERIFY(reported[i].total_m2s < reported[i - 1].total_m2s);
        QCOMPARE(reported.back().total_m2s, best_m2s);
    }

    void sameWorkSamePlan()
    {
        const CoverageModel model = modelOf(randomScenario(7));
        const CoverageResult one = improved(model, 300'000);
        const CoverageResult two = improved(model, 300'000);
        QVERIFY(one.plan == two.plan);
        QVERIFY(one.total_m2s == two.total_m2s);
        // Another random stream gives another search.
        QVERIFY(!(improved(model, 300'000, 2).plan == one.plan));
    }

    void stopsWhenTold()
    {
        std::stop_source source;
        source.request_stop();
        const SolveOptions options{.stop = source.get_token()};
        const CoverageModel model = modelOf(randomScenario(8));
        CoverageSearch search(model, Random(1));
        const CoverageResult start = search.completed({});
        const std::int64_t before = search.work();
        const SolveWatch watch(options);
        QVERIFY(search.improved(start, 1'000'000'000, kHeat, watch).plan == start.plan);
        QVERIFY(search.work() - before < 100'000);
    }

    void oneIceberg()
    {
        Scenario scenario = emptySea();
        addIceberg(scenario, 2000, 1000);
        const CoverageModel model = modelOf(scenario);
        const CoverageResult result = improved(model, 50'000);
        QVERIFY(!result.plan.empty());
        QCOMPARE(result.plan.front().iceberg, ModelPlace(0));
    }

    void sixtyIcebergs()
    {
        const CoverageModel model = modelOf(randomScenario(9, {.icebergs = 60}));
        const double greedy_m2s = CoverageSearch(model, Random(1)).completed({}).total_m2s;
        QVERIFY(improved(model, 1'000'000).total_m2s < 0.98 * greedy_m2s);
    }

    /** Every plan costs nothing with sigma 0 and no growth, and the search still returns one. */
    void nothingToGain()
    {
        Scenario scenario = emptySea();
        for (const double east_m : {1000.0, 2000.0, 3000.0})
            addIceberg(scenario, east_m, 1500, 0).q_m2ps = 0;
        const CoverageResult result = improved(modelOf(scenario), 50'000);
        QCOMPARE(result.total_m2s, 0.0);
        QVERIFY(!result.plan.empty());
    }

    /** The plan has no leg if all icebergs are in view and slower than the UAV turns. */
    void nothingToFlyTo()
    {
        Scenario scenario = emptySea();
        addIceberg(scenario, 100, 0);
        const CoverageResult result = improved(modelOf(scenario), 50'000);
        QVERIFY(result.plan.empty());
    }

    void movesKeepPlansValid()
    {
        const CoverageModel model = modelOf(randomScenario(1, {.icebergs = 5}));
        const double edge_m = model.largestOffset_m();
        CoverageMoves moves(model, Random(3));
        Random random(4);
        CoveragePlan plan = anyPlan(random, 5, 12);
        int unchanged = 0;
        for (int i = 0; i < 5000; ++i) {
            const CoveragePlan before = plan;
            const std::size_t first = moves.change(plan);
            QVERIFY(first < before.size());
            QVERIFY(std::equal(plan.begin(), plan.begin() + static_cast<std::ptrdiff_t>(first),
                               before.begin()));
            unchanged += plan == before ? 1 : 0;
            for (const CoverageLeg& leg : plan)
                QVERIFY(leg.iceberg >= 0 && leg.iceberg < 5 && std::abs(leg.offset_m) <= edge_m);
            if (plan.empty() || plan.size() > 40)
                plan = anyPlan(random, 5, 12);
        }
        // A leg exchanged with itself, or the same offset again, changes nothing.
        QVERIFY(unchanged < 1500);
    }
};

QTEST_APPLESS_MAIN(TestCoverageSearch)
#include "tst_coverage_search.moc"
