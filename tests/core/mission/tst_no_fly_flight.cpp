#include "core/base/random.h"
#include "core/mission/mission_instant.h"
#include "core/mission/plan_requests.h"
#include "core/scenario/fence.h"
#include "tests/support/flight/fenced_scenario.h"

#include <QTest>

using namespace berg;
using namespace berg::test;

namespace {

std::vector<Point> squareRound(const Point& middle_m, double half_m)
{
    return {middle_m + Point(-half_m, -half_m), middle_m + Point(half_m, -half_m),
            middle_m + Point(half_m, half_m), middle_m + Point(-half_m, half_m)};
}

/** `fencedScenario` with areas of 300 to 900 m around some of its icebergs and between them. */
Scenario scenarioWithAreas(std::int64_t seed, const Point& wind_mps, bool isFenced)
{
    Scenario s = fencedScenario(seed, wind_mps);
    s.geofence = isFenced;
    const Point start_m = s.uavs[0].position_m;
    Random random(static_cast<std::uint64_t>(seed), 98);
    for (int k = 0; k < 6; ++k) {
        const Iceberg& near = s.icebergs[random.below(s.icebergs.size())];
        const double east_m = random.uniform(-500, 500);
        const Point middle_m = near.position_m + Point(east_m, random.uniform(-500, 500));
        const double half_m = random.uniform(150, 450);
        if ((middle_m - start_m).norm() > 2 * half_m + 400)
            s.noFly.push_back({.corners_m = squareRound(middle_m, half_m)});
    }
    return s;
}

/** One iceberg in the middle of an area 600 m by 600 m, one 3 km beyond it. */
Scenario icebergInAnArea()
{
    Scenario s;
    s.noise = false;
    s.duration_s = 1500;
    s.uavs = {{.id = "u", .position_m = {-1500, 0}, .heading_deg = 90}};
    s.icebergs = {{.id = "in", .position_m = {0, 0}, .velocity_mps = {0, 0}},
                  {.id = "beyond", .position_m = {3000, 0}, .velocity_mps = {0, 0}}};
    s.noFly = {{.corners_m = squareRound(Point::Zero(), 300)}};
    return s;
}

/** Least distance over all samples, ten per second. */
double nearest_m(const Mission& mission, const Point& place_m)
{
    double least_m = 1e9;
    for (const Sample& sample : mission.recorder().samples())
        least_m = std::min(least_m, (sample.uavs[0].pose.position_m - place_m).norm());
    return least_m;
}

Mission flownFinely(const Scenario& scenario)
{
    Mission mission(scenario, {.workLimit = 20'000, .sampleInterval_s = 0.1});
    mission.advance(scenario.duration_s);
    return mission;
}

std::ptrdiff_t samplesInside(const Mission& mission)
{
    const Scenario& s = mission.scenario();
    const std::shared_ptr<const Geofence> fence = fenceOf(s, s.uavs[0].spec.altitude_m, {});
    const std::vector<Sample>& samples = mission.recorder().samples();
    return std::count_if(samples.begin(), samples.end(), [&](const Sample& sample) {
        return !fence->contains(sample.uavs[0].pose.position_m);
    });
}

std::ptrdiff_t visitsOf(const Mission& mission, IcebergIndex iceberg)
{
    return std::count_if(mission.events().begin(), mission.events().end(),
                         [&](const MissionEvent& event) {
                             return event.kind == EventKind::Reached && event.iceberg == iceberg;
                         });
}

} // namespace

/** No-fly areas and stand-off rings. */
class TestNoFlyFlight : public QObject
{
    Q_OBJECT

private slots:
    void nothingIsFlownInside_data()
    {
        QTest::addColumn<double>("wind_mps");
        QTest::addColumn<int>("policy");
        QTest::addColumn<bool>("isFenced");
        const int visitation = static_cast<int>(PolicyKind::Visitation);
        QTest::newRow("calm") << 0.0 << visitation << true;
        QTest::newRow("no geofence") << 0.0 << visitation << false;
        QTest::newRow("10 m/s") << 10.0 << visitation << false;
        QTest::newRow("coverage") << 5.0 << static_cast<int>(PolicyKind::Coverage) << false;
    }
    void nothingIsFlownInside()
    {
        QFETCH(double, wind_mps);
        QFETCH(int, policy);
        QFETCH(bool, isFenced);
        const int scenarios = policy == static_cast<int>(PolicyKind::Coverage) ? 5 : 40;
        int visits = 0;
        for (int seed = 1; seed <= scenarios; ++seed) {
            Scenario s = scenarioWithAreas(seed, {0.8 * wind_mps, -0.6 * wind_mps}, isFenced);
            s.planner.policy = static_cast<PolicyKind>(policy);
            const Mission mission = flownFinely(s);
            QVERIFY2(samplesInside(mission) == 0, qPrintable(QString("seed %1").arg(seed)));
            visits += mission.metrics().visits;
        }
        QVERIFY2(visits > 10 * scenarios, qPrintable(QString::number(visits)));
    }

    /** The view is 600 m wide: it reaches 300 m into an area, and the turn takes some of that. */
    void icebergNearTheEdgeIsSeenFromOutside()
    {
        Scenario s = icebergInAnArea();
        s.icebergs[0].position_m = {0, 150};
        const Mission mission = flownFinely(s);
        QCOMPARE(samplesInside(mission), std::ptrdiff_t{0});
        QVERIFY(visitsOf(mission, 0) >= 2);
        QVERIFY(visitsOf(mission, 1) >= 2);
    }

    void icebergDeepInsideIsNotFlownTo()
    {
        const Mission mission = flownFinely(icebergInAnArea());
        QCOMPARE(samplesInside(mission), std::ptrdiff_t{0});
        QCOMPARE(visitsOf(mission, 0), std::ptrdiff_t{0});
        QVERIFY(!mission.simulation().available(0, 0));
        QVERIFY(visitsOf(mission, 1) >= 1);
    }

    void legsLeadRoundTheArea()
    {
        Scenario s = icebergInAnArea();
        s.icebergs.erase(s.icebergs.begin());
        const Simulation world(s);
        const PlanRequest request = planRequest(world);
        const double length_m = request.uavs[0].distance_m(0, 1);
        QVERIFY(length_m > 4500 && length_m < 4700);
        QVERIFY(samplesInside(flownFinely(s)) == 0);
    }

    void whoFliesAboveItFliesAsIfThereWereNone()
    {
        Scenario s = icebergInAnArea();
        s.noFly[0].ceiling_m = 100;
        const Mission above = flownFinely(s);
        QVERIFY(visitsOf(above, 0) >= 1);
        s.noFly.clear();
        QVERIFY(flownFinely(s).simulation().state() == above.simulation().state());
    }

    void standOffIsKept()
    {
        Scenario s = icebergInAnArea();
        s.noFly.clear();
        s.asset = Asset{.standoff_m = 400};
        const Mission mission = flownFinely(s);
        QVERIFY(nearest_m(mission, Point::Zero()) > 400);
        QVERIFY(visitsOf(mission, 1) >= 1);
    }

    /** An asset may get a ring in flight, or lose it. */
    void ringCanChangeInFlight()
    {
        Scenario s = icebergInAnArea();
        s.noFly.clear();
        const auto fly = [&](double until_s) {
            Mission mission(s, {.sampleInterval_s = 0.1, .keyframeInterval_s = 50});
            mission.advance(20);
            mission.intervene({.asset = Asset{.standoff_m = 400}});
            mission.advance(until_s);
            return mission;
        };
        const Mission mission = fly(900);
        QVERIFY(nearest_m(mission, Point::Zero()) > 400);
        QVERIFY(!mission.simulation().available(0, 0));
        QVERIFY(instantAt(mission, 333).simulation.state() == fly(333).simulation().state());
        s.asset = Asset{.standoff_m = 400};
        Mission without(s, {.sampleInterval_s = 0.1});
        without.advance(20);
        without.intervene({.asset = Asset{}});
        without.advance(900);
        QVERIFY(visitsOf(without, 0) >= 1);
    }

    /** The event is reported, and the UAV leaves by the shortest path. */
    void ringComesOverTheUav()
    {
        Scenario s = icebergInAnArea();
        s.noFly.clear();
        Mission mission(s, {.sampleInterval_s = 0.1});
        mission.advance(20);
        const Point place_m = mission.simulation().uav(0).pose.position_m;
        mission.intervene({.asset = Asset{.position_m = place_m, .standoff_m = 300}});
        mission.advance(200);
        std::vector<MissionEvent> events;
        std::ranges::copy_if(
            mission.events(), std::back_inserter(events), [](const MissionEvent& event) {
                return event.kind == EventKind::LeftFence || event.kind == EventKind::BackInside;
            });
        QCOMPARE(events.size(), std::size_t{2});
        QCOMPARE(events[0].kind, EventKind::LeftFence);
        QCOMPARE(events[0].time_s, 20.0);
        QCOMPARE(events[1].kind, EventKind::BackInside);
        const double shortest_s = 300 / s.uavs[0].spec.airspeed_mps;
        QVERIFY(events[1].time_s - 20 < 1.5 * shortest_s);
    }
};

QTEST_APPLESS_MAIN(TestNoFlyFlight)
#include "tst_no_fly_flight.moc"
