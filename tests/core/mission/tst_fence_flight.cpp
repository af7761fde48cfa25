#include "core/checks/validate.h"
#include "core/io/files/run_json.h"
#include "core/mission/mission_instant.h"
#include "core/mission/plan_requests.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/flight/fenced_scenario.h"

#include <QTest>

#include <algorithm>
#include <iterator>

using namespace berg;
using namespace berg::test;

namespace {

Mission flownFinely(const Scenario& scenario)
{
    Mission mission(scenario, {.workLimit = 20'000, .sampleInterval_s = 0.1});
    mission.advance(scenario.duration_s);
    return mission;
}

std::ptrdiff_t samplesOutside(const Mission& mission)
{
    const std::vector<Point>& area_m = mission.scenario().area_m;
    const std::vector<Sample>& samples = mission.recorder().samples();
    return std::count_if(samples.begin(), samples.end(), [&](const Sample& sample) {
        return !insidePolygon(area_m, sample.uavs[0].pose.position_m);
    });
}

} // namespace

/** Flights with the area as a geofence. */
class TestFenceFlight : public QObject
{
    Q_OBJECT

private slots:
    void nothingIsFlownOutside_data()
    {
        QTest::addColumn<double>("wind_mps");
        QTest::addColumn<int>("policy");
        QTest::addColumn<int>("scenarios");
        const int visitation = static_cast<int>(PolicyKind::Visitation);
        QTest::newRow("calm") << 0.0 << visitation << 200;
        QTest::newRow("5 m/s") << 5.0 << visitation << 200;
        QTest::newRow("15 m/s") << 15.0 << visitation << 20;
        QTest::newRow("coverage") << 5.0 << static_cast<int>(PolicyKind::Coverage) << 10;
        QTest::newRow("tour") << 5.0 << static_cast<int>(PolicyKind::Tour) << 20;
    }
    void nothingIsFlownOutside()
    {
        QFETCH(double, wind_mps);
        QFETCH(int, policy);
        QFETCH(int, scenarios);
        int visits = 0;
        for (int seed = 1; seed <= scenarios; ++seed) {
            Scenario s = fencedScenario(seed, {0.8 * wind_mps, -0.6 * wind_mps});
            s.planner.policy = static_cast<PolicyKind>(policy);
            const Mission mission = flownFinely(s);
            QVERIFY2(samplesOutside(mission) == 0, qPrintable(QString("seed %1").arg(seed)));
            visits += mission.metrics().visits;
        }
        QVERIFY(visits > 12 * scenarios); // and icebergs are still visited
    }

    /** A start too close to turn is reported before the flight, and the crossings in flight. */
    void leavingTheFenceIsAnEvent()
    {
        for (int k = 0; k < 60; ++k) {
            Scenario s = fencedScenario(k + 1);
            s.area_m = {{-3000, -3000}, {3000, -3000}, {3000, 3000}, {-3000, 3000}};
            s.uavs[0].position_m = {2900, 50.0 * k - 1500};
            s.uavs[0].heading_deg = 88 + k / 15.0; // about east, the fence 100 m ahead
            for (Iceberg& iceberg : s.icebergs)
                iceberg.position_m = {0, 0};
            s.duration_s = 120;
            const std::vector<Issue> issues = validate(s);
            QVERIFY(std::ranges::any_of(issues, [](const Issue& issue) {
                return issue.reason.id == IssueId::StartNearFence;
            }));
            const Mission mission = flownFinely(s);
            QVERIFY(samplesOutside(mission) > 0);
            std::vector<MissionEvent> events;
            std::ranges::copy_if(mission.events(), std::back_inserter(events),
                                 [](const MissionEvent& event) {
                                     return event.kind == EventKind::LeftFence ||
                                            event.kind == EventKind::BackInside;
                                 });
            QCOMPARE(events.size(), std::size_t{2});
            QCOMPARE(events[0].kind, EventKind::LeftFence);
            QCOMPARE(events[0].uav, 0);
            const auto isInside = [&](double time_s) {
                return insidePolygon(s.area_m,
                                     instantAt(mission, time_s).simulation.uav(0).pose.position_m);
            };
            QVERIFY(isInside(events[0].time_s - s.dt_s) && !isInside(events[0].time_s));
            QVERIFY(!isInside(events[1].time_s - s.dt_s) && isInside(events[1].time_s));
        }
    }

    /** After leaving it turns and comes straight back, not along the edge. */
    void itComesStraightBack_data()
    {
        QTest::addColumn<double>("heading_deg");
        for (const double heading_deg : {45.0, 60.0, 75.0, 90.0, 105.0, 120.0, 135.0})
            QTest::addRow("%.0f", heading_deg) << heading_deg;
    }
    void itComesStraightBack()
    {
        QFETCH(double, heading_deg);
        Scenario s = fencedScenario(1, {4, -3});
        s.area_m = {{-3000, -3000}, {3000, -3000}, {3000, 3000}, {-3000, 3000}};
        s.uavs[0].position_m = {2990, 0};
        s.uavs[0].heading_deg = heading_deg; // clockwise from north
        for (Iceberg& iceberg : s.icebergs)
            iceberg.position_m = {0, 0};
        s.duration_s = 300;
        const std::ptrdiff_t outside = samplesOutside(flownFinely(s));
        QVERIFY(outside > 0);
        const double circle_s = 2 * kPi / maxTurnRate_radps(s.uavs[0].spec);
        QVERIFY2(0.1 * static_cast<double>(outside) < 1.5 * circle_s,
                 qPrintable(QString::number(outside)));
    }

    void withoutTheFenceItFliesOutside()
    {
        std::ptrdiff_t outside = 0;
        for (int seed = 1; seed <= 10; ++seed) {
            Scenario s = fencedScenario(seed);
            s.geofence = false;
            outside += samplesOutside(flownFinely(s));
        }
        QVERIFY(outside > 1000);
    }

    void slowAutopilotStaysInside()
    {
        for (int seed = 1; seed <= 20; ++seed) {
            Scenario s = fencedScenario(seed);
            s.uavs[0].spec.autopilot_s = 1;
            QCOMPARE(samplesOutside(flownFinely(s)), std::ptrdiff_t{0});
        }
    }

    void fenceHoldsInTheNewWind()
    {
        for (int seed = 1; seed <= 20; ++seed) {
            Mission mission(fencedScenario(seed), {.sampleInterval_s = 0.1});
            mission.advance(200);
            // The circle over ground grows a little with the wind, starting well inside.
            if (distanceToEdges(mission.scenario().area_m,
                                mission.simulation().uav(0).pose.position_m) < 600)
                continue;
            mission.intervene({.wind_mps = Point(-6, 3)});
            mission.advance(1000);
            QCOMPARE(samplesOutside(mission), std::ptrdiff_t{0});
        }
    }

    /** The plan includes the detour, so it first visits icebergs on this side. */
    void legsAreAsLongAsTheWayRound()
    {
        Scenario s = fencedScenario(1);
        s.area_m = {{0, 0}, {4000, 0}, {4000, 900}, {900, 900}, {900, 4000}, {0, 4000}};
        s.uavs[0].position_m = {3500, 450};
        s.icebergs.resize(2);
        s.icebergs[0].position_m = {450, 3500}; // 4300 m away, and about 5700 m to fly
        s.icebergs[1].position_m = {1000, 450};
        const PlanRequest request = planRequest(Simulation(s));
        const double straight_m = (s.uavs[0].position_m - s.icebergs[0].position_m).norm();
        QVERIFY(request.uavs[0].distance_m(0, 1) > 1.2 * straight_m);
        QVERIFY(std::abs(request.uavs[0].distance_m(0, 2) - 2500) < 1e-9);
    }

    /**
     * With a reach radius below the turn radius some icebergs cannot be reached; none of them stops
     * the flight.
     */
    void nothingIsTriedForEver()
    {
        for (int seed = 1; seed <= 20; ++seed) {
            Scenario s = fencedScenario(seed, {4, -3});
            s.duration_s = 2000;
            s.reachRadius_m = 40;
            const Mission mission = flownFinely(s);
            QCOMPARE(samplesOutside(mission), std::ptrdiff_t{0});
            double last_s = 0;
            for (const MissionEvent& event : mission.events())
                if (event.kind == EventKind::Reached) {
                    QVERIFY2(event.time_s - last_s < 600, qPrintable(QString("%1").arg(seed)));
                    last_s = event.time_s;
                }
            QVERIFY(s.duration_s - last_s < 600);
        }
    }

    /** Corners of a search pattern outside the fence are left out. */
    void searchesEndInsideTheFence()
    {
        std::ptrdiff_t ended = 0;
        for (int seed = 1; seed <= 20; ++seed) {
            Scenario s = fencedScenario(seed);
            s.duration_s = 2000;
            s.observer.model = ObserverModel::Kalman;
            for (Iceberg& iceberg : s.icebergs)
                iceberg.velocitySd_mps = 1;
            Mission mission(s, {.workLimit = 20'000, .sampleInterval_s = 0.1});
            int searching_s = 0;
            std::optional<IcebergIndex> searched;
            for (double t_s = 1; t_s <= s.duration_s; ++t_s) {
                mission.advance(t_s);
                const UavState& uav = mission.simulation().uav(0);
                const bool searches = uav.mode == FlightMode::Search && uav.search;
                const std::optional<IcebergIndex> iceberg =
                    searches ? std::optional(uav.search->iceberg) : std::nullopt;
                searching_s = searches && iceberg == searched ? searching_s + 1 : 0;
                searched = iceberg; // the search for the next one may follow at once
                QVERIFY2(
                    searching_s < 1800,
                    qPrintable(QString("%1: %2 s").arg(seed).arg(searching_s))); // resumed outside
            }
            QCOMPARE(samplesOutside(mission), std::ptrdiff_t{0});
            const auto isEnd = [](const MissionEvent& e) {
                return e.kind == EventKind::GivenUp || e.kind == EventKind::Found;
            };
            ended += std::count_if(mission.events().begin(), mission.events().end(), isEnd);
        }
        QVERIFY(ended > 40);
    }

    void runsReplayAndLookBack()
    {
        const Scenario s = fencedScenario(7, {4, 3});
        const auto fly = [&](double until_s) {
            Mission mission(s, {.keyframeInterval_s = 50});
            mission.advance(until_s);
            return mission;
        };
        const Mission mission = fly(900);
        const std::vector<Simulation>& keyframes = mission.recorder().keyframes();
        QVERIFY(std::any_of(keyframes.begin(), keyframes.end(),
                            [](const Simulation& k) { return k.uav(0).via_m.has_value(); }));
        const RunFile read = runFromJson(runToJson(runOf(mission)), "run");
        QVERIFY(read == runOf(mission));
        QVERIFY(compareRun(read, runOf(replay(read))).empty());
        for (const double time_s : {99.0, 333.0, 640.0})
            QVERIFY(instantAt(mission, time_s).simulation.state() ==
                    fly(time_s).simulation().state());
    }
};

QTEST_APPLESS_MAIN(TestFenceFlight)
#include "tst_fence_flight.moc"
