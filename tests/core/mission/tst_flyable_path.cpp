#include "core/io/export/content/export_flight.h"
#include "core/mission/flyable_path.h"
#include "core/presets/presets.h"
#include "tests/support/approx.h"

#include <QTest>

#include <array>
#include <set>

using namespace berg;

namespace {

constexpr double kLate_s = 3; ///< tolerance for straight legs and whole turns

Scenario coverageScenario(int seed)
{
    Scenario scenario = randomScenario(seed);
    scenario.planner.policy = PolicyKind::Coverage;
    return scenario;
}

FlyablePath pathOf(const ExportSource& source, const UavPlan& order)
{
    return flyOrder(presentScene(source, 0), order, false);
}

/** Compares the first sightings with the times predicted by the plan, `now_s` after take-off. */
void compareSightings(const FlyablePath& path, const IcebergList& order,
                      const std::vector<double>& sightings_s, std::size_t count, double now_s)
{
    QVERIFY(sightings_s.size() >= count);
    QVERIFY(path.visits.size() >= count);
    for (std::size_t i = 0; i < count; ++i) {
        QCOMPARE(path.visits[i].iceberg, order[i]);
        COMPARE_NEAR(path.visits[i].time_s, sightings_s[i] - now_s, kLate_s);
    }
}

} // namespace

/** Orders flown for exports. Straight legs are tested with the content of exports. */
class TestFlyablePath : public QObject
{
    Q_OBJECT

private slots:
    void aimsAreFollowed_data()
    {
        QTest::addColumn<int>("seed");
        for (const int seed : {1, 2, 3, 4})
            QTest::addRow("seed %d", seed) << seed;
    }

    void aimsAreFollowed()
    {
        QFETCH(int, seed);
        const Scenario scenario = coverageScenario(seed);
        const Plan plan = planFromStart(scenario);
        const ExportSource source{.scenario = scenario, .plan = plan};
        const UavPlan order = presentPlan(source, 0);
        QVERIFY(order.legs == plan.uavs[0].legs);
        const FlyablePath path = pathOf(source, order);
        compareSightings(path, plan.uavs[0].order, plan.uavs[0].outlook->sightings_s,
                         plan.uavs[0].order.size(), 0);
        for (std::size_t i = 1; i < path.track.size(); ++i) {
            const TrackPoint& from = path.track[i - 1];
            const TrackPoint& to = path.track[i];
            const double step_m = (to.state.position_m - from.state.position_m).norm();
            QVERIFY(step_m <= 22.0 * (to.time_s - from.time_s) + 1e-6);
        }
    }

    /** The plan in force is followed from the UAV's present position and turn. */
    void aimsAreFollowedFromNowOn()
    {
        Scenario scenario = coverageScenario(2);
        for (Iceberg& iceberg : scenario.icebergs)
            iceberg.q_m2ps = 0; // no growth beyond the prediction
        const Plan start = planFromStart(scenario);
        Mission mission(scenario);
        mission.advance(137);
        const UavPlan& plan = *lastPlanOf(mission.plans(), 0)->of(0);
        const ExportSource source{.scenario = scenario, .plan = start, .mission = &mission};
        const UavPlan order = presentPlan(source, 0);
        QVERIFY(!order.legs.empty());
        const FlyablePath path = pathOf(source, order);
        QVERIFY(path.track.front().state.position_m == mission.simulation().uav(0).pose.position_m);
        // Later icebergs at the edge of the view may be seen one pass earlier or later.
        compareSightings(path, plan.order, plan.outlook->sightings_s, 6, 137);
    }

    /** Members of a cluster seen on the path to another iceberg are not visited again. */
    void everyIcebergIsVisitedOnce()
    {
        Scenario scenario = randomScenario(1, {.icebergs = 3});
        const std::array<Point, 3> places_m{Point(2500, 0), Point(2000, 250), Point(2000, 600)};
        for (std::size_t i = 0; i < places_m.size(); ++i) {
            scenario.icebergs[i].position_m = places_m[i];
            scenario.icebergs[i].velocity_mps = Point::Zero();
        }
        scenario.uavs[0].position_m = Point::Zero();
        scenario.uavs[0].heading_deg = 90;
        const FlyablePath path =
            flyOrder(scenario, {.order = {0, 1, 2}, .clusters = {{1, 2}}}, false);
        std::multiset<IcebergIndex> seen;
        for (const Visit& visit : path.visits)
            for (const IcebergIndex iceberg : icebergsOf(visit))
                seen.insert(iceberg);
        QVERIFY((seen == std::multiset<IcebergIndex>{0, 1, 2}));
    }

    /** Aimed legs for another airspeed are not used. */
    void anotherSpeedIsFlownStraight()
    {
        const Scenario scenario = coverageScenario(1);
        const Plan plan = planFromStart(scenario);
        const ExportSource source{.scenario = scenario, .plan = plan};
        const ExportContent slow =
            exportContent(source, {.what = ExportScope::Path, .airspeed_mps = 20});
        UavPlan order = presentPlan(source, 0);
        order.legs.clear();
        Scenario scene = presentScene(source, 0);
        scene.uavs.front().spec.airspeed_mps = 20;
        const FlyablePath straight = flyOrder(scene, order, false);
        QCOMPARE(slow.uavs.front().track.size(), straight.track.size());
        QVERIFY(slow.uavs.front().track.back().state.position_m ==
                straight.track.back().state.position_m);
    }
};

QTEST_APPLESS_MAIN(TestFlyablePath)
#include "tst_flyable_path.moc"
