#include "core/checks/validate.h"
#include "core/mission/mission_instant.h"
#include "core/scenario/limits.h"
#include "tests/support/flight/fleet_case.h"
#include "tests/support/flight/scenario_builder.h"

#include <QTest>

using namespace berg;
using namespace berg::test;

namespace {

/** Two UAVs of one layer, each with an iceberg of its own. */
Scenario pairOf(const Point& second_m, double heading_deg)
{
    Scenario s = emptySea(600);
    Uav other = s.uavs.front();
    other.id = "uav-b";
    other.position_m = second_m;
    other.heading_deg = heading_deg;
    s.uavs.push_back(other);
    addIceberg(s, 6000, 0).uav = s.uavs.front().id;
    addIceberg(s, -2000, 0).uav = "uav-b";
    return s;
}

/** Least distance from `from_s` on. */
double leastFrom_s(const Scenario& s, double from_s)
{
    double least_m = 1e9;
    Mission mission(s, {.record = false});
    while (!mission.simulation().finished()) {
        mission.advance(mission.simulation().time_s() + s.dt_s);
        const Fleet& fleet = mission.simulation().fleet();
        if (mission.simulation().time_s() >= from_s && !fleet.autopilot(0).isOnGround() &&
            !fleet.autopilot(1).isOnGround())
            least_m = std::min(least_m, (fleet.autopilot(0).pose().position_m -
                                         fleet.autopilot(1).pose().position_m)
                                            .norm());
    }
    return least_m;
}

} // namespace

/** UAVs in one altitude layer. */
class TestSeparation : public QObject
{
    Q_OBJECT

private slots:
    /**
     * Flies BERGWATCH_FLEET_CASES fleets. Without separation the closest two passed at less than 1
     * m. A few UAVs wait for long where there are too few icebergs.
     */
    void randomFleetsKeepTheirDistance()
    {
        const int cases = qEnvironmentVariableIntValue("BERGWATCH_FLEET_CASES");
        int left = cases > 0 ? cases : 40;
        for (int seed = 1; left > 0; ++seed) {
            const Scenario s = FleetCase(seed).scenario();
            if (s.uavs.size() < 2 || hasErrors(validate(s)))
                continue;
            --left;
            const FleetOutcome flight = flownFleet(s);
            QVERIFY2(flight.least_m >= s.separation_m,
                     qPrintable(QString("case %1: %2 m").arg(seed).arg(flight.least_m)));
            QVERIFY2(flight.isInside, qPrintable(QString("case %1: outside").arg(seed)));
            QVERIFY2(flight.longest_s < 1200,
                     qPrintable(QString("case %1: %2 s").arg(seed).arg(flight.longest_s)));
        }
    }

    /**
     * UAVs on the path home turned to the pad side by side for a thousand seconds; others circled
     * in the path of one that had to land.
     */
    void noneIsKeptFromHome_data()
    {
        QTest::addColumn<int>("seed");
        for (const int seed : {393, 572, 638, 705})
            QTest::newRow(qPrintable(QString::number(seed))) << seed;
    }

    void noneIsKeptFromHome()
    {
        QFETCH(int, seed);
        const FleetOutcome flight = flownFleet(FleetCase(seed).scenario());
        QVERIFY(flight.landings > 5);
        QCOMPARE(flight.spent, 0);
    }

    void twoOnOppositeCoursesPass()
    {
        const Scenario s = pairOf({4000, 0}, 270);
        QVERIFY(leastFrom_s(s, 0) >= s.separation_m);
        Mission mission(s);
        mission.advance(s.duration_s);
        QVERIFY(std::ranges::none_of(mission.events(), [](const MissionEvent& event) {
            return event.kind == EventKind::Close;
        }));
        for (const int uav : {0, 1})
            QVERIFY(std::ranges::any_of(mission.events(), [uav](const MissionEvent& event) {
                return event.kind == EventKind::Reached && event.uav == uav && event.time_s < 300;
            }));
        // The restored flight is the same.
        Mission until(s);
        until.advance(95);
        QVERIFY(instantAt(mission, 95).simulation.state() == until.simulation().state());
    }

    void thoseThatStartTooNearGetApart_data()
    {
        QTest::addColumn<double>("east_m");
        QTest::addColumn<double>("north_m");
        QTest::addColumn<double>("heading_deg");
        QTest::newRow("at one place") << 0.0 << 0.0 << 90.0;
        QTest::newRow("side by side") << 0.0 << 50.0 << 90.0;
        QTest::newRow("behind") << -60.0 << 0.0 << 90.0;
        QTest::newRow("towards each other") << 150.0 << 0.0 << 270.0;
    }

    /** An event reports it; within a minute they are apart and stay so. */
    void thoseThatStartTooNearGetApart()
    {
        QFETCH(double, east_m);
        QFETCH(double, north_m);
        QFETCH(double, heading_deg);
        const Scenario s = pairOf({east_m, north_m}, heading_deg);
        const double least_m = leastFrom_s(s, 60);
        QVERIFY2(least_m >= s.separation_m, qPrintable(QString::number(least_m)));
        Mission mission(s);
        mission.advance(10);
        QVERIFY(std::ranges::any_of(mission.events(), [](const MissionEvent& event) {
            return event.kind == EventKind::Close && event.time_s <= 0.2;
        }));
    }

    /** On one pad the second UAV takes off when the first has left. */
    void onePadIsUsedInTurn()
    {
        Scenario s = pairOf({0, 1500}, 90);
        s.duration_s = 3000;
        for (Uav& uav : s.uavs) {
            uav.spec.endurance_s = 800;
            uav.turnaround_s = 60;
            uav.home_m = Point(0, 0);
        }
        s.icebergs[0].position_m = {3000, 0};
        QVERIFY(leastFrom_s(s, 0) >= s.separation_m);
        Mission mission(s);
        mission.advance(s.duration_s);
        int takeOffs = 0;
        for (const MissionEvent& event : mission.events())
            takeOffs += event.kind == EventKind::TookOff ? 1 : 0;
        QVERIFY(takeOffs >= 4);
    }

    /** UAVs alone in their layer or at sea fly as without separation. */
    void nobodyElseIsTouched()
    {
        for (const int seed : {1, 2}) {
            Scenario s = randomScenario(seed);
            s.duration_s = 300;
            s.uavs.push_back(s.uavs.front());
            s.uavs.back().id = "other";
            s.uavs.back().spec.altitude_m += kLayerHeight_m;
            Mission watched(s);
            watched.advance(s.duration_s);
            s.separation_m = 0;
            Mission unwatched(s);
            unwatched.advance(s.duration_s);
            QVERIFY(watched.simulation().state() == unwatched.simulation().state());
        }
    }

    /** Poses from outside are not commanded; there is only the event. */
    void posesFromOutsideAreOnlyWatched()
    {
        Scenario s = emptySea(60);
        s.uavs.push_back(s.uavs.front());
        s.uavs.back().id = "uav-b";
        s.uavs.back().position_m = {1000, 0};
        Simulation simulation(s);
        std::vector<MissionEvent> close;
        for (int step = 0; step < 400; ++step) {
            for (const int uav : {0, 1})
                simulation.setTarget(uav, std::nullopt);
            const double x_m = 2.2 * step;
            const auto at = [](double east_m) {
                return std::optional(ExternalPose{.pose = {.position_m = {east_m, 0}}});
            };
            simulation.advanceStep(std::array{at(x_m), at(1000)});
            QVERIFY(simulation.uav(0).pose.position_m == Point(x_m, 0));
            std::ranges::copy_if(
                simulation.drainEvents(), std::back_inserter(close),
                [](const MissionEvent& event) { return event.kind == EventKind::Close; });
        }
        QCOMPARE(close.size(), std::size_t{1});
        QVERIFY(close.front().distance_m < 200 && close.front().distance_m > 195);
        QVERIFY(simulation.fleet().closest_m().value() < 195);
    }

    /** They separate from the start on. */
    void theStartCountsAsClosest()
    {
        Scenario s = pairOf({0, 1}, 225);
        s.uavs[0].position_m = {0, 0};
        s.uavs[0].heading_deg = 45;
        Simulation simulation(s);
        for (int step = 0; step < 10; ++step) {
            for (const int uav : {0, 1})
                simulation.setTarget(uav, IcebergIndex::of(uav));
            simulation.advanceStep();
        }
        QCOMPARE(simulation.fleet().closest_m().value(), 1.0);
    }
};

QTEST_APPLESS_MAIN(TestSeparation)
#include "tst_separation.moc"
