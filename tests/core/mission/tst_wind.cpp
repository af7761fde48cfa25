#include "core/base/angles.h"
#include "core/base/random.h"
#include "core/io/files/run_json.h"
#include "core/mission/mission_instant.h"
#include "core/mission/plan_requests.h"
#include "core/presets/presets.h"
#include "tests/support/approx.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/flight/flown_plans.h"
#include "tests/support/flight/scenario_builder.h"

#include <QTest>

#include <cmath>

using namespace berg;
using namespace berg::test;

namespace {

constexpr double kWind_mps = 15;

Point windFrom(int direction, int directions)
{
    const double angle_rad = 2 * kPi * direction / directions;
    return {kWind_mps * std::cos(angle_rad), kWind_mps * std::sin(angle_rad)};
}

} // namespace

/** Wind in closed loop: the flight agrees with the planner's assumptions. */
class TestWind : public QObject
{
    Q_OBJECT

private slots:
    /** Velocities fade to the current, also where it is constant and not in the file. */
    void runsInACurrentRoundTrip()
    {
        Scenario scenario = randomScenario(3);
        scenario.current_mps = Point(0.12, 0.18);
        Mission mission(scenario);
        mission.advance(50);
        const RunFile run = runOf(mission);
        QVERIFY(runFromJson(runToJson(run), "run") == run);
    }

    /**
     * In a uniform wind the part of leg times that changes sign with direction depends only on the
     * ends of an order, so no order gains by it at its stops.
     */
    void helpAndHindranceTelescope()
    {
        Random random(3, 0);
        const Point wind_mps(9, -11);
        const auto oneWay_s = [&](const Point& from_m, const Point& to_m) {
            return (flightTime_s(to_m - from_m, 22, wind_mps) -
                    flightTime_s(from_m - to_m, 22, wind_mps)) /
                   2;
        };
        const auto place_m = [&] {
            const double x_m = random.uniform(-5000, 5000);
            return Point(x_m, random.uniform(-5000, 5000));
        };
        for (int k = 0; k < 200; ++k) {
            const Point a_m = place_m();
            const Point b_m = place_m();
            const Point c_m = place_m();
            COMPARE_NEAR(oneWay_s(a_m, b_m) + oneWay_s(b_m, c_m), oneWay_s(a_m, c_m), 1e-9);
            QVERIFY(std::abs(oneWay_s(a_m, c_m)) > 0);
        }
    }

    /** An iceberg drifting across is met on the leg: the crab angle is that of wind minus drift. */
    void crabsForTheDriftOfTheTarget()
    {
        for (const double drift_mps : {-1.5, 1.5}) {
            Scenario scenario = emptySea(3000);
            scenario.wind_mps = {0, 8};
            scenario.uavs[0].fov_m = {40, 800};
            addIceberg(scenario, 4000, 0).velocity_mps = {0, drift_mps};
            Mission mission(scenario);
            while (mission.metrics().visits == 0 && !mission.simulation().finished())
                mission.advance(mission.simulation().time_s() + 0.1);
            QCOMPARE(mission.metrics().visits, 1);
            const double off_m = mission.recorder().samples().back().uavs[0].crossTrack_m;
            QVERIFY2(std::abs(off_m) < 3, qPrintable(QString::number(off_m)));
        }
    }

    /** A long leg in wind from all sides, until the iceberg is in view. */
    void longLegsTakeTheTimePlanned_data()
    {
        QTest::addColumn<int>("direction");
        for (int k = 0; k < 12; ++k)
            QTest::addRow("%d deg", 30 * k) << k;
    }
    void longLegsTakeTheTimePlanned()
    {
        QFETCH(int, direction);
        Scenario scenario = emptySea(3000);
        scenario.fovShape = FovShape::Disk;
        scenario.wind_mps = windFrom(direction, 12);
        addIceberg(scenario, 8000, 0);
        Mission mission(scenario);
        const double planned_s = flightTime_s({7700, 0}, 22, scenario.wind_mps); // seen at 300 m
        while (mission.metrics().visits == 0 && !mission.simulation().finished())
            mission.advance(mission.simulation().time_s() + 0.1);
        QCOMPARE(mission.metrics().visits, 1);
        QVERIFY2(std::abs(mission.simulation().time_s() / planned_s - 1) < 0.03,
                 qPrintable(QString::number(mission.simulation().time_s() / planned_s)));
        // The planner's cost is the same air distance U t.
        const PlanRequest request = planRequest(Simulation(scenario));
        COMPARE_NEAR(request.uavs[0].distance_m(0, 1),
                     22 * flightTime_s({8000, 0}, 22, scenario.wind_mps), 1e-9);
    }

    /**
     * Legs of whole missions, turns and drift included, by the model of `coverage`. Only legs that
     * end as planned count, not those whose iceberg came back into a view it had just left.
     */
    void legsOfMissionsTakeTheTimePlanned()
    {
        double planned_s = 0;
        double flown_s = 0;
        for (int seed = 1; seed <= 12; ++seed) {
            Scenario scenario = randomScenario(seed);
            scenario.wind_mps = windFrom(seed, 12);
            scenario.planner.policy = PolicyKind::Coverage;
            Mission mission(scenario, {.workLimit = 30'000});
            mission.advance(1000);
            const std::vector<test::FlownPlan> plans = test::flownPlans(mission);
            for (std::size_t i = 0; i + 1 < plans.size(); ++i) {
                if (plans[i].legs.empty() || plans[i + 1].reason != PlanReason::TargetReached)
                    continue;
                planned_s += plans[i].legs.front().sighting_s - plans[i].time_s;
                flown_s += plans[i + 1].time_s - plans[i].time_s;
            }
        }
        QVERIFY(planned_s > 6000); // more than half of the twelve flights
        QVERIFY2(std::abs(flown_s / planned_s - 1) < 0.03,
                 qPrintable(QString::number(flown_s / planned_s)));
    }

    /** The order depends on the direction of the wind. */
    void theOrderFollowsTheWind()
    {
        Scenario scenario = emptySea();
        scenario.uavs[0].heading_deg = 0;
        addIceberg(scenario, 2000, 0);
        addIceberg(scenario, -2100, 0);
        scenario.planner.policy = PolicyKind::Nearest;
        QCOMPARE(planFromStart(scenario).uavs[0].order.at(0), IcebergIndex(0));
        scenario.wind_mps = {-kWind_mps, 0};
        QCOMPARE(planFromStart(scenario).uavs[0].order.at(0), IcebergIndex(1));
    }

    void windThatTurnsInFlightReplays()
    {
        const Scenario scenario = randomScenario(6);
        const auto fly = [&](double until_s) {
            Mission mission(scenario, {.keyframeInterval_s = 50});
            mission.advance(120);
            mission.intervene({.wind_mps = Point(12, -5)});
            mission.advance(until_s);
            return mission;
        };
        const Mission mission = fly(500);
        QVERIFY(mission.simulation().motion(0).wind_mps == Point(12, -5));
        const auto changed =
            std::find_if(mission.events().begin(), mission.events().end(),
                         [](const MissionEvent& e) { return e.kind == EventKind::Intervention; });
        QVERIFY(changed != mission.events().end());
        QVERIFY(changed->changed == ChangedPart::Wind);

        const RunFile read = runFromJson(runToJson(runOf(mission)), "run");
        QVERIFY(read == runOf(mission));
        QVERIFY(compareRun(read, runOf(replay(read))).empty());
        QVERIFY(instantAt(mission, 260).simulation.state() == fly(260).simulation().state());
        QVERIFY(instantAt(mission, 60).simulation.motion(0).wind_mps == Point(0, 0));
    }

    /** Icebergs out of reach are not tested for long, but no longer than a new wind permits. */
    void nothingIsOverlookedWhenTheWindTurns()
    {
        Scenario scenario = randomScenario(9);
        scenario.wind_mps = {-18, 0};
        Mission mission(scenario);
        for (int step = 1; step <= 6000; ++step) {
            mission.advance(0.1 * step);
            if (step % 1000 == 0)
                mission.intervene({.wind_mps = windFrom(step / 1000, 7)});
            const Simulation& world = mission.simulation();
            const FieldOfView view({.fov_m = scenario.uavs[0].fov_m}, world.uav(0).pose.position_m,
                                   world.uav(0).pose.psi_rad);
            for (const IcebergIndex i : world.icebergs())
                QCOMPARE(world.track(i).inView, view.contains(world.truth_m(i)));
        }
        QVERIFY(mission.metrics().visits > 5);
    }

    void windAsFastAsTheUavIsRefusedInFlight()
    {
        Mission mission(randomScenario(6));
        mission.advance(50);
        QVERIFY_THROWS_EXCEPTION(Error, mission.intervene({.wind_mps = Point(22, 0)}));
        QVERIFY_THROWS_EXCEPTION(Error, mission.intervene({.wind_mps = Point(std::nan(""), 0)}));
        QVERIFY(mission.interventions().empty());
        QVERIFY(mission.simulation().motion(0).wind_mps == Point(0, 0));
    }

    void aRunFileWithSuchWindIsRefused()
    {
        Mission mission(randomScenario(6));
        mission.advance(50);
        mission.intervene({.wind_mps = Point(9, 0)});
        mission.advance(60);
        std::string text = runToJson(runOf(mission));
        const std::string wind = "\"wind_mps\": [9, 0]";
        const std::size_t at = text.find(wind);
        QVERIFY(at != std::string::npos);
        text.replace(at, wind.size(), "\"wind_mps\": [29, 0]");
        try {
            static_cast<void>(runFromJson(text, "run.bergrun"));
            QFAIL("accepted");
        } catch (const Error& error) {
            QCOMPARE(error.issues().front().field, std::string("interventions[0].wind_mps"));
        }
    }
};

QTEST_APPLESS_MAIN(TestWind)
#include "tst_wind.moc"
