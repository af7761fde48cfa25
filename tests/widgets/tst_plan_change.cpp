#include "tests/support/approx.h"
#include "tests/support/scenario_builder.h"
#include "widgets/map/mission_picture.h"
#include "widgets/model/workspace.h"
#include "widgets/panels/plan_rows.h"

#include <QtTest>

using namespace berg;

namespace {

const std::vector<int> kShortest{0, 1, 2, 3};
const std::vector<int> kUncertainFirst{3, 2, 1, 0};

/** Four icebergs in a row ahead of the UAV, the farther the more uncertain. */
Scenario rowOfIcebergs()
{
    Scenario scenario = test::emptySea(1000);
    scenario.uavs.front().fov_m = {80, 80};
    scenario.planner.tau = 50;
    for (int i = 0; i < 4; ++i)
        test::addIceberg(scenario, 3000.0 * (i + 1), 0, 5 + 3.0 * i);
    return scenario;
}

/** A workspace with that scenario, planned. */
struct Desk
{
    Workspace workspace;

    Desk() { open(rowOfIcebergs()); }

    void open(const Scenario& scenario)
    {
        workspace.document().reset(scenario);
        wait();
    }
    void wait()
    {
        if (!QTest::qWaitFor(
                [this] {
                    return record().now.phase == RunPhase::Ready &&
                           record().now.generation == workspace.runner().generation();
                },
                60'000))
            qFatal("no plan");
    }
    void setTau(double tau)
    {
        workspace.setTau(tau);
        wait();
    }
    /** Flies on, and on to a whole number of seconds. */
    void flyTo(double time_s)
    {
        workspace.runner().stepBy(time_s - record().now.time_s);
        waitFor(time_s);
    }
    void waitFor(double time_s)
    {
        if (!QTest::qWaitFor([&] { return std::abs(record().shown().time_s - time_s) < 1e-6; },
                             60'000))
            qFatal("the flight does not get there");
    }
    void intervene(double tau)
    {
        const std::size_t plans = record().now.planCount;
        workspace.runner().intervene({.tau = tau});
        if (!QTest::qWaitFor([&] { return record().now.planCount > plans; }, 60'000))
            qFatal("no new plan");
    }

    [[nodiscard]] const FlightRecord& record() const { return workspace.record(); }
    [[nodiscard]] MapPicture picture() const { return missionPicture(record(), QLocale::c()); }
    [[nodiscard]] std::vector<int> former() const { return picture().formerPlan; }
};

} // namespace

/** What the plan shown took the place of: on the map and in figures. */
class TestPlanChange : public QObject
{
    Q_OBJECT

private slots:
    void tauBeforeTakeOff()
    {
        Desk desk;
        QCOMPARE(desk.picture().plan, kShortest);
        QVERIFY(desk.former().empty());
        desk.setTau(40); // the same order
        QVERIFY(desk.former().empty());
        desk.setTau(0);
        QCOMPARE(desk.picture().plan, kUncertainFirst);
        QCOMPARE(desk.former(), kShortest);
        QVERIFY(!desk.picture().formerFrom_m); // from where the UAV is, wherever it is put
        desk.setTau(0.001);                    // the drag goes on, the order stays
        QCOMPARE(desk.former(), kShortest);
        desk.setTau(50);
        QCOMPARE(desk.former(), kUncertainFirst);
    }

    /** Straight legs would foretell too much. */
    void planWithAimPointsHasNoOutlook()
    {
        Desk desk;
        Scenario scenario = rowOfIcebergs();
        scenario.planner.policy = PolicyKind::Coverage;
        desk.open(scenario);
        QVERIFY(!desk.record().now.plan->legs.empty());
        QVERIFY(!planOutlook(desk.record()));
        QVERIFY(!planRows(desk.record().now, scenario).empty());
    }

    void figuresBeforeTakeOff()
    {
        Desk desk;
        const double shortest_m2s = planOutlook(desk.record())->zeta_m2s;
        QVERIFY(!planOutlook(desk.record())->change);
        desk.setTau(0);
        const PlanOutlook outlook = planOutlook(desk.record()).value();
        const PlanChange change = outlook.change.value();
        COMPARE_NEAR(change.distance_m, 9000, 1e-6); // and back to the first of the row
        COMPARE_NEAR(outlook.zeta_m2s - shortest_m2s, change.zeta_m2s, 1e-6);
        QCOMPARE(outlook.before, (QStringList{QStringLiteral("berg-1"), QStringLiteral("berg-2"),
                                              QStringLiteral("berg-3"), QStringLiteral("berg-4")}));
    }

    void anotherWorldForgets()
    {
        Desk desk;
        desk.setTau(0);
        QVERIFY(!desk.former().empty());
        desk.workspace.document().edit(QStringLiteral("move"), [](Scenario& scenario) {
            scenario.icebergs[1].position_m.y() += 500;
        });
        desk.wait();
        QVERIFY(desk.former().empty());
        desk.setTau(50);
        QVERIFY(!desk.former().empty());
        desk.open(rowOfIcebergs());
        QVERIFY(desk.former().empty());
    }

    void takingOffAndResetForget()
    {
        Desk desk;
        desk.setTau(0);
        desk.flyTo(10);
        QVERIFY(desk.former().empty()); // nothing was changed on this flight
        QVERIFY(!planOutlook(desk.record())->change);
        desk.workspace.reset();
        desk.wait();
        QVERIFY(desk.former().empty());
    }

    void inFlight()
    {
        Desk desk;
        desk.flyTo(60);
        const double shortest_m2s = planOutlook(desk.record())->zeta_m2s;
        desk.intervene(0);
        QCOMPARE(desk.former(), kShortest);
        const Point turn_m = desk.record().now.world.uav.position_m;
        const PlanOutlook outlook = planOutlook(desk.record()).value();
        const PlanChange change = outlook.change.value();
        COMPARE_NEAR(change.distance_m, 9000, 1e-6);
        COMPARE_NEAR(outlook.zeta_m2s - shortest_m2s, change.zeta_m2s, 1e-6);
        COMPARE_NEAR(outlook.changed_s, 60, 1e-9);

        desk.intervene(0.001); // plans again, the same
        desk.flyTo(100);
        QCOMPARE(desk.former(), kShortest);
        COMPARE_NEAR((*desk.picture().formerFrom_m - turn_m).norm(), 0, 1e-6);
        COMPARE_NEAR(planOutlook(desk.record())->change->zeta_m2s, change.zeta_m2s, 1e-9);
        desk.flyTo(530); // past the first three of the row, the last is still to be seen
        QCOMPARE(desk.former(), kShortest);
        desk.flyTo(560); // the last is reached: the way back is in another order, as planned anew
        QCOMPARE(desk.record().shown().plan->order.front(), 0);
        QCOMPARE(desk.former(), (std::vector<int>{2, 1, 0}));
        COMPARE_NEAR(planOutlook(desk.record())->changed_s, desk.record().shown().plan->time_s,
                     1e-9);
    }

    /** Only on the way to an iceberg that has appeared are the others seen, all of them. */
    void vanishesWhenAllOfItIsSeen()
    {
        Scenario scenario = test::emptySea(1000);
        scenario.uavs.front().fov_m = {80, 80};
        scenario.planner.tau = 0;
        for (int i = 0; i < 3; ++i)
            test::addIceberg(scenario, 3000.0 * (i + 1), 0, 14 - 3.0 * i);
        Mission mission(scenario);
        mission.advance(60);
        Iceberg far = scenario.icebergs.front();
        far.id = "far";
        far.position_m = {12000, 0};
        far.sigma0_m2 = 100;
        mission.intervene({.appears = far});
        mission.advance(400); // past two of the three
        QCOMPARE(missionPicture(recordOf(mission), QLocale::c()).formerPlan,
                 (std::vector<int>{0, 1, 2}));
        mission.advance(430); // past the third
        QCOMPARE(mission.plans().size(), std::size_t{2});
        QVERIFY(missionPicture(recordOf(mission), QLocale::c()).formerPlan.empty());
    }

    void lookingBack()
    {
        Desk desk;
        desk.flyTo(60);
        desk.intervene(0);
        desk.flyTo(560);
        const auto formerAt = [&](double time_s) {
            desk.workspace.lookAt(time_s);
            desk.waitFor(time_s);
            return desk.former();
        };
        QVERIFY(formerAt(59.9).empty());
        QCOMPARE(formerAt(60), kShortest);
        QCOMPARE(formerAt(300.3), kShortest);
        QCOMPARE(formerAt(559), (std::vector<int>{2, 1, 0}));
        QVERIFY(formerAt(10).empty());
    }

    /** A target is reached and the rest flown on with: nothing has changed. */
    void reachingATarget()
    {
        Scenario scenario = rowOfIcebergs();
        scenario.planner.policy = PolicyKind::Path;
        Desk desk;
        desk.open(scenario);
        desk.flyTo(300);
        QCOMPARE(desk.record().now.metrics.visits, 2);
        QVERIFY(desk.former().empty());
    }

    void predictionEndsAtWhatIsFlown()
    {
        Desk desk;
        desk.flyTo(1000);
        QCOMPARE(desk.record().now.phase, RunPhase::Finished);
        COMPARE_NEAR(planOutlook(desk.record())->zeta_m2s, desk.record().now.metrics.zeta_m2s,
                     1e-9);
    }

    /** Poses of the picture: all samples until the instant shown, and the instant itself. */
    void sweptUntilTheInstantShown()
    {
        Desk desk;
        QVERIFY(!desk.picture().showsSwept());
        desk.flyTo(20);
        QCOMPARE(desk.picture().swept.size(), std::size_t{21});
        desk.workspace.lookAt(10.4);
        desk.waitFor(10.4);
        const std::vector<MapPose> poses = desk.picture().swept;
        QCOMPARE(poses.size(), std::size_t{12});
        COMPARE_NEAR(poses.back().time_s, 10.4, 1e-9);
        QVERIFY(poses.back().position_m == desk.record().shown().world.uav.position_m);
    }
};

QTEST_MAIN(TestPlanChange)
#include "tst_plan_change.moc"
