#include "core/base/angles.h"
#include "core/mission/plan_requests.h"
#include "core/presets/presets.h"
#include "core/sim/simulation.h"
#include "core/vehicle/tangent_turn.h"
#include "tests/support/flight/scenario_builder.h"

#include <QtTest>

#include <array>

using namespace berg;
using test::addIceberg;
using test::emptySea;

namespace {

/** Flies to the given iceberg at every request for a plan until `done` or the end. */
template <class Done>
bool flyTo(Simulation& simulation, IcebergIndex iceberg, const Done& done)
{
    while (!simulation.finished()) {
        if (simulation.planReason() != PlanReason::None)
            simulation.setTarget(0, simulation.available(0, iceberg) ? std::optional(iceberg)
                                                                     : std::nullopt);
        simulation.advanceStep();
        if (done(simulation))
            return true;
    }
    return false;
}

bool reached(const Simulation& simulation)
{
    return simulation.planReason() == PlanReason::TargetReached;
}

} // namespace

class TestSimulation : public QObject
{
    Q_OBJECT

private slots:
    void startAsksForAPlan()
    {
        const Simulation simulation(emptySea());
        QCOMPARE(simulation.planReason(), PlanReason::Start);
        QCOMPARE(simulation.time_s(), 0.0);
    }

    void steppingWithoutPlanIsABug()
    {
        Simulation simulation(emptySea());
        QVERIFY_THROWS_EXCEPTION(std::logic_error, simulation.advanceStep());
    }

    /** The turn is flown to the planned side and to its end, then the line. */
    void aimedLegIsFlownAsPlanned()
    {
        Scenario scenario = emptySea(400);
        addIceberg(scenario, 3000, 0);
        // One course, turned to from either side.
        for (const double turn_rad : {2.0, -4.28318530717958647}) {
            Simulation simulation(scenario);
            const Point along(std::cos(turn_rad), std::sin(turn_rad));
            const double side = turn_rad > 0 ? 1 : -1;
            const Point exit_m = turnedTo(Pose{}, along, side, turnRadius_m(UavSpec{})).position_m;
            simulation.setTarget(0, IcebergIndex(0),
                                 AimedLeg{.iceberg = 0,
                                          .turn_rad = turn_rad,
                                          .from_m = exit_m,
                                          .abeam_m = exit_m + 2000 * along,
                                          .sighting_s = 100});
            QVERIFY(simulation.uav(0).aim.has_value());
            while (simulation.uav(0).aim->turn_rad != 0) {
                simulation.advanceStep();
                QVERIFY(simulation.uav(0).u_radps * turn_rad > 0);
            }
            // The step in which the turn ends continues along the line.
            const Point beyond_m = simulation.uav(0).pose.position_m - exit_m;
            QVERIFY(std::abs(cross(along, beyond_m)) < 0.1);
            QVERIFY(along.dot(beyond_m) > -0.01 && along.dot(beyond_m) < 2.21);
            for (int i = 0; i < 100; ++i)
                simulation.advanceStep();
            QVERIFY(std::abs(simulation.uav(0).crossTrack_m) < 0.1);
            QVERIFY((simulation.uav(0).pose.position_m - exit_m - 220 * along).norm() < 2.3);
        }
    }

    void sightingsEndAnAimedLeg()
    {
        Scenario scenario = emptySea(400);
        addIceberg(scenario, 3000, 0);
        addIceberg(scenario, 1500, 100);
        Simulation simulation(scenario);
        const AimedLeg ahead{.iceberg = 0, .abeam_m = {3000, 0}, .sighting_s = 1200 / 22.0};
        simulation.setTarget(0, IcebergIndex(0), ahead);
        while (simulation.planReason() == PlanReason::None)
            simulation.advanceStep();
        QCOMPARE(simulation.planReason(), PlanReason::Sighted);
        QVERIFY(simulation.track(1).inView);
        QVERIFY(!simulation.uav(0).lastReached);
        simulation.setTarget(0, IcebergIndex(0),
                             AimedLeg{.iceberg = 0, .abeam_m = {3000, 0}, .sighting_s = 130});
        while (simulation.planReason() == PlanReason::None)
            simulation.advanceStep();
        QCOMPARE(simulation.planReason(), PlanReason::TargetReached);
        QCOMPARE(simulation.uav(0).lastReached, std::optional(IcebergIndex(0)));
    }

    void overdueSightingAsksForAPlan()
    {
        Scenario scenario = emptySea(400);
        addIceberg(scenario, 3000, 0);
        Simulation simulation(scenario);
        simulation.setTarget(0, IcebergIndex(0),
                             AimedLeg{.iceberg = 0, .abeam_m = {3000, 0}, .sighting_s = 50.05});
        while (simulation.planReason() == PlanReason::None)
            simulation.advanceStep();
        QCOMPARE(simulation.planReason(), PlanReason::Overdue);
        QVERIFY(std::abs(simulation.time_s() - 52.1) < 1e-9); // two seconds later, the next step
        simulation.setTarget(0, IcebergIndex(0)); // without an aim nothing can be overdue
        QVERIFY(!simulation.uav(0).aim);
        simulation.advanceStep();
        QCOMPARE(simulation.planReason(), PlanReason::None);
    }

    /**
     * Flying straight ahead the iceberg is in view 300 m early; sigma and zeta have a closed form.
     */
    void oneIcebergAhead()
    {
        Scenario scenario = emptySea(400);
        addIceberg(scenario, 3000, 0, 4);
        Simulation simulation(scenario);
        QVERIFY(flyTo(simulation, 0, reached));

        constexpr int kSteps = 1228; // first multiple of 0.1 s x 22 m/s beyond 2700 m
        QCOMPARE(simulation.step(), kSteps);
        QCOMPARE(simulation.track(0).sigma_m2, 0.0);
        // Eq. (22)-(24): sigma_k = 4 + q k dt after step k, 0 from the step that sees it.
        double zeta_m2s = 0;
        for (int k = 1; k < kSteps; ++k)
            zeta_m2s += (4 + 0.025 * k * 0.1) * 0.1;
        QVERIFY(std::abs(simulation.zeta_m2s() - zeta_m2s) < 1e-9 * zeta_m2s); // rounding
        QVERIFY(std::abs(simulation.uav(0).pose.position_m.y()) < 1e-9);
        QVERIFY(std::abs(simulation.state().flown_m() - kSteps * 2.2) < 1e-6);
    }

    /** With every iceberg in view the UAV circles the last one reached and keeps it in view. */
    void circlesWhileAllAreInView()
    {
        Scenario scenario = emptySea(1000);
        addIceberg(scenario, 2000, 0);
        Simulation simulation(scenario);
        QVERIFY(flyTo(simulation, 0, reached));
        const double zeta_m2s = simulation.zeta_m2s();
        const double radius_m = turnRadius_m(scenario.uavs[0].spec);

        simulation.setTarget(0, std::nullopt);
        double nearest_m = 1e9;
        double farthest_m = 0;
        while (!simulation.finished()) {
            simulation.advanceStep();
            QCOMPARE(simulation.planReason(), PlanReason::None); // nothing to re-plan, ever
            const double r_m = (simulation.uav(0).pose.position_m - simulation.truth_m(0)).norm();
            if (simulation.time_s() > 300) { // settled
                nearest_m = std::min(nearest_m, r_m);
                farthest_m = std::max(farthest_m, r_m);
            }
        }
        QCOMPARE(simulation.zeta_m2s(), zeta_m2s);
        QVERIFY2(nearest_m >= radius_m, qPrintable(QString::number(nearest_m)));
        QVERIFY2(farthest_m < 200, qPrintable(QString::number(farthest_m)));
        QVERIFY(farthest_m - nearest_m < 2); // a circle, not an oval
    }

    void replansWhenAnIcebergLeavesTheView()
    {
        Scenario scenario = emptySea(2000);
        addIceberg(scenario, 100, 0);
        addIceberg(scenario, 0, 250).velocity_mps = {0, 1}; // drifts out of the field of view
        Simulation simulation(scenario);
        QVERIFY(!simulation.available(0, 0));
        QVERIFY(!simulation.available(0, 1));
        QCOMPARE(simulation.state().sigmaSum_m2, 0.0); // seen at t = 0

        simulation.setTarget(0, std::nullopt);
        while (!simulation.finished() && simulation.planReason() == PlanReason::None)
            simulation.advanceStep();
        QCOMPARE(simulation.planReason(), PlanReason::OutOfView);
        QVERIFY(simulation.available(0, 1));
        QVERIFY(!simulation.available(0, 0));
    }

    void seesEveryIcebergOnTheWay()
    {
        Scenario scenario = emptySea();
        addIceberg(scenario, 4000, 0);
        addIceberg(scenario, 2000, 290);  // just inside the 600 m wide view
        addIceberg(scenario, 2000, -310); // just outside
        Simulation simulation(scenario);
        bool sawSecond = false;
        QVERIFY(flyTo(simulation, 0, [&](const Simulation& s) {
            for (const SeenIceberg& seen : s.observer().newlySeen())
                sawSecond = sawSecond || seen.iceberg == 1;
            return reached(s);
        }));
        QVERIFY(sawSecond);
        QVERIFY(simulation.track(1).sigma_m2 < 5); // restarted when it was passed
        QVERIFY(std::abs(simulation.track(2).sigma_m2 - (5 + 0.025 * simulation.time_s())) < 1e-9);
    }

    /** With a reach smaller than the turning circle nothing may orbit for ever. */
    void smallReachIsReached_data()
    {
        QTest::addColumn<double>("heading_deg");
        QTest::addColumn<double>("reach_m");
        QTest::addColumn<bool>("byView");
        for (int heading = 0; heading < 360; heading += 30)
            for (const double reach_m : {5.0, 30.0, 90.0, 150.0}) {
                QTest::addRow("radius %g, heading %d", reach_m, heading)
                    << double(heading) << reach_m << false;
                QTest::addRow("view %g, heading %d", 2 * reach_m, heading)
                    << double(heading) << reach_m << true;
            }
    }
    void smallReachIsReached()
    {
        QFETCH(double, heading_deg);
        QFETCH(double, reach_m);
        QFETCH(bool, byView);
        Scenario scenario = emptySea(3000);
        scenario.uavs[0].heading_deg = heading_deg;
        if (byView)
            scenario.uavs[0].fov_m = {2 * reach_m, 2 * reach_m};
        else
            scenario.reachRadius_m = reach_m;
        addIceberg(scenario, 70, 210).velocity_mps = {0.3, -0.2};
        Simulation simulation(scenario);
        if (!byView) // at the start it is in the large view
            simulation = Simulation([&] {
                Scenario far = scenario;
                far.icebergs[0].position_m = {150, 420};
                return far;
            }());
        QVERIFY(flyTo(simulation, 0, reached));
        QVERIFY2(simulation.time_s() < 600, qPrintable(QString::number(simulation.time_s())));
    }

    void turnRateNeverExceedsTheLimit()
    {
        Simulation simulation(randomScenario(7));
        const double limit_radps = maxTurnRate_radps(UavSpec{});
        IcebergIndex target;
        while (!simulation.finished()) {
            if (simulation.planReason() != PlanReason::None) {
                target = IcebergIndex::of((target.number() + 5) % 12);
                simulation.setTarget(0, simulation.available(0, target)
                                            ? target
                                            : IcebergIndex::of((target.number() + 1) % 12));
            }
            simulation.advanceStep();
            QVERIFY(std::abs(simulation.uav(0).u_radps) <= limit_radps);
        }
    }

    void appearsOnTime()
    {
        Scenario scenario = emptySea(300);
        addIceberg(scenario, 8000, 0);
        Iceberg& later = addIceberg(scenario, 8000, 5000, 3);
        later.appears_s = 100;
        later.q_m2ps = 0.05;
        Simulation simulation(scenario);
        QVERIFY(!simulation.active(1));
        QCOMPARE(planRequest(simulation).ids, IcebergList{0});
        QVERIFY(flyTo(simulation, 0,
                      [](const Simulation& s) { return s.planReason() == PlanReason::Appeared; }));
        QCOMPARE(simulation.time_s(), 100.0);
        QVERIFY(simulation.active(1));
        // It has been unseen since t = 0, so sigma is sigma0 + q t.
        QVERIFY(std::abs(simulation.track(1).sigma_m2 - (3 + 0.05 * 100)) < 1e-9);
        QCOMPARE(planRequest(simulation).ids, (IcebergList{0, 1}));
    }

    void addedInFlightStartsHereAndNow()
    {
        Scenario scenario = emptySea(300);
        addIceberg(scenario, 8000, 0);
        Simulation simulation(scenario);
        QVERIFY(flyTo(simulation, 0, [](const Simulation& s) { return s.time_s() >= 50; }));
        Iceberg added;
        added.id = "new";
        added.position_m = {4000, 4000};
        added.velocity_mps = {1, 0};
        simulation.addIceberg(added);
        QCOMPARE(simulation.planReason(), PlanReason::Appeared);
        QVERIFY((simulation.truth_m(1) - Point(4000, 4000)).norm() < 1e-9);
        simulation.setTarget(0, IcebergIndex(0));
        for (int k = 0; k < 100; ++k)
            simulation.advanceStep();
        QVERIFY((simulation.truth_m(1) - Point(4010, 4000)).norm() < 1e-6);
        QVERIFY((simulation.observer().estimate_m(1) - simulation.truth_m(1)).norm() < 1e-6);
    }

    /** A long leg in wind takes the time of the wind triangle. */
    void windTriangle_data()
    {
        QTest::addColumn<Point>("wind_mps");
        QTest::addRow("head wind") << Point(-10, 0);
        QTest::addRow("tail wind") << Point(10, 0);
        QTest::addRow("cross wind") << Point(0, 12);
        QTest::addRow("quartering") << Point(-8, -8);
    }
    void windTriangle()
    {
        QFETCH(Point, wind_mps);
        Scenario scenario = emptySea(4000);
        scenario.wind_mps = wind_mps;
        addIceberg(scenario, 20000, 0);
        Simulation simulation(scenario);
        QVERIFY(flyTo(simulation, 0, reached));
        const double expected_s = flightTime_s({20000 - 300, 0}, 22, wind_mps);
        // The turn onto the crab angle and the turned field of view cost a few seconds.
        QVERIFY2(std::abs(simulation.time_s() - expected_s) < 0.01 * expected_s,
                 qPrintable(QString("%1 against %2").arg(simulation.time_s()).arg(expected_s)));
        QVERIFY(std::abs(simulation.uav(0).pose.position_m.y()) < 5);
        // Planning uses the same wind, as air distance U t.
        const double air_m = planRequest(Simulation(scenario)).uavs[0].distance_m(0, 1);
        QVERIFY(std::abs(air_m - 22 * flightTime_s({20000, 0}, 22, wind_mps)) < 1e-6);
    }

    void currentCarriesIcebergs()
    {
        Scenario scenario = emptySea(100);
        scenario.current_mps = {0.5, -0.25};
        addIceberg(scenario, 9000, 0).velocity_mps = {0.1, 0};
        Simulation simulation(scenario);
        flyTo(simulation, 0, [](const Simulation&) { return false; });
        QVERIFY((simulation.truth_m(0) - Point(9060, -25)).norm() < 1e-6);
        QVERIFY((simulation.observer().estimate_m(0) - simulation.truth_m(0)).norm() < 1e-6);
    }

    /** The truth depends on seed and iceberg only, not on the time step or the UAV's path. */
    void truthIsTheSameForEveryTimeStep()
    {
        Scenario scenario = randomScenario(3);
        scenario.duration_s = 200;
        std::vector<Point> ends;
        for (const double dt_s : {0.05, 0.1, 0.5}) {
            scenario.dt_s = dt_s;
            Simulation simulation(scenario);
            flyTo(simulation, IcebergIndex::of(dt_s > 0.2 ? 4 : 1),
                  [](const Simulation&) { return false; });
            ends.push_back(simulation.truth_m(7));
        }
        QVERIFY((ends[0] - ends[1]).norm() < 1e-9);
        QVERIFY((ends[0] - ends[2]).norm() < 1e-9);
    }

    void aCopyContinuesTheSame()
    {
        Simulation first(randomScenario(5));
        flyTo(first, 2, [](const Simulation& s) { return s.time_s() >= 60; });
        Simulation second = first;
        const auto end = [](const Simulation& s) { return s.time_s() >= 300; };
        flyTo(first, 4, end);
        flyTo(second, 4, end);
        QVERIFY(first.state() == second.state());
    }

    /** Distant icebergs are not tested at every step, which must have no effect. */
    void nothingInViewIsOverlooked_data()
    {
        QTest::addColumn<FovShape>("shape");
        QTest::addColumn<double>("dt_s");
        QTest::addColumn<double>("q_m2ps");
        QTest::newRow("body") << FovShape::Body << 0.1 << 0.025;
        QTest::newRow("north, odd steps") << FovShape::North << 0.3 << 0.025;
        QTest::newRow("disk, long steps") << FovShape::Disk << 1.0 << 0.025;
        QTest::newRow("wild drift") << FovShape::Body << 0.1 << 400.0;
    }

    void nothingInViewIsOverlooked()
    {
        QFETCH(FovShape, shape);
        QFETCH(double, dt_s);
        QFETCH(double, q_m2ps);
        Scenario scenario = randomScenario(6);
        scenario.fovShape = shape;
        scenario.dt_s = dt_s;
        scenario.wind_mps = {9, -4};
        scenario.icebergs[3].appears_s = 77.7;
        for (Iceberg& iceberg : scenario.icebergs)
            iceberg.q_m2ps = q_m2ps;
        const SensorSpec sensor{.fov_m = scenario.uavs[0].fov_m, .shape = shape};
        Simulation simulation(scenario);
        int inView = 0;
        int wrong = 0;
        flyTo(simulation, 2, [&](const Simulation& s) {
            const DubinsState& uav = s.uav(0).pose;
            const FieldOfView view(sensor, uav.position_m, uav.psi_rad);
            for (const IcebergIndex i : s.icebergs()) {
                inView += s.track(i).inView ? 1 : 0;
                const bool seen = s.active(i) && view.contains(s.truth_m(i));
                wrong += seen != s.track(i).inView ? 1 : 0;
            }
            return false;
        });
        QVERIFY(inView > 0);
        QCOMPARE(wrong, 0);
    }

    void truthBetweenLooksIsThatOfTheDrift()
    {
        const Scenario scenario = randomScenario(6);
        Simulation simulation(scenario);
        const Iceberg& far = scenario.icebergs[9];
        DriftModel drift(
            {.position_m = far.position_m, .velocity_mps = far.velocity_mps, .q_m2ps = far.q_m2ps},
            6, far.id, scenario.noise);
        bool same = true;
        flyTo(simulation, 2, [&](const Simulation& s) {
            same = same && s.truth_m(9) == drift.position_m(s.time_s());
            return s.time_s() >= 200;
        });
        QVERIFY(same);
    }

    /**
     * Sightings depend on the poses only: poses of a recorded flight given from outside reproduce
     * its sightings and zeta, whatever the autopilot commands.
     */
    void posesFromOutsideReplaceTheModel()
    {
        for (const bool isWilful : {false, true}) {
            Scenario scenario = randomScenario(5);
            scenario.noise = !isWilful; // with noise icebergs are lost, and searched for or not
            scenario.duration_s = 600;
            Simulation flown(scenario);
            Simulation fed(scenario);
            std::size_t sightings = 0;
            while (!flown.finished()) {
                const std::optional<IcebergIndex> target = flown.fleet().nearestAvailable(0);
                if (flown.planReason() != PlanReason::None)
                    flown.setTarget(0, target);
                if (fed.planReason() != PlanReason::None)
                    fed.setTarget(0, isWilful ? std::nullopt : target);
                flown.advanceStep();
                const DubinsState pose = flown.uav(0).pose;
                fed.advanceStep(std::array{std::optional(ExternalPose{.pose = pose})});
                QVERIFY(fed.uav(0).pose == pose);
                QVERIFY(fed.observer().tracks() == flown.observer().tracks());
                QCOMPARE(fed.observer().newlySeen().size(), flown.observer().newlySeen().size());
                QCOMPARE(fed.zeta_m2s(), flown.zeta_m2s());
                sightings += fed.observer().newlySeen().size();
            }
            QVERIFY(sightings >= 3);
            auto state = fed.state();
            QVERIFY(std::abs(state.flown_m() - flown.state().flown_m()) < 1); // chords for arcs
            for (std::size_t u = 0; u < state.uavs.size(); ++u)
                state.uavs[u].flown_m = flown.state().uavs[u].flown_m;
            QVERIFY(isWilful || state == flown.state());
            fed = Simulation(scenario);
            fed.setTarget(0, IcebergIndex(0));
            const std::array<std::optional<ExternalPose>, 2> tooMany;
            QVERIFY_THROWS_EXCEPTION(std::logic_error, fed.advanceStep(tooMany));
        }
    }

    void noiseDrawnAtOnceChangesNothing()
    {
        const Scenario scenario = randomScenario(5);
        const std::vector<DriftNoise> noise = drawNoise(scenario);
        Simulation alone(scenario);
        Simulation sharing(scenario, noise);
        const auto end = [](const Simulation& s) { return s.time_s() >= 300; };
        flyTo(alone, 4, end);
        flyTo(sharing, 4, end);
        QVERIFY(alone.state() == sharing.state());
        QVERIFY(alone.truth_m(7) == sharing.truth_m(7));
    }

    void noiseOfAnotherScenarioIsABug()
    {
        const std::vector<DriftNoise> noise = drawNoise(randomScenario(5));
        QVERIFY_THROWS_EXCEPTION(std::logic_error, Simulation(randomScenario(6), noise));
        const std::span<const DriftNoise> some = std::span(noise).first(3);
        QVERIFY_THROWS_EXCEPTION(std::logic_error, Simulation(randomScenario(5), some));
    }
};

QTEST_APPLESS_MAIN(TestSimulation)
#include "tst_simulation.moc"
