#include "core/io/export/missions/mission_items.h"
#include "tests/support/flight/mission_builder.h"

#include <QTest>

using namespace berg;
using namespace berg::test;

class TestMissionItems : public QObject
{
    Q_OBJECT

private slots:
    void acceptanceRadiusFitsTheFieldOfView_data()
    {
        QTest::addColumn<double>("along_m");
        QTest::addColumn<double>("across_m");
        QTest::addColumn<int>("shape");
        QTest::addColumn<double>("reach_m");
        QTest::addColumn<double>("expected_m");
        const int body = static_cast<int>(FovShape::Body);
        const int disk = static_cast<int>(FovShape::Disk);
        QTest::newRow("default is cut to 8 bits") << 600.0 << 600.0 << body << 0.0 << 255.0;
        QTest::newRow("half the smaller extent") << 600.0 << 301.0 << body << 0.0 << 150.0;
        QTest::newRow("disk: first extent only") << 400.0 << 100.0 << disk << 0.0 << 200.0;
        QTest::newRow("reach radius wins") << 600.0 << 600.0 << body << 80.5 << 80.0;
        QTest::newRow("large reach radius") << 600.0 << 600.0 << body << 1000.0 << 255.0;
        QTest::newRow("never 0, the autopilot's default") << 600.0 << 600.0 << body << 0.4 << 1.0;
    }

    void acceptanceRadiusFitsTheFieldOfView()
    {
        QFETCH(double, along_m);
        QFETCH(double, across_m);
        QFETCH(int, shape);
        QFETCH(double, reach_m);
        QFETCH(double, expected_m);
        Scenario scenario = fourIcebergs();
        scenario.uavs[0].fov_m = Point(along_m, across_m);
        scenario.fovShape = static_cast<FovShape>(shape);
        if (reach_m > 0)
            scenario.reachRadius_m = reach_m;
        QCOMPARE(acceptanceRadius_m(planContent(scenario).uavs[0]), expected_m);
    }

    void loiterRadiusIsNeverBelowTheTightestTurn_data()
    {
        QTest::addColumn<double>("airspeed_mps");
        QTest::addColumn<double>("bank_deg");
        QTest::addColumn<double>("wind_mps");
        QTest::addColumn<double>("expected_m");
        // U^2 / (9.81 tan(bank)), computed by hand: 105.81, 210.05, 257.35, 423.2 m.
        QTest::newRow("default, rounded up") << 22.0 << 25.0 << 0.0 << 106.0;
        QTest::newRow("faster") << 31.0 << 25.0 << 0.0 << 211.0;
        QTest::newRow("above 255 m in steps of 10") << 34.31 << 25.0 << 0.0 << 260.0;
        QTest::newRow("wind of the airspeed: four times") << 22.0 << 25.0 << 21.99 << 430.0;
        QTest::newRow("never 0") << 1.0 << 45.0 << 0.0 << 1.0;
    }

    void loiterRadiusIsNeverBelowTheTightestTurn()
    {
        QFETCH(double, airspeed_mps);
        QFETCH(double, bank_deg);
        QFETCH(double, wind_mps);
        QFETCH(double, expected_m);
        Scenario scenario = fourIcebergs();
        scenario.uavs[0].spec.airspeed_mps = airspeed_mps;
        scenario.uavs[0].spec.maxBank_deg = bank_deg;
        scenario.wind_mps = Point(0, wind_mps);
        QCOMPARE(loiterRadius_m(planContent(scenario).uavs[0]), expected_m);
    }

    /** A plan with endurance ends at home, the home of the file. */
    void enduranceEndsAtHome()
    {
        Scenario scenario = fourIcebergs();
        scenario.uavs[0].spec.endurance_s = 1e6;
        scenario.uavs[0].home_m = Point(500, -700);
        scenario.uavs[0].aircraft.end = MissionEnd::Loiter;
        const Plan plan = planFromStart(scenario);
        const MavMission mission = mavMission(planContent(scenario, plan));
        QCOMPARE(mission.items.size(), plan.uavs[0].order.size() + 3);
        QCOMPARE(mission.items.back().command, LinkCommandId::kLoiterUnlimited);
        QVERIFY(mission.items.back().place == mission.home);
        const Point home_m = LocalFrame(scenario.origin).toPlane(mission.home);
        QVERIFY((home_m - Point(500, -700)).norm() < 0.1);

        scenario.uavs[0].spec.endurance_s = 60; // too short for any visit
        const MavMission none = mavMission(planContent(scenario, plan));
        QCOMPARE(none.items.size(), std::size_t{3});
    }

    /** A UAV in flight needs no take-off; a flight exported as a whole does. */
    void takeOffIsForUavsOnTheGround()
    {
        const Mission mission = flown(fourIcebergs(), 60);
        const MavMission left = mavMission(runContent(mission, {.what = ExportScope::Order}));
        QCOMPARE(left.items.front().command, LinkCommandId::kChangeSpeed);
        const MavMission whole = mavMission(runContent(mission, {.what = ExportScope::Track}));
        QCOMPARE(whole.items.front().command, LinkCommandId::kTakeOff);
    }
};

QTEST_APPLESS_MAIN(TestMissionItems)
#include "tst_mission_items.moc"
