#include "core/mission/visits.h"
#include "tests/support/flight/mission_builder.h"

#include <QTest>

#include <cmath>

using namespace berg;
using namespace berg::test;

namespace {

/** Error of a visit: distance to the iceberg, and difference in distance flown through the air. */
struct Miss
{
    double iceberg_m = 0;
    double flight_m = 0;
};

/**
 * Independent of the flight-time formula: over a leg of t seconds the path through the air, ground
 * track less wind drift, has length U t.
 */
Miss missOf(const Scenario& scenario, const Visit& last, const Visit& visit)
{
    const Iceberg& iceberg = scenario.icebergs[toIndex(visit.iceberg.value())];
    const double time_s = iceberg.velocityTime_s;
    const double carried_s =
        time_s > 0 ? time_s * (1 - std::exp(-visit.time_s / time_s)) : visit.time_s;
    const Point there_m =
        iceberg.position_m + scenario.current_mps * visit.time_s + iceberg.velocity_mps * carried_s;
    const double leg_s = visit.time_s - last.time_s;
    const Point air_m = visit.position_m - last.position_m - scenario.wind_mps * leg_s;
    return {.iceberg_m = (visit.position_m - there_m).norm(),
            .flight_m = std::abs(air_m.norm() - scenario.uavs[0].spec.airspeed_mps * leg_s)};
}

/** Smaller positive root of |d + v t|^2 = (U t)^2 with U > |v|. */
double closedForm_s(const Point& d_m, const Point& v_mps, double airspeed_mps)
{
    const double a = airspeed_mps * airspeed_mps - v_mps.squaredNorm();
    const double b = d_m.dot(v_mps);
    return (b + std::sqrt(b * b + a * d_m.squaredNorm())) / a;
}

} // namespace

class TestVisits : public QObject
{
    Q_OBJECT

private slots:
    void plannedVisitsMeetTheIcebergs_data()
    {
        QTest::addColumn<double>("windEast_mps");
        QTest::addColumn<double>("windNorth_mps");
        QTest::addColumn<double>("currentEast_mps");
        QTest::addColumn<double>("velocityTime_s");
        QTest::newRow("calm") << 0.0 << 0.0 << 0.0 << 0.0;
        QTest::newRow("current") << 0.0 << 0.0 << 1.5 << 0.0;
        QTest::newRow("head wind") << -15.0 << 0.0 << 0.1 << 0.0;
        QTest::newRow("cross wind") << 3.0 << 17.0 << -0.4 << 0.0;
        QTest::newRow("velocities that fade") << 3.0 << 7.0 << -0.4 << 100.0;
    }

    void plannedVisitsMeetTheIcebergs()
    {
        QFETCH(double, windEast_mps);
        QFETCH(double, windNorth_mps);
        QFETCH(double, currentEast_mps);
        QFETCH(double, velocityTime_s);
        Scenario scenario = fourIcebergs();
        scenario.wind_mps = Point(windEast_mps, windNorth_mps);
        scenario.current_mps = Point(currentEast_mps, 0);
        scenario.observer.model = ObserverModel::Kalman;
        for (Iceberg& iceberg : scenario.icebergs)
            iceberg.velocityTime_s = velocityTime_s;
        const std::vector<Visit> visits = plannedVisits(scenario, fourIcebergPlan());
        QCOMPARE(visits.size(), std::size_t{4});
        Visit last{.position_m = scenario.uavs[0].position_m};
        for (const Visit& visit : visits) {
            const Miss miss = missOf(scenario, last, visit);
            QVERIFY(visit.time_s > last.time_s);
            // Rounding of positions of some kilometres.
            QVERIFY2(miss.iceberg_m < 1e-9 && miss.flight_m < 1e-9, "does not meet");
            last = visit;
        }
    }

    void firstMeetingByQuadratic()
    {
        Scenario scenario = fourIcebergs();
        scenario.icebergs[0].velocity_mps = Point(-2, 3.5);
        scenario.current_mps = Point::Zero();
        const Visit visit = plannedVisits(scenario, planOf({0})).at(0);
        const Point d_m = scenario.icebergs[0].position_m - scenario.uavs[0].position_m;
        const double expected_s = closedForm_s(d_m, Point(-2, 3.5), 22);
        QVERIFY(std::abs(visit.time_s - expected_s) < 1e-9 * expected_s); // rounding
        QVERIFY((visit.position_m - (Point(2000, 1000) + Point(-2, 3.5) * expected_s)).norm() <
                1e-6);
    }

    void closedRouteComesBack()
    {
        Scenario scenario = fourIcebergs();
        scenario.planner.route = Route::Closed;
        QCOMPARE(plannedVisits(scenario, planOf({0, 1})).size(), std::size_t{2}); // nearest
        scenario.planner.policy = PolicyKind::Visitation;
        const std::vector<Visit> visits = plannedVisits(scenario, planOf({0, 1}));
        QCOMPARE(visits.size(), std::size_t{3});
        QVERIFY(!visits[2].iceberg);
        QVERIFY(visits[2].position_m == scenario.uavs[0].position_m);
        const double back_s = (visits[1].position_m - visits[2].position_m).norm() / 22;
        QVERIFY(std::abs(visits[2].time_s - visits[1].time_s - back_s) < 1e-9);
        QVERIFY(plannedVisits(scenario, planOf({})).empty());
    }

    /** An exported plan covers one sortie and ends at home. */
    void enduranceEndsAtHome()
    {
        Scenario scenario = fourIcebergs();
        scenario.uavs[0].spec.endurance_s = 1e6;
        scenario.uavs[0].home_m = Point(50, -70);
        const std::vector<Visit> all = plannedVisits(scenario, planOf({0, 1, 2, 3}));
        QCOMPARE(all.size(), std::size_t{5});
        QVERIFY(!all[4].iceberg);
        QVERIFY(all[4].position_m == Point(50, -70));
        const double back_s =
            flightTime_s(all[4].position_m - all[3].position_m, 22, scenario.wind_mps);
        QVERIFY(std::abs(all[4].time_s - all[3].time_s - back_s) < 1e-9);

        // The endurance is just too short for the last iceberg, turns and reserves included.
        scenario.uavs[0].spec.endurance_s = all[4].time_s;
        const std::vector<Visit> fewer = plannedVisits(scenario, planOf({0, 1, 2, 3}));
        QVERIFY(fewer.size() < all.size());
        QVERIFY(!fewer.back().iceberg);
        QVERIFY(fewer.back().time_s < scenario.uavs[0].spec.endurance_s);

        scenario.uavs[0].spec.endurance_s = 1;
        QCOMPARE(plannedVisits(scenario, planOf({0, 1})).size(), std::size_t{1});
    }

    void icebergFasterThanTheUavIsTakenAsStill()
    {
        Scenario scenario = fourIcebergs();
        scenario.uavs[0].spec.airspeed_mps = 2;
        scenario.icebergs[0].velocity_mps = Point(5, 0);
        const std::vector<Visit> visits = plannedVisits(scenario, planOf({0, 2}));
        QCOMPARE(visits.size(), std::size_t{2});
        QVERIFY(visits[0].position_m == scenario.icebergs[0].position_m);
        const double leg_m = (visits[0].position_m - scenario.uavs[0].position_m).norm();
        QVERIFY(std::abs(visits[0].time_s - leg_m / 2) < 1e-9);
        QVERIFY(std::isfinite(visits[1].time_s));
    }

    void icebergUnderTheUavTakesNoTime()
    {
        Scenario scenario = fourIcebergs();
        scenario.icebergs[0].position_m = scenario.uavs[0].position_m;
        QCOMPARE(plannedVisits(scenario, planOf({0})).at(0).time_s, 0.0);
    }

    /** Visits are at the simulation's true positions at the instant of each event. */
    void flownVisitsAreAtTruePositions_data()
    {
        QTest::addColumn<double>("dt_s");
        QTest::addColumn<bool>("noise");
        QTest::newRow("default") << 0.1 << true;
        QTest::newRow("coarse step") << 1.0 << true;
        QTest::newRow("step that does not divide a second") << 0.3 << true;
        QTest::newRow("no noise") << 0.1 << false;
    }

    void flownVisitsAreAtTruePositions()
    {
        QFETCH(double, dt_s);
        QFETCH(bool, noise);
        Scenario scenario = fourIcebergs();
        scenario.duration_s = 1000;
        scenario.dt_s = dt_s;
        scenario.noise = noise;
        Mission mission(scenario);
        Iceberg added;
        added.id = "added";
        added.position_m = Point(2600, 1800);
        added.velocity_mps = Point(0.3, 0.3);
        std::vector<Visit> expected;
        std::size_t seen = 0;
        for (double time_s = dt_s; !mission.simulation().finished(); time_s += dt_s) {
            mission.advance(time_s);
            if (mission.interventions().empty() && time_s > 60)
                mission.intervene({.appears = added});
            for (; seen < mission.events().size(); ++seen) {
                const MissionEvent& event = mission.events()[seen];
                if (event.kind == EventKind::Reached)
                    expected.push_back(
                        {.iceberg = event.iceberg,
                         .time_s = mission.simulation().time_s(),
                         .position_m = mission.simulation().truth_m(*event.iceberg)});
            }
        }
        const std::vector<Visit> visits = flownVisits(mission);
        QCOMPARE(visits.size(), expected.size());
        QVERIFY(visits.size() >= 5);
        bool metTheAdded = false;
        for (std::size_t i = 0; i < visits.size(); ++i) {
            QCOMPARE(visits[i].iceberg, expected[i].iceberg);
            QCOMPARE(visits[i].time_s, expected[i].time_s);
            QVERIFY(visits[i].position_m == expected[i].position_m); // the same arithmetic
            metTheAdded = metTheAdded || visits[i].iceberg == IcebergIndex(4);
        }
        QVERIFY(metTheAdded);
    }

    void missionWithoutRecordHasNoVisits()
    {
        Mission mission(fourIcebergs(), {.record = false});
        mission.advance(1e9);
        QVERIFY(mission.metrics().visits > 0);
        QVERIFY(flownVisits(mission).empty());
    }
};

QTEST_APPLESS_MAIN(TestVisits)
#include "tst_visits.moc"
