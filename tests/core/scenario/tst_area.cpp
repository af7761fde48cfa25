#include "core/bound/remains_in_area.h"
#include "core/bound/zeta_bound.h"
#include "core/io/files/run_json.h"
#include "core/mission/mission.h"
#include "core/presets/presets.h"
#include "tests/support/approx.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/flight/flown_plans.h"
#include "tests/support/flight/scenario_builder.h"

#include <QTest>

#include <algorithm>

using namespace berg;
using namespace berg::test;

namespace {

/** A square of 4 km; one iceberg in its middle, one that drifts out to the north after 1000 s. */
Scenario squareSea()
{
    Scenario scenario = emptySea(2000);
    scenario.area_m = {{-2000, -2000}, {2000, -2000}, {2000, 2000}, {-2000, 2000}};
    addIceberg(scenario, 0, -1000);
    Iceberg& leaver = addIceberg(scenario, 0, 1450);
    leaver.velocity_mps = {0, 0.6};
    return scenario;
}

/** Drifting icebergs, some unlike their estimates, in an area that they soon leave. */
Scenario leavingField(std::uint64_t seed, ObserverModel model)
{
    Random random(seed, 320);
    Scenario scenario = randomScenario(static_cast<std::int64_t>(seed),
                                       {.icebergs = 8, .size_m = {3000, 3000}, .speedMax_mps = 1});
    scenario.observer.model = model;
    scenario.duration_s = 1500;
    scenario.area_m = {{400, 400}, {2600, 300}, {2500, 2600}, {1500, 1200}, {300, 2500}};
    for (Iceberg& iceberg : scenario.icebergs) {
        iceberg.velocitySd_mps = 0.2;
        const Point to_m = iceberg.position_m + 1500 * iceberg.velocity_mps;
        if (random.below(3) == 0)
            iceberg.track = {
                .time_s = {0, 1500},
                .position_m = {iceberg.position_m, to_m + Point(random.uniform(-900, 900), 0)}};
    }
    scenario.planner.policy = static_cast<PolicyKind>(random.below(kPolicyTable.size()));
    return scenario;
}

/** Flies to the end and counts the seconds at which an iceberg that has left is in view. */
Mission flown(const Scenario& scenario, int& seenOutside)
{
    Mission mission(scenario, {.workLimit = 5000});
    for (double time_s = 1; time_s <= scenario.duration_s; ++time_s) {
        mission.advance(time_s);
        for (const Track& track : mission.simulation().observer().tracks())
            seenOutside += track.left && track.inView ? 1 : 0;
    }
    return mission;
}

const MissionEvent* find(const Mission& mission, EventKind kind)
{
    const auto found = std::find_if(mission.events().begin(), mission.events().end(),
                                    [kind](const MissionEvent& e) { return e.kind == kind; });
    return found == mission.events().end() ? nullptr : &*found;
}

} // namespace

/** The set of icebergs as they leave and enter the area. */
class TestArea : public QObject
{
    Q_OBJECT

private slots:
    void distancesToEdgesByHand()
    {
        const std::vector<Point> square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
        COMPARE_NEAR(distanceToEdges(square, Point(5, 4)), 4, 1e-12);
        COMPARE_NEAR(distanceToEdges(square, Point(13, 14)), 5, 1e-12);
        COMPARE_NEAR(distanceToEdges(square, Point(2, 5), Point(7, 5)), 2, 1e-12);
        QCOMPARE(distanceToEdges(square, Point(2, 5), Point(17, 5)), 0.0);
        COMPARE_NEAR(distanceToSegment({0, 0}, {0, 0}, {3, 4}), 5, 1e-12);
    }

    void leaversAreDropped()
    {
        Scenario scenario = squareSea();
        Mission mission(scenario);
        mission.advance(2000);
        const MissionEvent* left = find(mission, EventKind::Left);
        QVERIFY(left != nullptr);
        QCOMPARE(left->iceberg, IcebergIndex(1));
        // 600 m beyond the edge less its own radius of 50 m: at (550 + 50) / 0.6 s.
        COMPARE_NEAR(left->time_s, 600 / 0.6, 1.01);
        const Simulation& end = mission.simulation();
        QVERIFY(!end.active(1));
        QVERIFY(!end.available(0, 1));
        COMPARE_NEAR(end.state().sigmaSum_m2, end.track(0).sigma_m2, 1e-12);
        bool replanned = false;
        for (const test::FlownPlan& plan : test::flownPlans(mission)) {
            replanned = replanned || plan.reason == PlanReason::Left;
            if (plan.time_s >= left->time_s)
                QVERIFY(std::find(plan.order.begin(), plan.order.end(), IcebergIndex(1)) ==
                        plan.order.end());
        }
        QVERIFY(replanned);
    }

    /** An iceberg outside is not monitored: it is not sighted, lost or found until it is back. */
    void icebergsOutsideCauseNoEvents_data()
    {
        QTest::addColumn<ObserverModel>("model");
        QTest::newRow("simple") << ObserverModel::Simple;
        QTest::newRow("kalman") << ObserverModel::Kalman;
    }
    void icebergsOutsideCauseNoEvents()
    {
        QFETCH(ObserverModel, model);
        int seenOutside = 0;
        int back = 0;
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            const Mission mission = flown(leavingField(seed, model), seenOutside);
            std::vector<bool> isOutside(mission.icebergs().size(), false);
            for (const MissionEvent& event : mission.events()) {
                if (!event.iceberg)
                    continue;
                auto outside = isOutside[toIndex(*event.iceberg)];
                const bool isOfView = event.kind == EventKind::Sighted ||
                                      event.kind == EventKind::Lost ||
                                      event.kind == EventKind::Found;
                QVERIFY2(!outside || !isOfView, qPrintable(QString::number(seed)));
                back += outside && event.kind == EventKind::Appeared ? 1 : 0;
                if (event.kind == EventKind::Left || event.kind == EventKind::Appeared)
                    isOutside[toIndex(*event.iceberg)] = event.kind == EventKind::Left;
            }
        }
        QVERIFY2(seenOutside > 100, qPrintable(QString::number(seenOutside)));
        QVERIFY2(back >= 3, qPrintable(QString::number(back)));
    }

    void icebergComingBackIsMonitoredAgain()
    {
        Scenario scenario = squareSea();
        scenario.icebergs[1].position_m = {0, 2300};
        scenario.icebergs[1].velocity_mps = {0, -0.6};
        Mission mission(scenario);
        QVERIFY(!mission.simulation().active(1));
        mission.advance(2000);
        QVERIFY(mission.simulation().active(1));
        const MissionEvent* back = find(mission, EventKind::Appeared);
        QVERIFY(back != nullptr);
        COMPARE_NEAR(back->time_s, 500, 1.01);
        QVERIFY(find(mission, EventKind::Left) == nullptr); // it was never inside
    }

    void theUncertaintyOfOneOutsideGrowsOn()
    {
        Scenario scenario = squareSea();
        scenario.icebergs[1].position_m = {9000, 9000};
        scenario.icebergs[1].velocity_mps = {0, 0};
        Mission mission(scenario);
        mission.advance(100);
        COMPARE_NEAR(mission.simulation().track(1).sigma_m2, 5 + 0.025 * 100, 1e-9);
    }

    void withoutAreaNothingLeaves()
    {
        Scenario scenario = squareSea();
        scenario.area_m.clear();
        Mission mission(scenario);
        mission.advance(2000);
        QVERIFY(mission.simulation().active(1));
        QVERIFY(find(mission, EventKind::Left) == nullptr);
    }

    void flightWithAnAreaReplays()
    {
        Mission mission(squareSea());
        mission.advance(2000);
        const RunFile run = runFromJson(runToJson(runOf(mission)), "run");
        QVERIFY(compareRun(run, runOf(replay(run))).empty());
    }

    /** The bound counts only icebergs that surely stay. */
    void boundCountsOnlyIcebergsThatStay()
    {
        const Scenario scenario = squareSea();
        QVERIFY(remainsInArea(scenario, scenario.icebergs[0]));
        QVERIFY(!remainsInArea(scenario, scenario.icebergs[1]));
        Scenario one = scenario;
        one.icebergs.pop_back();
        QCOMPARE(zetaLowerBound(scenario, {.workLimit = 1'000'000}).zeta_m2s,
                 zetaLowerBound(one, {.workLimit = 1'000'000}).zeta_m2s);
        for (std::int64_t seed = 1; seed <= 10; ++seed) {
            Scenario random = randomScenario(seed);
            for (Iceberg& iceberg : random.icebergs)
                iceberg.velocity_mps *= 5; // up to 2 km in the run
            random.area_m = {{0, 0}, {5000, 0}, {5000, 4000}, {0, 4000}};
            Mission mission(random);
            mission.advance(random.duration_s);
            QVERIFY(zetaLowerBound(random, {.workLimit = 20'000'000}).zeta_m2s <=
                    mission.metrics().zeta_m2s);
        }
    }

    /** Noise can carry an iceberg over the edge, so none near it surely stays. */
    void noIcebergNearTheEdgeSurelyStays()
    {
        Scenario scenario = squareSea();
        scenario.noise = true;
        scenario.icebergs[0].position_m = {1999.5, 0};
        QVERIFY(!remainsInArea(scenario, scenario.icebergs[0]));
        scenario.icebergs[0].position_m = {1900, 0};
        QVERIFY(remainsInArea(scenario, scenario.icebergs[0]));
    }
};

QTEST_APPLESS_MAIN(TestArea)
#include "tst_area.moc"
