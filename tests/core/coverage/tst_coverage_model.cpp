#include "core/coverage/plan_conversion.h"
#include "core/mission/plan_requests.h"
#include "core/presets/presets.h"
#include "core/sim/simulation.h"
#include "tests/support/flight/scenario_builder.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace berg;
using test::addIceberg;
using test::emptySea;

namespace {

/** Predicted and flown results of legs in the simulation. */
struct FlownPlan
{
    double largestMiss_m = 0; ///< at leg ends, against the prediction
    double predicted_m2s = 0;
    double flown_m2s = 0;
    int legs = 0;
};

/** Flies one aimed leg until its iceberg is in view, and ignores other sightings. */
void flyLeg(Simulation& simulation, const AimedLeg& leg, double until_s)
{
    simulation.setTarget(0, leg.iceberg, leg);
    while (!simulation.finished() && simulation.time_s() < until_s) {
        simulation.advanceStep();
        if (simulation.planReason() != PlanReason::None) {
            if (simulation.track(leg.iceberg).inView)
                return;
            simulation.setTarget(0, leg.iceberg, simulation.uav(0).aim);
        }
    }
}

/**
 * Flies random legs. Each leg is predicted from the end of the flown leg before, and zeta is
 * compared leg by leg, so that errors of very close sightings do not accumulate.
 */
FlownPlan flyRandomLegs(const Scenario& scenario, int legs, Random random)
{
    Simulation simulation(scenario);
    FlownPlan result;
    for (int k = 0; k < legs && !simulation.finished(); ++k) {
        const PlanRequest request = planRequest(simulation);
        const CoverageModel model(*request.uavs[0].prediction, {.length_s = 1e6});
        CoverageLeg leg{.offset_m = random.uniform(-1, 1) * model.largestOffset_m()};
        do
            leg.iceberg = ModelPlace::of(random.below(scenario.icebergs.size()));
        while (!request.uavs[0].available[toIndex(leg.iceberg)]);
        CoverageState state = model.start();
        if (!model.fly(state, leg))
            continue;
        const double zeta_m2s = simulation.zeta_m2s();
        const double end_s = simulation.time_s() + state.time_s;
        if (end_s > scenario.duration_s)
            break;
        flyLeg(simulation, describe(model, request.uavs[0], request.ids, {leg}).legs.front(),
               end_s + 3);
        const Point predicted_m = state.uav.position_m + scenario.wind_mps * state.time_s;
        const double late_s = simulation.time_s() - end_s;
        const Point flown_m =
            simulation.uav(0).pose.position_m - late_s * (22 * state.uav.ahead + scenario.wind_mps);
        result.largestMiss_m = std::max(result.largestMiss_m, (flown_m - predicted_m).norm());
        result.predicted_m2s += model.costSoFar_m2s(state);
        result.flown_m2s +=
            simulation.zeta_m2s() - zeta_m2s - late_s * simulation.state().sigmaSum_m2;
        ++result.legs;
    }
    return result;
}

CoverageModel modelOf(const Scenario& scenario, const CoverageHorizon& horizon)
{
    return CoverageModel(*planRequest(Simulation(scenario)).uavs[0].prediction, horizon);
}

} // namespace

class TestCoverageModel : public QObject
{
    Q_OBJECT

private slots:
    /** The closed form agrees with the simulation, over random legs and scenarios. */
    void predictsTheFlight_data()
    {
        QTest::addColumn<FovShape>("shape");
        QTest::addColumn<double>("wind_mps");
        QTest::addColumn<double>("largest_m");
        QTest::newRow("body") << FovShape::Body << 0.0 << 0.5;
        // A corner that is 10 m smaller in the plan may come into view during the turn.
        QTest::newRow("north") << FovShape::North << 0.0 << 20.0;
        QTest::newRow("disk") << FovShape::Disk << 0.0 << 2.0;
        QTest::newRow("agile") << FovShape::Body << 0.0 << 0.5;
        QTest::newRow("wind") << FovShape::Body << 9.0 << 0.5;
    }
    void predictsTheFlight()
    {
        QFETCH(FovShape, shape);
        QFETCH(double, wind_mps);
        QFETCH(double, largest_m);
        FlownPlan all;
        for (int seed = 1; seed <= 20; ++seed) {
            Scenario scenario = randomScenario(seed);
            scenario.noise = false;
            scenario.duration_s = 3000;
            scenario.fovShape = shape;
            scenario.wind_mps = Point(wind_mps, -wind_mps / 2);
            if (QTest::currentDataTag() == QByteArray("agile"))
                scenario.uavs[0].spec.maxBank_deg = 70;
            const FlownPlan one = flyRandomLegs(scenario, 30, Random(static_cast<unsigned>(seed)));
            all.largestMiss_m = std::max(all.largestMiss_m, one.largestMiss_m);
            all.predicted_m2s += one.predicted_m2s;
            all.flown_m2s += one.flown_m2s;
            all.legs += one.legs;
        }
        QVERIFY(all.legs > 400);
        const double error = all.predicted_m2s / all.flown_m2s - 1;
        qInfo("%d legs: ends within %.2f m, zeta predicted %+.4f %%", all.legs, all.largestMiss_m,
              100 * error);
        QVERIFY(all.largestMiss_m < largest_m);
        // The flight sees icebergs that the narrower planned view misses, so the prediction is too
        // high.
        QVERIFY(std::abs(error) < 0.005);
    }

    /** The prediction for an iceberg straight ahead agrees with a calculation by hand. */
    void oneIcebergAhead()
    {
        Scenario scenario = emptySea();
        addIceberg(scenario, 3297, 0, 4).q_m2ps = 0.02;
        const CoverageModel model = modelOf(scenario, {.length_s = 200, .rest_s = 10});
        CoverageState state = model.start();
        std::vector<CoverageSighting> sightings;
        QVERIFY(model.fly(state, {.iceberg = 0, .offset_m = 0}, &sightings));
        // The planned view is that much shorter ahead.
        const double seen_s = (3297 - 300 + 10.0 / 3) / 22;
        QVERIFY(std::abs(state.time_s - seen_s) < 1e-9);
        QCOMPARE(sightings.size(), std::size_t{1});
        QVERIFY(std::abs(sightings[0].time_s - seen_s) < 1e-9);
        const double cost_m2s = 4 * seen_s + 0.01 * seen_s * seen_s;
        QVERIFY(std::abs(model.costSoFar_m2s(state) - cost_m2s) < 1e-6);
        QVERIFY(model.inView(state, 0) || std::abs(model.sigma_m2(state, 0)) < 1e-9);
        const double left_s = 200 - seen_s;
        QVERIFY(std::abs(model.total_m2s(state) -
                         (cost_m2s + 0.01 * left_s * left_s + 10 * 0.02 * left_s)) < 1e-6);
    }

    void anotherOnTheWayCounts()
    {
        Scenario scenario = emptySea();
        addIceberg(scenario, 3000, 0);
        addIceberg(scenario, 1500, 200, 9);
        addIceberg(scenario, 1500, 400, 9); // outside
        const CoverageModel model = modelOf(scenario, {.length_s = 1000});
        CoverageState state = model.start();
        std::vector<CoverageSighting> sightings;
        QVERIFY(model.fly(state, {.iceberg = 0, .offset_m = 0}, &sightings));
        QCOMPARE(sightings.size(), std::size_t{2});
        QCOMPARE(sightings[0].iceberg.number() + sightings[1].iceberg.number(), 1);
        const double unseen_s = state.time_s - (1500 + 300 - 10.0 / 3) / 22;
        QVERIFY(std::abs(model.sigma_m2(state, 1) - 0.025 * unseen_s) < 1e-9);
        QVERIFY(model.sigma_m2(state, 2) > 9);
    }

    /** The cost of many icebergs is the sum of their costs alone, so none is ignored. */
    void crowdIsTheSumOfAll_data()
    {
        QTest::addColumn<ObserverModel>("observer");
        QTest::newRow("simple") << ObserverModel::Simple;
        QTest::newRow("kalman") << ObserverModel::Kalman;
    }
    void crowdIsTheSumOfAll()
    {
        QFETCH(ObserverModel, observer);
        Scenario crowd = randomScenario(4, {.icebergs = 90, .size_m = Point(2500, 2500)});
        crowd.observer.model = observer;
        const std::vector<CoverageLeg> legs{holdOf(50), holdOf(12, -1), holdOf(40), holdOf(30, 1)};
        const auto cost_m2s = [&](const Scenario& scenario) {
            const CoverageModel model = modelOf(scenario, {.length_s = 1000});
            CoverageState state = model.start();
            for (const CoverageLeg& leg : legs)
                model.fly(state, leg);
            return model.total_m2s(state);
        };
        double sum_m2s = 0;
        for (const Iceberg& iceberg : crowd.icebergs) {
            Scenario alone = crowd;
            alone.icebergs = {iceberg};
            sum_m2s += cost_m2s(alone);
        }
        QVERIFY(std::abs(cost_m2s(crowd) / sum_m2s - 1) < 1e-12); // rounding
    }

    void endsAtTheHorizon()
    {
        Scenario scenario = emptySea();
        addIceberg(scenario, 0, 5000);
        for (const double length_s : {3.3, 60.0}) { // The horizon ends in the turn or on the line.
            const CoverageModel model = modelOf(scenario, {.length_s = length_s});
            CoverageState state = model.start();
            QVERIFY(model.fly(state, {.iceberg = 0, .offset_m = 100}));
            QCOMPARE(state.time_s, length_s);
            QVERIFY(model.atEnd(state));
            QVERIFY(!model.fly(state, {.iceberg = 0, .offset_m = 0}));
            const double cost_m2s = 5 * length_s + 0.0125 * length_s * length_s;
            QVERIFY(std::abs(model.total_m2s(state) - cost_m2s) < 1e-6);
        }
    }

    void icebergInViewIsNoLeg()
    {
        Scenario scenario = emptySea();
        addIceberg(scenario, 100, 0);
        const CoverageModel model = modelOf(scenario, {.length_s = 100});
        CoverageState state = model.start();
        QVERIFY(!model.fly(state, {.iceberg = 0, .offset_m = 0}));
        QCOMPARE(state.time_s, 0.0);
    }

    /**
     * An iceberg seen at the very edge of the sensor is in view for the narrower planned view, too.
     */
    void sightingsAtTheEdgeAreTakenAsTheyAre_data()
    {
        QTest::addColumn<FovShape>("shape");
        QTest::newRow("body") << FovShape::Body;
        QTest::newRow("north") << FovShape::North;
        QTest::newRow("disk") << FovShape::Disk;
    }
    void sightingsAtTheEdgeAreTakenAsTheyAre()
    {
        QFETCH(FovShape, shape);
        Scenario scenario = emptySea();
        scenario.fovShape = shape;
        addIceberg(scenario, 0, 299);
        const PlanRequest request = planRequest(Simulation(scenario));
        QVERIFY(!request.uavs[0].available[0]);
        const CoverageModel seen(*request.uavs[0].prediction, {.length_s = 100});
        QVERIFY(seen.inView(seen.start(), 0));
        // The estimate is in the middle of the view, but the iceberg is not seen, so it must be
        // elsewhere.
        PredictionInput input = *request.uavs[0].prediction;
        input.tracks[0].anchor_m = Point(20, 120);
        input.tracks[0].inView = false;
        input.tracks[0].sigma_m2 = 3;
        const CoverageModel unseen(input, {.length_s = 100});
        QVERIFY(!unseen.inView(unseen.start(), 0));
        QVERIFY(unseen.distance_m(unseen.start(), 0) < 310);
    }
};

QTEST_APPLESS_MAIN(TestCoverageModel)
#include "tst_coverage_model.moc"
