#include "core/io/files/run_json.h"
#include "core/mission/mission_instant.h"
#include "core/presets/presets.h"
#include "core/scenario/limits.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/flight/flown_plans.h"

#include <QTest>

using namespace berg;
using namespace berg::test;

namespace {

Scenario withUavs(int uavs)
{
    Scenario s = randomScenario(4);
    const Uav first = s.uavs.front();
    s.uavs.clear();
    for (int i = 0; i < uavs; ++i) {
        s.uavs.push_back(first);
        s.uavs.back().id = "u" + std::to_string(i + 1);
        s.uavs.back().spec.altitude_m += kLayerHeight_m * i;
        s.uavs.back().position_m.y() += 800.0 * i;
        s.uavs.back().turnaround_s = 20;
    }
    return s;
}

Intervention command(const char* uav, FlightOrder order)
{
    return {.commanded = UavCommand{.uav = uav, .order = order}};
}

/** Reading, replaying and restoring give the same flight. */
void replays(const Mission& mission)
{
    const RunFile run = runFromJson(runToJson(runOf(mission)), "run");
    QVERIFY(run == runOf(mission));
    QVERIFY(runOf(replay(run)) == run);
    const double now_s = mission.simulation().time_s();
    QVERIFY(instantAt(mission, now_s).simulation.state() == mission.simulation().state());
}

} // namespace

/** Operator's orders to one UAV in flight. */
class TestFlightOrders : public QObject
{
    Q_OBJECT

private slots:
    void returnNow_data()
    {
        QTest::addColumn<double>("endurance_s");
        QTest::newRow("unlimited") << 0.0;
        QTest::newRow("limited") << 900.0;
    }

    void returnsWithASlowAutopilot_data()
    {
        QTest::addColumn<double>("wind_mps");
        QTest::newRow("calm") << 0.0;
        QTest::newRow("wind") << 15.0;
    }

    /** One command per minute would miss home for ever. */
    void returnsWithASlowAutopilot()
    {
        QFETCH(double, wind_mps);
        for (const double heading_deg : {0.0, 70.0, 140.0, 210.0, 290.0}) {
            Scenario s = randomScenario(4);
            s.duration_s = 2000;
            s.wind_mps = Point(wind_mps, 0);
            s.uavs.front().heading_deg = heading_deg;
            s.uavs.front().spec.autopilot_s = 60;
            Mission mission(s);
            mission.advance(333);
            mission.intervene(command(s.uavs.front().id.c_str(), FlightOrder::ReturnNow));
            mission.advance(s.duration_s);
            QVERIFY2(mission.simulation().uav(0).mode == FlightMode::Ground,
                     std::to_string(heading_deg).c_str());
            replays(mission);
        }
    }

    /** The UAV flies home, lands and stays there until an order to resume. */
    void returnNow()
    {
        QFETCH(double, endurance_s);
        Scenario s = withUavs(2);
        s.uavs[0].spec.endurance_s = endurance_s;
        s.uavs[0].home_m = Point(0, 0);
        Mission mission(s);
        mission.advance(60);
        const std::optional<IcebergIndex> target = mission.simulation().uav(0).target;
        QVERIFY(target);
        mission.intervene(command("u1", FlightOrder::ReturnNow));
        QCOMPARE(mission.simulation().uav(0).mode, FlightMode::Home);
        mission.advance(61);
        // Its remaining icebergs are planned for the other UAV at once.
        const test::FlownPlan plan = test::flownPlans(mission).back();
        QCOMPARE(plan.uav, 1);
        QCOMPARE(plan.time_s, 60.0);
        QVERIFY(std::ranges::find(plan.order, *target) != plan.order.end());
        mission.advance(300);
        QCOMPARE(mission.simulation().uav(0).mode, FlightMode::Ground);
        QVERIFY(mission.simulation().uav(0).pose.position_m.norm() < 80);
        mission.advance(500);
        QCOMPARE(mission.simulation().uav(0).mode, FlightMode::Ground);
        mission.intervene(command("u1", FlightOrder::None));
        mission.advance(510);
        QVERIFY(mission.simulation().uav(0).isPlanned());
        QVERIFY(mission.simulation().uav(0).target);
        replays(mission);
    }

    void resumedOnTheWayHome()
    {
        Mission mission(withUavs(1));
        mission.advance(100);
        mission.intervene(command("u1", FlightOrder::ReturnNow));
        mission.advance(110);
        QCOMPARE(mission.simulation().uav(0).mode, FlightMode::Home);
        mission.intervene(command("u1", FlightOrder::None));
        mission.advance(110.1);
        QCOMPARE(mission.simulation().uav(0).mode, FlightMode::Leg);
        const int visits = mission.metrics().visits;
        mission.advance(400);
        QVERIFY(mission.metrics().visits > visits + 2);
        replays(mission);
    }

    void holdHere()
    {
        Scenario s = withUavs(2);
        s.wind_mps = {4, 2};
        Mission mission(s);
        mission.advance(80);
        const Point here_m = mission.simulation().uav(0).pose.position_m;
        const IcebergIndex target = mission.simulation().uav(0).target.value();
        mission.intervene(command("u1", FlightOrder::HoldHere));
        for (double time_s = 81; time_s <= 300; time_s += 1) {
            mission.advance(time_s);
            const UavState& uav = mission.simulation().uav(0);
            QCOMPARE(uav.mode, FlightMode::Hold);
            QVERIFY((uav.pose.position_m - here_m).norm() < 400);
        }
        for (const test::FlownPlan& plan : test::flownPlans(mission))
            QVERIFY(plan.uav == 1 || plan.time_s <= 80);
        QVERIFY(std::ranges::any_of(mission.events(), [target](const MissionEvent& event) {
            return event.kind == EventKind::Sighted && event.iceberg == target && event.uav == 1;
        }));
        mission.intervene(command("u1", FlightOrder::None));
        mission.advance(301);
        QCOMPARE(mission.simulation().uav(0).mode, FlightMode::Leg);
        replays(mission);
    }

    /** The endurance has priority; on the ground the UAV stays. */
    void holdingEndsAtHome()
    {
        Scenario s = withUavs(1);
        s.uavs[0].spec.endurance_s = 400;
        Mission mission(s);
        mission.advance(50);
        mission.intervene(command("u1", FlightOrder::HoldHere));
        mission.advance(s.duration_s);
        QCOMPARE(mission.simulation().uav(0).mode, FlightMode::Ground);
        QVERIFY(std::ranges::none_of(mission.events(), [](const MissionEvent& event) {
            return event.kind == EventKind::LateHome || event.kind == EventKind::TookOff;
        }));
        replays(mission);
    }

    void nobodyIsRefused()
    {
        Mission mission(withUavs(1));
        mission.advance(10);
        QVERIFY_THROWS_EXCEPTION(Error, mission.intervene(command("u9", FlightOrder::HoldHere)));
        QVERIFY_THROWS_EXCEPTION(Error, mission.intervene(command("", FlightOrder::HoldHere)));
        QVERIFY(mission.interventions().empty());
    }
};

QTEST_APPLESS_MAIN(TestFlightOrders)
#include "tst_flight_orders.moc"
