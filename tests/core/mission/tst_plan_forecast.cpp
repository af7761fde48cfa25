#include "core/base/random.h"
#include "core/mission/mission.h"
#include "core/presets/presets.h"
#include "tests/support/approx.h"
#include "tests/support/flight/flown_plans.h"
#include "tests/support/flight/scenario_builder.h"

#include <QtTest>

#include <algorithm>
#include <numeric>

using namespace berg;

namespace {

constexpr double kAirspeed_mps = 20;

/** Standing icebergs, each with its own sigma and q, and the UAV at the origin. */
struct Sea
{
    WorldState state{.uavs = std::vector<UavState>(1)};
    std::vector<bool> active;

    Sea& add(const Point& at_m, double sigma_m2, double q_m2ps)
    {
        state.tracks.push_back({.anchor_m = at_m, .sigma_m2 = sigma_m2, .q_m2ps = q_m2ps});
        active.push_back(true);
        return *this;
    }
    [[nodiscard]] ForecastStart start(const Point& wind_mps = Point::Zero()) const
    {
        return {.world = state,
                .active = active,
                .time_s = 100,
                .airspeeds_mps = {kAirspeed_mps},
                .wind_mps = wind_mps};
    }
};

Sea randomWorld(std::uint64_t seed, int icebergs)
{
    Random random(seed);
    Sea world;
    for (int i = 0; i < icebergs; ++i)
        world.add({random.uniform(-5000, 5000), random.uniform(-5000, 5000)}, random.uniform(0, 20),
                  random.uniform(0, 0.1));
    return world;
}

/** Sums sigma dt in small steps and sets each sigma to zero at its time. */
double integratedZeta(const Sea& world, const PlanForecast& forecast, double horizon_s)
{
    constexpr double kStep_s = 0.01;
    std::vector<double> sigma_m2;
    for (const Track& track : world.state.tracks)
        sigma_m2.push_back(track.sigma_m2);
    double zeta_m2s = 0;
    std::size_t next = 0;
    const auto steps = static_cast<int>(std::lround(horizon_s / kStep_s));
    for (int step = 0; step < steps; ++step) {
        for (; next < forecast.uavs[0].visits.size() &&
               forecast.uavs[0].visits[next].arrival_s <= (step + 0.5) * kStep_s;
             ++next)
            sigma_m2[toIndex(forecast.uavs[0].visits[next].iceberg)] = 0;
        for (std::size_t i = 0; i < sigma_m2.size(); ++i) {
            if (!world.active[i])
                continue;
            const double grown_m2 = world.state.tracks[i].q_m2ps * kStep_s;
            zeta_m2s += (sigma_m2[i] + grown_m2 / 2) * kStep_s;
            sigma_m2[i] += grown_m2;
        }
    }
    return zeta_m2s;
}

/** Four icebergs in a row ahead of the UAV, visible only at close range. */
Scenario rowOfIcebergs(double duration_s, PolicyKind policy)
{
    Scenario scenario = test::emptySea(duration_s);
    scenario.uavs.front().fov_m = {80, 80};
    scenario.planner.policy = policy;
    scenario.planner.tau = 50; // shortest path
    for (int i = 0; i < 4; ++i)
        test::addIceberg(scenario, 3000.0 * (i + 1), 0, 5 + 3.0 * i).q_m2ps = 0.05;
    return scenario;
}

ForecastStart startOf(const Mission& mission)
{
    const Simulation& simulation = mission.simulation();
    ForecastStart start{.world = simulation.state(),
                        .time_s = simulation.time_s(),
                        .airspeeds_mps = {mission.scenario().uavs.front().spec.airspeed_mps},
                        .wind_mps = mission.scenario().wind_mps};
    for (const IcebergIndex i : simulation.icebergs())
        start.active.push_back(simulation.active(i));
    return start;
}

} // namespace

class TestPlanForecast : public QObject
{
    Q_OBJECT

private slots:
    /** An uncertain velocity adds to sigma before and after a visit, as the filter predicts. */
    void sigmaGrowsAsTheFilterPredicts()
    {
        Sea world;
        world.add({2000, 0}, 30, 0.05).add({0, 5000}, 4, 0.01);
        world.state.tracks[0].mixed_m2ps = 3;
        world.state.tracks[0].velocity_m2ps2 = 0.5;
        world.state.tracks[1].velocity_m2ps2 = 0.02;
        world.state.tracks[1].velocitySpread_mps = 0.3;
        world.state.tracks[1].velocityTime_s = 150;
        constexpr double kHorizon_s = 400;
        const PlanForecast forecast = forecastPlan(world.start(), {{0}}, kHorizon_s);
        const ForecastVisit& visit = forecast.uavs[0].visits.front();
        COMPARE_NEAR(visit.arrival_s, 100, 1e-9);
        COMPARE_NEAR(visit.arrivalSigma_m2, world.state.tracks[0].sigmaAfter_m2(100), 1e-9);

        std::vector<Track> tracks = world.state.tracks;
        constexpr double kStep_s = 0.01;
        double zeta_m2s = 0;
        for (int step = 0; step < static_cast<int>(kHorizon_s / kStep_s); ++step) {
            if (step == 10'000) // seen exactly
                tracks[0].measured({2000, 0}, 0, 200);
            for (Track& track : tracks) {
                zeta_m2s += track.sigma_m2 * kStep_s / 2;
                track.grow(kStep_s);
                zeta_m2s += track.sigma_m2 * kStep_s / 2;
            }
        }
        COMPARE_NEAR(forecast.zeta_m2s / zeta_m2s, 1, 1e-6); // trapezia of small steps
    }

    void oneVisitByHand()
    {
        Sea world;
        world.add({300, 400}, 6, 0.05).add({-1000, 0}, 2, 0.01);
        const IcebergList order{0};
        const double horizon_s = 200;
        const PlanForecast forecast = forecastPlan(world.start(), {order}, horizon_s);
        QCOMPARE(forecast.uavs[0].visits.size(), std::size_t{1});
        COMPARE_NEAR(forecast.uavs[0].visits[0].leg_m, 500, 1e-9);
        COMPARE_NEAR(forecast.uavs[0].visits[0].arrival_s, 25, 1e-9);
        COMPARE_NEAR(forecast.uavs[0].visits[0].arrivalSigma_m2, 6 + 0.05 * 25, 1e-9);
        COMPARE_NEAR(forecast.uavs[0].distance_m, 500, 1e-9);
        const double visited_m2s =
            6 * horizon_s + 0.05 * horizon_s * horizon_s / 2 - (6 + 0.05 * 25) * (horizon_s - 25);
        const double other_m2s = 2 * horizon_s + 0.01 * horizon_s * horizon_s / 2;
        COMPARE_NEAR(forecast.zeta_m2s, visited_m2s + other_m2s, 1e-9);
    }

    void equalsAnIntegration_data()
    {
        QTest::addColumn<int>("seed");
        QTest::addColumn<double>("horizon_s");
        for (int seed = 1; seed <= 4; ++seed)
            for (const double horizon_s : {50.0, 900.0, 4000.0})
                QTest::addRow("seed %d, %g s", seed, horizon_s) << seed << horizon_s;
    }

    void equalsAnIntegration()
    {
        QFETCH(int, seed);
        QFETCH(double, horizon_s);
        Sea world = randomWorld(static_cast<std::uint64_t>(seed), 7);
        world.active[6] = false;
        IcebergList order{3, 0, 5, 1, 2, 0}; // one of them twice, 4 not at all
        const PlanForecast forecast = forecastPlan(world.start({3, -8}), {order}, horizon_s);
        const double integrated_m2s = integratedZeta(world, forecast, horizon_s);
        // An arrival is found to half a step: sigma, 100 m^2 at most, times 5 ms for each of six.
        COMPARE_NEAR(forecast.zeta_m2s, integrated_m2s, 6 * 100 * 0.005 + 1e-6 * integrated_m2s);
    }

    void windChangesArrivals()
    {
        Sea world;
        world.add({0, 600}, 1, 0);
        const IcebergList order{0};
        const Point wind_mps(0, 10);
        COMPARE_NEAR(forecastPlan(world.start(wind_mps), {order}, 1).uavs[0].visits[0].arrival_s,
                     20, 1e-9);
    }

    void aimsAheadOfDrift()
    {
        Sea world;
        world.add({0, 0}, 1, 0);
        world.state.tracks[0].velocity_mps = {2, 0}; // 100 s after its anchor: 200 m ahead
        const IcebergList order{0};
        const ForecastVisit visit = forecastPlan(world.start(), {order}, 1).uavs[0].visits[0];
        COMPARE_NEAR(visit.arrival_s, 200 / (kAirspeed_mps - 2), 1e-9);
        COMPARE_NEAR(visit.leg_m, kAirspeed_mps * visit.arrival_s, 1e-9);
    }

    void anUnknownIcebergIsABug()
    {
        const Sea world = randomWorld(1, 2);
        const IcebergList order{2};
        QVERIFY_THROWS_EXCEPTION(std::logic_error,
                                 static_cast<void>(forecastPlan(world.start(), {order}, 10)));
    }

    /**
     * With straight legs, no noise and a small field of view the flight agrees with the forecast.
     */
    void aFlightComesOutAsForecast()
    {
        const double duration_s = 12000 / 22.0 + 60; // the last visit, and a little more
        Mission mission(rowOfIcebergs(duration_s, PolicyKind::Path));
        mission.advance(0);
        const IcebergList order = test::flownPlans(mission).front().order;
        QCOMPARE(order, (IcebergList{0, 1, 2, 3}));
        const PlanForecast forecast = forecastPlan(startOf(mission), {order}, duration_s);
        mission.advance(duration_s);
        QCOMPARE(mission.metrics().visits, 4);
        // Each is seen 40 m early and for 80 m, that is 1.8 and 3.6 s of some hundreds.
        COMPARE_NEAR(mission.metrics().zeta_m2s, forecast.zeta_m2s, 0.01 * forecast.zeta_m2s);
        QVERIFY(mission.metrics().zeta_m2s < forecast.zeta_m2s);
    }

    void noChange_data()
    {
        QTest::addColumn<IcebergList>("before");
        QTest::addColumn<IcebergList>("after");
        QTest::newRow("nothing was left") << IcebergList{} << IcebergList{0, 1};
        QTest::newRow("the same") << IcebergList{1, 0} << IcebergList{1, 0};
        QTest::newRow("goes on after it") << IcebergList{1, 0} << IcebergList{1, 0, 2};
    }

    void noChange()
    {
        QFETCH(IcebergList, before);
        QFETCH(IcebergList, after);
        const Sea world = randomWorld(2, 3);
        QVERIFY(!planChanges(world.start(), {before}, {after}, 1000)[0]);
    }

    /**
     * Both orders start at one instant; icebergs that only the new one visits come last in the old
     * one.
     */
    void changeComparesFlights()
    {
        const Sea world = randomWorld(3, 4);
        const IcebergList after{3, 1, 0, 2};
        const IcebergList flownBefore{0, 1, 3, 2};
        const double horizon_s = 2000;
        const std::optional<PlanChange> change =
            planChanges(world.start(), {IcebergList{0, 1}}, {after}, horizon_s)[0];
        QVERIFY(change);
        QCOMPARE(change->before, (IcebergList{0, 1}));
        const PlanForecast old = forecastPlan(world.start(), {flownBefore}, horizon_s);
        const PlanForecast now = forecastPlan(world.start(), {after}, horizon_s);
        COMPARE_NEAR(change->distance_m, now.uavs[0].distance_m - old.uavs[0].distance_m, 1e-9);
        COMPARE_NEAR(change->zeta_m2s, now.zeta_m2s - old.zeta_m2s, 1e-9);
        const std::optional<PlanChange> back =
            planChanges(world.start(), {after}, {flownBefore}, horizon_s)[0];
        QVERIFY(back);
        COMPARE_NEAR(back->zeta_m2s, -change->zeta_m2s, 1e-9);
    }

    /**
     * Changing from the shortest path to the most uncertain first makes the order longer, measured
     * from the UAV.
     */
    void anInterventionIsAChange()
    {
        Mission mission(rowOfIcebergs(1000, PolicyKind::Visitation));
        mission.advance(60);
        QVERIFY(!test::flownPlans(mission).front().change);
        mission.intervene({.tau = 0.0});
        mission.advance(60);
        const test::FlownPlan plan = test::flownPlans(mission).back();
        QCOMPARE(plan.order, (IcebergList{3, 2, 1, 0}));
        QVERIFY(plan.change);
        QCOMPARE(plan.change->before, (IcebergList{0, 1, 2, 3}));
        // Both fly to the last of the row, then back to the first of it.
        COMPARE_NEAR(plan.change->distance_m, 9000, 1e-6);
        mission.intervene({.tau = 0.01}); // gives the same plan
        mission.advance(60);
        QCOMPARE(mission.plans().size(), std::size_t{3});
        QVERIFY(!test::flownPlans(mission).back().change);
    }

    void reachingTheTargetIsNoChange()
    {
        Mission mission(rowOfIcebergs(300, PolicyKind::Path));
        mission.advance(300); // past two icebergs
        QVERIFY(mission.metrics().visits >= 2);
        for (const test::FlownPlan& plan : test::flownPlans(mission))
            QVERIFY(!plan.change);
    }

    /** Fixed routes keep icebergs in view, and those just reached, in their order. */
    void aFixedRouteNeverChanges()
    {
        for (const PolicyKind policy : {PolicyKind::Tour, PolicyKind::Path}) {
            Scenario scenario = randomScenario(5, {.icebergs = 9});
            scenario.duration_s = 1500;
            scenario.noise = false;
            scenario.planner.policy = policy;
            Mission mission(scenario);
            mission.advance(scenario.duration_s);
            QVERIFY(mission.metrics().visits > 5);
            for (std::size_t k = 1; k < mission.plans().size(); ++k)
                QVERIFY(!test::flownPlans(mission)[k].change);
        }
    }
};

QTEST_APPLESS_MAIN(TestPlanForecast)
#include "tst_plan_forecast.moc"
