#include "core/coverage/coverage_model.h"
#include "core/io/files/run_json.h"
#include "core/io/files/scenario_json.h"
#include "core/io/results/result_csv.h"
#include "core/mission/mission_instant.h"
#include "core/presets/presets.h"
#include "tests/support/approx.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/files/flight_tables.h"
#include "tests/support/flight/scenario_builder.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace berg;
using namespace berg::test;
using test::addIceberg;
using test::emptySea;

namespace {

Asset platform(double east_m, double north_m)
{
    Asset asset;
    asset.name = "platform";
    asset.position_m = {east_m, north_m};
    asset.range_m = 1000;
    asset.gain = 20;
    return asset;
}

/** Two equal icebergs west and east of the UAV; the nearer one is in the west. */
Scenario twoSides()
{
    Scenario scenario = emptySea();
    scenario.uavs[0].heading_deg = 0;
    addIceberg(scenario, -2000, 0);
    addIceberg(scenario, 2500, 0);
    return scenario;
}

IcebergIndex firstTarget(const Scenario& scenario)
{
    return planFromStart(scenario).uavs[0].order.at(0);
}

std::size_t alarmsOf(const Mission& mission)
{
    return static_cast<std::size_t>(
        std::count_if(mission.events().begin(), mission.events().end(),
                      [](const MissionEvent& e) { return e.kind == EventKind::Alarm; }));
}

} // namespace

/** Icebergs near the asset, or approaching it, are more urgent; zeta is unchanged. */
class TestAsset : public QObject
{
    Q_OBJECT

private slots:
    void priorityByHand()
    {
        const Asset asset = platform(0, 0);
        const RelativeMotion still{.offset_m = {1000, 0}, .velocity_mps = {0, 0}};
        COMPARE_NEAR(priority(asset, still), 1 + 20 * std::exp(-1.0), 1e-12);
        // This iceberg comes within 500 m in the next hour.
        const RelativeMotion coming{.offset_m = {3000, 500}, .velocity_mps = {-1, 0}};
        COMPARE_NEAR(priority(asset, coming), 1 + 20 * std::exp(-0.25), 1e-12);
        const RelativeMotion far{.offset_m = {90'000, 0}, .velocity_mps = {0, 0}};
        COMPARE_NEAR(priority(asset, far), 1, 1e-12);
    }

    /** A ship that steams away from an iceberg is not threatened by it, and vice versa. */
    void theAssetMayMove()
    {
        Asset ship = platform(0, 0);
        ship.velocity_mps = {5, 0};
        const RelativeMotion later = relativeToAsset(ship, 100, {1500, 0}, {0, 0});
        QCOMPARE(later.offset_m, Point(1000, 0));
        COMPARE_NEAR(closestApproach(later, kApproachHorizon_s).distance_m, 0, 1e-9);
    }

    void plansGoThereFirst()
    {
        for (const PolicyKind policy : {PolicyKind::Visitation, PolicyKind::Latency,
                                        PolicyKind::Uncertainty, PolicyKind::Coverage}) {
            Scenario scenario = twoSides();
            scenario.planner.policy = policy;
            QCOMPARE(firstTarget(scenario), IcebergIndex(0));
            scenario.asset = platform(2500, 300);
            QCOMPARE(firstTarget(scenario), IcebergIndex(1));
        }
    }

    /** With gain 0 the flight is the same to the last bit. */
    void withoutGainNothingChanges()
    {
        for (const PolicyKind policy : {PolicyKind::Visitation, PolicyKind::Coverage}) {
            Scenario scenario = randomScenario(4);
            scenario.duration_s = 200;
            scenario.planner.policy = policy;
            Mission without(scenario);
            scenario.asset = platform(2000, 2000);
            scenario.asset->gain = 0;
            Mission with(scenario);
            without.advance(200);
            with.advance(200);
            QVERIFY(with.metrics() == without.metrics());
        }
    }

    /** The weighted sum is separate from zeta, which has no weights. */
    void weightedSumBesideZeta()
    {
        Scenario scenario = twoSides();
        scenario.duration_s = 60;
        Mission plain(scenario);
        plain.advance(60);
        QCOMPARE(plain.recorder().samples().back().weightedSum_m2,
                 plain.recorder().samples().back().sigmaSum_m2);
        QVERIFY(written(writeZeta, plain).starts_with("time_s,sigma_sum_m2,zeta_m2s\n"));

        scenario.asset = platform(2500, 0);
        Mission weighted(scenario);
        weighted.advance(60);
        const Simulation& world = weighted.simulation();
        const Sample& last = weighted.recorder().samples().back();
        COMPARE_NEAR(last.sigmaSum_m2, world.track(0).sigma_m2 + world.track(1).sigma_m2, 1e-12);
        COMPARE_NEAR(last.weightedSum_m2,
                     priority(world.observer(), 0) * world.track(0).sigma_m2 +
                         21 * world.track(1).sigma_m2,
                     1e-9);
        QVERIFY(written(writeZeta, weighted)
                    .starts_with("time_s,sigma_sum_m2,zeta_m2s,weighted_sigma_sum_m2\n"));
    }

    /** An aimed plan predicts the zeta of the flight, without weights. */
    void predictedZetaHasNoWeights()
    {
        Scenario scenario = randomScenario(8, {.icebergs = 5});
        scenario.noise = false;
        scenario.duration_s = 300;
        scenario.planner.policy = PolicyKind::Coverage;
        scenario.asset = platform(2000, 1500);
        const double predicted_m2s = planFromStart(scenario).predictedZeta_m2s.value();
        Mission mission(scenario);
        mission.advance(300);
        // The flight is replanned, usually for the better.
        QVERIFY(mission.metrics().zeta_m2s < 1.05 * predicted_m2s);
        QVERIFY(mission.metrics().zeta_m2s > 0.7 * predicted_m2s);
    }

    void alarmOncePerApproach()
    {
        Scenario scenario = emptySea(2000);
        addIceberg(scenario, 3000, 0).velocity_mps = {-1, 0};
        addIceberg(scenario, 3000, 9000);
        scenario.asset = platform(0, 0);
        scenario.asset->alarm_m = 400;
        Mission mission(scenario);
        mission.advance(2000);
        QCOMPARE(alarmsOf(mission), 1U);
        const auto alarm =
            std::find_if(mission.events().begin(), mission.events().end(),
                         [](const MissionEvent& e) { return e.kind == EventKind::Alarm; });
        QCOMPARE(alarm->iceberg, IcebergIndex(0));
        COMPARE_NEAR(alarm->entry_s, 2599, 0.5); // found at t = 1 s
        scenario.asset->alarm_m.reset();         // half the range
        QCOMPARE(alarmRadius_m(*scenario.asset), 500.0);
        scenario.icebergs[0].velocity_mps = {0, 0};
        Mission calm(scenario);
        calm.advance(2000);
        QCOMPARE(alarmsOf(calm), 0U);
    }

    /** Older files may hold the 0 that stood for half the range. */
    void anInnerRingOfZeroIsHalfTheRange()
    {
        Scenario scenario = emptySea(100);
        scenario.asset = platform(0, 0);
        scenario.asset->alarm_m = 1234;
        std::string text = scenarioToJson(scenario);
        const std::size_t at = text.find("1234");
        QVERIFY(at != std::string::npos);
        text.replace(at, 4, "0");
        const Scenario read = scenarioFromJson(text, "text");
        QVERIFY(!read.asset.value().alarm_m);
        QVERIFY(scenarioToJson(read).find("alarm_m") == std::string::npos);
        QCOMPARE(alarmRadius_m(*read.asset), 500.0);
    }

    void anAssetSetInFlightReplays()
    {
        Scenario scenario = randomScenario(5);
        Mission mission(scenario, {.keyframeInterval_s = 100});
        mission.advance(200);
        mission.intervene({.asset = platform(4000, 500)});
        QCOMPARE(mission.plans().size() > 0, true);
        mission.advance(600);
        Mission plain(scenario);
        plain.advance(600);
        QVERIFY(mission.metrics() != plain.metrics());

        const RunFile read = runFromJson(runToJson(runOf(mission)), "run");
        QVERIFY(read == runOf(mission));
        QVERIFY(compareRun(read, runOf(replay(read))).empty());
        const MissionInstant instant = instantAt(mission, 330);
        Mission again(scenario);
        again.advance(200);
        again.intervene({.asset = platform(4000, 500)});
        again.advance(330);
        QVERIFY(instant.simulation.state() == again.simulation().state());
    }

    void badAssetsInFlightAreRefused()
    {
        Mission mission(randomScenario(5));
        mission.advance(10);
        Asset asset = platform(0, 0);
        asset.alarm_m = -1;
        QVERIFY_THROWS_EXCEPTION(Error, mission.intervene({.asset = asset}));
        QVERIFY(mission.interventions().empty());
        QVERIFY(!mission.simulation().world().asset());
    }
};

QTEST_APPLESS_MAIN(TestAsset)
#include "tst_asset.moc"
