#include "core/presets/presets.h"
#include "tests/support/approx.h"
#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/patience.h"
#include "widgets/map/picture/mission_picture.h"
#include "widgets/map/picture/scenario_picture.h"
#include "widgets/panels/plan/plan_model.h"
#include "widgets/panels/plan/plan_rows.h"
#include "widgets/workspace/workspace.h"

#include <QtTest>

using namespace berg;

namespace {

const MapPlaces kShortest{0, 1, 2, 3};
const MapPlaces kUncertainFirst{3, 2, 1, 0};

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

/** Returns the scenario planned with aim points. */
Scenario aimed()
{
    Scenario scenario = rowOfIcebergs();
    scenario.planner.policy = PolicyKind::Coverage;
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
    /** Flies to a time, then on to a whole number of seconds. */
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
    [[nodiscard]] MapPlaces former() const { return picture().routes[0].formerPlan; }
};

void searchesAreNoVisits(PlanSection section)
{
    section.name = u"uav-1"_s; // as in a fleet
    PlanModel model(QLocale::c());
    model.setPlan({section});
    const auto visits = std::ranges::count_if(
        section.rows, [](const PlanRow& row) { return row.searches.empty(); });
    const QModelIndex shown = model.index(0, PlanModel::Sigma);
    QVERIFY(shown.data().toString().startsWith(QString::number(visits) + u' '));
    std::erase_if(section.rows, [](const PlanRow& row) { return row.searches.empty(); });
    model.setPlan({section});
    QVERIFY(shown.data().toString().startsWith(u"0 "_s));
    QVERIFY(shown.siblingAtColumn(PlanModel::Leg).data().toString().contains(u'm'));
}

} // namespace

/** Changes by the plan shown: on the map and in figures. */
class TestPlanChange : public QObject
{
    Q_OBJECT

private slots:
    void tauBeforeTakeOff()
    {
        Desk desk;
        QCOMPARE(desk.picture().routes[0].plan, kShortest);
        QVERIFY(desk.former().empty());
        desk.setTau(40); // the same order
        QVERIFY(desk.former().empty());
        desk.setTau(0);
        QCOMPARE(desk.picture().routes[0].plan, kUncertainFirst);
        QCOMPARE(desk.former(), kShortest);
        QVERIFY(
            !desk.picture().routes[0].formerFrom_m); // from where the UAV is, wherever it is put
        desk.setTau(0.001);                          // the drag goes on, the order stays
        QCOMPARE(desk.former(), kShortest);
        desk.setTau(50);
        QCOMPARE(desk.former(), kUncertainFirst);
    }

    /** Rows of a plan with aim points have the times and zeta that it was made for. */
    void planWithAimPoints()
    {
        Desk desk;
        desk.open(aimed());
        const UavPlan plan = desk.record().now.plan->uavs[0];
        const std::vector<PlanRow> rows =
            planSections(desk.record().now, desk.record().scenario).front().rows;
        QCOMPARE(rows.size(), plan.order.size());
        double path_m = 0;
        for (std::size_t k = 0; k < rows.size(); ++k) {
            QVERIFY(rows[k].isSeen);
            COMPARE_NEAR(rows[k].arrival_s, plan.outlook->sightings_s[k], 1e-9);
            QVERIFY(rows[k].arrivalSigma_m2 > rows[k].sigma_m2);
            path_m += rows[k].leg_m;
            COMPARE_NEAR(path_m, 22 * rows[k].arrival_s, 1); // turns are cut into chords
        }
        const PlanOutlook outlook = planOutlook(desk.record()).value();
        QVERIFY(outlook.isAimed && !outlook.change && !outlook.until_s);
        COMPARE_NEAR(outlook.zeta_m2s, plan.outlook->zeta_m2s, 1e-9);

        desk.flyTo(60); // the same plan, nearer by the distance flown
        COMPARE_NEAR(planOutlook(desk.record())->zeta_m2s, outlook.zeta_m2s, 1e-9);
        const std::vector<PlanRow> later =
            planSections(desk.record().now, desk.record().scenario).front().rows;
        COMPARE_NEAR(later[0].arrival_s, rows[0].arrival_s - 60, 1e-9);
        COMPARE_NEAR(later[0].leg_m, rows[0].leg_m - 60 * 22, 3);
    }

    /** Legs that search for lost icebergs are listed and drawn, with times and chances. */
    void searchesAreShown()
    {
        Scenario scenario = randomScenario(1, {.icebergs = 6});
        scenario.planner.policy = PolicyKind::Coverage;
        scenario.observer.model = ObserverModel::Kalman;
        for (Iceberg& iceberg : scenario.icebergs)
            iceberg.velocitySd_mps = 0.8;
        Desk desk;
        desk.open(scenario);
        const auto searches = [&] { return desk.record().now.plan->uavs[0].outlook->searches; };
        QVERIFY(searches().empty() && desk.picture().routes[0].searchPlaces.empty());
        for (int time_s = 20; searches().empty() && time_s < 1000; time_s += 20)
            desk.flyTo(time_s);
        QVERIFY(!searches().empty());
        const MissionSnapshot& now = desk.record().now;
        const std::vector<PlanSection> sections = planSections(now, scenario);
        std::size_t shown = 0;
        for (const PlanRow& row : sections.front().rows) {
            if (row.searches.empty())
                continue;
            double chance = 0;
            for (const PlannedSearch& search : row.searches) {
                const std::size_t iceberg = toIndex(search.iceberg);
                QCOMPARE(now.icebergs[iceberg].id, row.id);
                QVERIFY(now.world.tracks[iceberg].status == TrackStatus::Lost);
                QVERIFY(search.time_s > 0 && now.time_s + search.time_s <= 1000);
                chance += search.chance;
            }
            COMPARE_NEAR(*row.chance, chance, 1e-12);
            QVERIFY(chance > 0 && chance <= 1);
            shown += row.searches.size();
        }
        QCOMPARE(shown, searches().size());
        const auto isBefore = [](const PlanRow& a, const PlanRow& b) {
            return a.isSeen && (!b.isSeen || a.arrival_s < b.arrival_s);
        };
        QVERIFY(std::ranges::is_sorted(sections.front().rows, isBefore));
        QCOMPARE(desk.picture().routes[0].searchPlaces.size(), searches().size());

        PlanModel model(QLocale::c());
        model.setPlan(sections);
        QVERIFY(model.mayMiss());
        for (int row = 0; row < model.rowCount(); ++row) {
            const bool isSearch =
                !sections.front().rows[static_cast<std::size_t>(row)].searches.empty();
            const QModelIndex name = model.index(row, PlanModel::Name);
            QCOMPARE(name.data().toString().endsWith(u"(search)"_s), isSearch);
            QCOMPARE(name.data(Qt::ToolTipRole).toString().contains(u"searched for in"_s),
                     isSearch);
        }
        searchesAreNoVisits(sections.front());
    }

    /** The prediction of a long run ends before the run does. */
    void aimedPlansOfLongRunsLookAsFarAsTheyAreMade()
    {
        Scenario scenario = aimed();
        scenario.duration_s = 5000;
        Desk desk;
        desk.open(scenario);
        QCOMPARE(planOutlook(desk.record())->until_s, std::optional(800.0));
    }

    /** The map shows the legs as they are flown, and those of the former plan. */
    void mapShowsThePaths()
    {
        Desk desk;
        QVERIFY(desk.picture().routes[0].planPaths.empty());
        desk.open(aimed());
        const MapPicture picture = desk.picture();
        QVERIFY(!picture.routes[0].planPaths.empty());
        QVERIFY(picture.routes[0].planPaths.front().path_m.front() == Point(0, 0));
        for (std::size_t k = 1; k < picture.routes[0].planPaths.size(); ++k)
            COMPARE_NEAR((picture.routes[0].planPaths[k].path_m.front() -
                          picture.routes[0].planPaths[k - 1].path_m.back())
                             .norm(),
                         0, 1e-6);
        QVERIFY(!withScenario(picture, desk.record().scenario).routes[0].planPaths.empty());
        Scenario moved = desk.record().scenario;
        moved.icebergs[1].position_m.x() += 100; // the icebergs differ from those of the plan
        QVERIFY(withScenario(picture, moved).routes[0].planPaths.empty());
        QCOMPARE(withScenario(picture, moved).routes[0].plan, picture.routes[0].plan);

        desk.workspace.setPolicy(PolicyKind::Uncertainty);
        desk.wait();
        QCOMPARE(desk.picture().routes[0].plan, kUncertainFirst);
        QVERIFY(desk.picture().routes[0].planPaths.empty());
        QCOMPARE(desk.picture().routes[0].formerPaths.size(), picture.routes[0].planPaths.size());
        QVERIFY(!planOutlook(desk.record())->change); // nothing to be compared with
    }

    void mapShowsThePathsInFlight()
    {
        Desk desk;
        desk.open(aimed());
        const std::size_t count = desk.picture().routes[0].planPaths.size();
        desk.flyTo(20);
        QCOMPARE(desk.record().now.planCount, std::size_t{1}); // on its first leg
        MapPicture picture = desk.picture();
        QCOMPARE(picture.routes[0].planPaths.size(), count);
        QVERIFY(picture.routes[0].planPaths.front().path_m.front() == picture.uavs[0].position_m);
        const Point turn_m = picture.uavs[0].position_m;
        const std::size_t plans = desk.record().now.planCount;
        desk.workspace.setPolicy(PolicyKind::Uncertainty);
        QTRY_VERIFY(desk.record().now.planCount > plans);
        picture = desk.picture();
        QVERIFY(picture.routes[0].planPaths.empty());
        QVERIFY(!picture.routes[0].formerPaths.empty()); // from where it was left
        COMPARE_NEAR((picture.routes[0].formerPaths.front().path_m.front() - turn_m).norm(), 0, 3);
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
        QCOMPARE(outlook.before, QStringLiteral("berg-1, berg-2, berg-3, berg-4"));
    }

    /** Changes of two UAVs are summed, with the remaining icebergs of each. */
    void changeOfAFleet()
    {
        Desk desk;
        Scenario scenario = rowOfIcebergs();
        scenario.uavs.push_back(scenario.uavs.front());
        scenario.uavs[1].id = "uav-2";
        scenario.uavs[1].position_m.x() += 20000;
        desk.open(scenario);
        const double shortest_m2s = planOutlook(desk.record())->zeta_m2s;
        desk.setTau(0);
        const PlanOutlook outlook = planOutlook(desk.record()).value();
        double distance_m = 0;
        QStringList before;
        for (const int uav : {0, 1})
            if (const std::optional<ShownChange> change = desk.record().changeShown(uav)) {
                distance_m += change->change.distance_m;
                before << QStringLiteral("uav-%1: ").arg(uav + 1);
                COMPARE_NEAR(outlook.zeta_m2s - shortest_m2s, change->change.zeta_m2s, 1e-6);
            }
        QVERIFY(!before.isEmpty());
        COMPARE_NEAR(outlook.change->distance_m, distance_m, 1e-9);
        for (const QString& part : before)
            QVERIFY2(outlook.before.contains(part), qPrintable(outlook.before));
        QCOMPARE(outlook.before.count(QStringLiteral("; ")), before.size() - 1);
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

    void changeInFlightIsShown()
    {
        Desk desk;
        desk.flyTo(60);
        const double shortest_m2s = planOutlook(desk.record())->zeta_m2s;
        desk.intervene(0);
        QCOMPARE(desk.former(), kShortest);
        const Point turn_m = desk.record().now.world.uavs[0].pose.position_m;
        const PlanOutlook outlook = planOutlook(desk.record()).value();
        const PlanChange change = outlook.change.value();
        COMPARE_NEAR(change.distance_m, 9000, 1e-6);
        COMPARE_NEAR(outlook.zeta_m2s - shortest_m2s, change.zeta_m2s, 1e-6);
        COMPARE_NEAR(outlook.changed_s, 60, 1e-9);

        desk.intervene(0.001); // plans again, the same
        desk.flyTo(100);
        QCOMPARE(desk.former(), kShortest);
        COMPARE_NEAR((*desk.picture().routes[0].formerFrom_m - turn_m).norm(), 0, 1e-6);
        COMPARE_NEAR(planOutlook(desk.record())->change->zeta_m2s, change.zeta_m2s, 1e-9);
        desk.flyTo(530); // past the first three of the row, the last is still to be seen
        QCOMPARE(desk.former(), kShortest);
        desk.flyTo(560); // the last is reached: the return has another order, as re-planned
        QCOMPARE(desk.record().shown().plan->uavs[0].order.front(), IcebergIndex(0));
        QCOMPARE(desk.former(), (MapPlaces{2, 1, 0}));
        COMPARE_NEAR(planOutlook(desk.record())->changed_s, desk.record().shown().plan->time_s,
                     1e-9);
    }

    /** The others, and all of them, come into view only on the path to an iceberg that appeared. */
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
        QCOMPARE(missionPicture(recordOf(mission), QLocale::c()).routes[0].formerPlan,
                 (MapPlaces{0, 1, 2}));
        mission.advance(430); // past the third
        QCOMPARE(mission.plans().size(), std::size_t{2});
        QVERIFY(missionPicture(recordOf(mission), QLocale::c()).routes[0].formerPlan.empty());
    }

    void changeOfTheInstantLookedAtIsShown()
    {
        Desk desk;
        desk.flyTo(60);
        desk.intervene(0);
        desk.flyTo(560);
        const auto formerAt = [&](double time_s) {
            desk.workspace.seek(time_s);
            desk.waitFor(time_s);
            return desk.former();
        };
        QVERIFY(formerAt(59.9).empty());
        QCOMPARE(formerAt(60), kShortest);
        QCOMPARE(formerAt(300.3), kShortest);
        QCOMPARE(formerAt(559), (MapPlaces{2, 1, 0}));
        QVERIFY(formerAt(10).empty());
    }

    /** Reaching a target and flying the rest changes nothing. */
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

    /** The picture has all samples until the instant shown, and that instant. */
    void sweptUntilTheInstantShown()
    {
        Desk desk;
        QVERIFY(!desk.picture().showsSwept());
        desk.flyTo(20);
        QCOMPARE(desk.picture().routes[0].swept->size(), std::size_t{21});
        desk.workspace.seek(10.4);
        desk.waitFor(10.4);
        const std::vector<MapPose> poses = *desk.picture().routes[0].swept;
        QCOMPARE(poses.size(), std::size_t{12});
        COMPARE_NEAR(poses.back().time_s, 10.4, 1e-9);
        QVERIFY(poses.back().position_m == desk.record().shown().world.uavs[0].pose.position_m);
    }
};

QTEST_MAIN(TestPlanChange)
#include "tst_plan_change.moc"
