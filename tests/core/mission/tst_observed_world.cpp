#include "core/bound/zeta_bound.h"
#include "core/io/files/run_json.h"
#include "core/mission/mission_instant.h"
#include "core/mission/visits.h"
#include "core/presets/presets.h"
#include "core/scenario/initial_truth.h"
#include "tests/support/approx.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/flight/flown_plans.h"
#include "tests/support/flight/scenario_builder.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace berg;
using namespace berg::test;

namespace {

int count(const Mission& mission, EventKind kind)
{
    return static_cast<int>(
        std::count_if(mission.events().begin(), mission.events().end(),
                      [kind](const MissionEvent& event) { return event.kind == kind; }));
}

Scenario measuredField(std::int64_t seed, double velocitySd_mps)
{
    Scenario scenario = randomScenario(seed);
    scenario.observer.model = ObserverModel::Kalman;
    for (Iceberg& iceberg : scenario.icebergs)
        iceberg.velocitySd_mps = velocitySd_mps;
    return scenario;
}

/** A field of unknown, changing velocities. */
Scenario changingField(std::int64_t seed, double time_s)
{
    Scenario scenario = measuredField(seed, 0.15);
    scenario.observer.search = SearchPattern::None;
    for (Iceberg& iceberg : scenario.icebergs) {
        iceberg.velocitySpread_mps = 0.15;
        iceberg.velocityTime_s = time_s;
    }
    return scenario;
}

/** One iceberg ahead with a beacon, truly `off_m` north of its estimate. */
Scenario ghost(double off_m)
{
    Scenario scenario = emptySea(2000);
    scenario.observer.model = ObserverModel::Kalman;
    addIceberg(scenario, 3000, 0).track = {.time_s = {0, 10000},
                                           .position_m = {{3000, off_m}, {3000, off_m}}};
    addIceberg(scenario, 9000, 0);
    return scenario;
}

Mission flownToEnd(const Scenario& scenario)
{
    Mission mission(scenario);
    mission.advance(scenario.duration_s);
    return mission;
}

/** Returns the track of the first iceberg when it is found again. */
Track whenFound(const Scenario& scenario)
{
    Mission mission(scenario);
    while (count(mission, EventKind::Found) == 0 &&
           mission.simulation().time_s() < scenario.duration_s)
        mission.advance(mission.simulation().time_s() + scenario.dt_s);
    require(count(mission, EventKind::Found) > 0, "it is found");
    return mission.simulation().track(0);
}

/** Writes, reads and replays the flight. */
bool isSameFlight(const Mission& mission)
{
    const RunFile run = runOf(mission);
    const RunFile read = runFromJson(runToJson(run), "run");
    return read == run && compareRun(read, runOf(replay(read))).empty();
}

} // namespace

/** Measurements, lost and found, in closed loop. */
class TestObservedWorld : public QObject
{
    Q_OBJECT

private slots:
    /**
     * With known velocity and start and perfect measurements at each step it is the paper's model.
     */
    void agreesWithTheSimpleModel_data()
    {
        QTest::addColumn<PolicyKind>("policy");
        QTest::newRow("visitation") << PolicyKind::Visitation;
        QTest::newRow("latency") << PolicyKind::Latency;
    }
    void agreesWithTheSimpleModel()
    {
        QFETCH(PolicyKind, policy);
        for (const std::int64_t seed : {1, 2, 3, 4}) {
            Scenario simple = randomScenario(seed);
            simple.planner.policy = policy;
            for (Iceberg& iceberg : simple.icebergs)
                iceberg.sigma0_m2 = 0; // the filter's truth starts with an error of that variance
            Scenario measured = simple;
            measured.observer = {
                .model = ObserverModel::Kalman, .positionSd_m = 0, .interval_s = simple.dt_s};
            const Mission a = flownToEnd(simple);
            const Mission b = flownToEnd(measured);
            QCOMPARE(b.metrics().visits, a.metrics().visits);
            COMPARE_NEAR(b.metrics().zeta_m2s / a.metrics().zeta_m2s, 1, 1e-9);
            QCOMPARE(count(b, EventKind::Lost), 0);
        }
    }

    /** The filters are consistent in flight: the mean squared error equals sigma. */
    void sigmaIsTheErrorSquared()
    {
        double error = 0;
        int samples = 0;
        for (std::int64_t seed = 1; seed <= 40; ++seed) {
            Scenario scenario = measuredField(seed, 0.1);
            scenario.observer.search = SearchPattern::None;
            Mission mission(scenario);
            for (const double time_s : {150.0, 400.0, 650.0, 900.0}) {
                mission.advance(time_s);
                const Simulation& now = mission.simulation();
                for (const IcebergIndex i : now.icebergs()) {
                    if (now.track(i).status != TrackStatus::Tracked)
                        continue;
                    error += (now.truth_m(i) - now.observer().estimate_m(i)).squaredNorm() /
                             (2 * now.track(i).sigma_m2);
                    ++samples;
                }
            }
        }
        // About 1900 samples of chi-square with 2 degrees of freedom over 2, those of one iceberg
        // dependent: 40 x 12 independent ones give sd 1 / sqrt(480) = 0.046; three of them.
        QVERIFY2(std::abs(error / samples - 1) < 0.14,
                 qPrintable(QString::number(error / samples)));
    }

    /** Six hours after its last sighting at 0.1 m/s the iceberg is known to 2.2 km, not to 23 m. */
    void theAgeOfASightingCountsItsVelocity()
    {
        Scenario scenario = emptySea(100);
        scenario.observer.model = ObserverModel::Kalman;
        scenario.noise = true;
        constexpr double kAge_s = 21'600;
        constexpr double kSd_mps = 0.1;
        for (int i = 0; i < 500; ++i) {
            Iceberg& iceberg = addIceberg(scenario, 1e5, 0);
            iceberg.observed_s = kAge_s;
            iceberg.velocitySd_mps = kSd_mps;
        }
        scenario.icebergs.back().appears_s = 50;
        const Simulation start(scenario);
        const Track& track = start.track(0);
        COMPARE_NEAR(track.sigma_m2, 5 + 540 + 2160.0 * 2160, 1e-6);
        COMPARE_NEAR(initialSigma_m2(scenario.icebergs[0]), track.sigma_m2, 1e-6);
        COMPARE_NEAR(track.mixed_m2ps, 216, 1e-9);
        COMPARE_NEAR(track.velocity_m2ps2, 0.01, 1e-15);
        COMPARE_NEAR(start.track(499).sigma_m2, 545 + 0.025 * 50 + 2165.0 * 2165, 1e-6);
        double places = 0;
        double both = 0;
        for (const Iceberg& iceberg : scenario.icebergs) {
            const InitialTruth truth = initialTruth(iceberg, scenario.observer, 7, true);
            const Point off_m = truth.position_m - iceberg.position_m;
            places += off_m.squaredNorm() / (2 * track.sigma_m2);
            both += off_m.dot(truth.velocity_mps - iceberg.velocity_mps) / (2 * track.mixed_m2ps);
        }
        // 1000 numbers squared: standard deviation sqrt(2 / 1000) = 0.045, three of them.
        COMPARE_NEAR(places / 500, 1, 0.14);
        COMPARE_NEAR(both / 500, 1, 0.14);
    }

    /** Ten hours after its last sighting a changing velocity has been forgotten. */
    void theAgeOfASightingCountsHowItsVelocityChanges()
    {
        Scenario scenario = emptySea(100);
        scenario.observer.model = ObserverModel::Kalman;
        scenario.noise = true;
        constexpr double kAge_s = 36'000;
        for (int i = 0; i < 500; ++i) {
            Iceberg& iceberg = addIceberg(scenario, 1e5, 0);
            iceberg.observed_s = kAge_s;
            iceberg.velocitySd_mps = 0.02;
            iceberg.velocitySpread_mps = 0.15;
            iceberg.velocityTime_s = 36'000;
        }
        const Track track = Simulation(scenario).track(0);
        const DriftVariances expected =
            grown({.position_m2 = 5, .velocity_m2ps2 = 0.0004}, track.process(), kAge_s);
        COMPARE_NEAR(track.sigma_m2, expected.position_m2, 1e-6);
        COMPARE_NEAR(std::sqrt(track.velocity_m2ps2), 0.15 * std::sqrt(1 - std::exp(-2.0)), 0.001);
        DriftVariances drawn;
        for (const Iceberg& iceberg : scenario.icebergs) {
            const InitialTruth truth = initialTruth(iceberg, scenario.observer, 7, true);
            const Point off_m = truth.position_m - iceberg.position_m;
            const Point off_mps = truth.velocity_mps - iceberg.velocity_mps;
            drawn.position_m2 += off_m.squaredNorm() / 1000;
            drawn.mixed_m2ps += off_m.dot(off_mps) / 1000;
            drawn.velocity_m2ps2 += off_mps.squaredNorm() / 1000;
        }
        // 1000 numbers squared: standard deviation sqrt(2 / 1000) = 0.045, three of them.
        COMPARE_NEAR(drawn.position_m2 / track.sigma_m2, 1, 0.14);
        COMPARE_NEAR(drawn.mixed_m2ps / track.mixed_m2ps, 1, 0.14);
        COMPARE_NEAR(drawn.velocity_m2ps2 / track.velocity_m2ps2, 1, 0.14);
        scenario.observer.model = ObserverModel::Simple; // this observer knows velocities
        COMPARE_NEAR(Simulation(scenario).track(0).sigma_m2, expected.position_m2, 1e-6);
        QCOMPARE(Simulation(scenario).track(0).velocityTime_s, 0.0);
    }

    /** Visits are at the true positions that the simulation drew. */
    void visitsAreWhereTheyTrulyWere()
    {
        Scenario scenario = changingField(3, 36'000);
        const Mission mission = flownToEnd(scenario);
        const std::vector<Visit> visits = flownVisits(mission, 0);
        QVERIFY(!visits.empty());
        for (const Visit& visit : visits) {
            const Simulation then = instantAt(mission, visit.time_s).simulation;
            COMPARE_NEAR((then.truth_m(visit.iceberg.value()) - visit.position_m).norm(), 0, 1e-6);
        }
    }

    /** With changing velocities errors agree with sigma, runs replay and the bound holds. */
    void changingVelocitiesAgreeWithSigma()
    {
        double error = 0;
        int samples = 0;
        for (std::int64_t seed = 1; seed <= 30; ++seed) {
            Scenario scenario = changingField(seed, seed % 2 == 0 ? 36'000 : 400);
            scenario.current_mps = {0.3, -0.2};
            Mission mission(scenario);
            for (const double time_s : {150.0, 400.0, 650.0, 1000.0}) {
                mission.advance(time_s);
                const Simulation& now = mission.simulation();
                for (const IcebergIndex i : now.icebergs()) {
                    if (now.track(i).status != TrackStatus::Tracked)
                        continue;
                    error += (now.truth_m(i) - now.observer().estimate_m(i)).squaredNorm() /
                             (2 * now.track(i).sigma_m2);
                    ++samples;
                }
            }
            if (seed > 4)
                continue;
            const double bound_m2s = zetaLowerBound(scenario, {.workLimit = 100'000'000}).zeta_m2s;
            QVERIFY(bound_m2s > 0 && bound_m2s < mission.metrics().zeta_m2s);
            QVERIFY(isSameFlight(mission));
        }
        // 30 x 12 independent ones at least: sd 1 / sqrt(360) = 0.053, three of them.
        QVERIFY2(std::abs(error / samples - 1) < 0.16,
                 qPrintable(QString::number(error / samples)));
    }

    /**
     * With measurements an iceberg is reached at its estimate once it has been seen, since its true
     * position is unknown.
     */
    void reachedByTheEstimate()
    {
        Scenario scenario = emptySea(400);
        scenario.observer.model = ObserverModel::Kalman;
        scenario.reachRadius_m = 120;
        addIceberg(scenario, 3000, 0).track = {.time_s = {0, 10000},
                                               .position_m = {{2800, 0}, {2800, 0}}};
        addIceberg(scenario, 9000, 0);
        Mission mission(scenario);
        const auto isBelievedWithin = [](const Simulation& now) {
            return (now.observer().estimate_m(0) - now.uav(0).pose.position_m).norm() <= 120;
        };
        for (double time_s = 0; mission.metrics().visits == 0 && time_s < 400; time_s += 0.1)
            mission.advance(time_s);
        const Simulation& now = mission.simulation();
        QCOMPARE(mission.metrics().visits, 1);
        QVERIFY(isBelievedWithin(now) && now.track(0).inView);
        QVERIFY(!isBelievedWithin(instantAt(mission, now.time_s() - 0.2).simulation));
    }

    /** With a radius larger than the view, an unseen iceberg is not reached and may be planned. */
    void reachedOnceItIsSeen()
    {
        Scenario scenario = emptySea(400);
        scenario.observer.model = ObserverModel::Kalman;
        scenario.reachRadius_m = 900;
        addIceberg(scenario, 800, 0);
        addIceberg(scenario, 5000, 0);
        Mission mission(scenario);
        mission.advance(0.1);
        QVERIFY(mission.simulation().available(0, 0));
        mission.advance(400);
        const auto first =
            std::ranges::find(mission.events(), EventKind::Reached, &MissionEvent::kind);
        QVERIFY(first != mission.events().end());
        QCOMPARE(first->iceberg, IcebergIndex(0));
        QVERIFY(std::abs(first->time_s - 500 / 22.0) < 1.2); // in view, and the next look
    }

    void measurementsComeAtTheirInterval()
    {
        Scenario scenario = emptySea(60);
        scenario.observer = {.model = ObserverModel::Kalman, .interval_s = 5};
        addIceberg(scenario, 100, 0, 50).q_m2ps = 1;
        Simulation simulation(scenario);
        QVERIFY(simulation.track(0).inView);
        simulation.setTarget(0, std::nullopt);
        double last_m2 = simulation.track(0).sigma_m2;
        for (int step = 1; step <= 120; ++step) {
            simulation.advanceStep();
            const double now_m2 = simulation.track(0).sigma_m2;
            QCOMPARE(now_m2 < last_m2, step % 50 == 0);
            last_m2 = now_m2;
        }
    }

    void lostSearchedForAndFound()
    {
        const Scenario scenario = ghost(600); // beyond the view of 300 m, within the pattern
        const Mission mission = flownToEnd(scenario);
        QCOMPARE(count(mission, EventKind::Lost), 1);
        QCOMPARE(count(mission, EventKind::Found), 1);
        QCOMPARE(count(mission, EventKind::GivenUp), 0);
        const Simulation& end = mission.simulation();
        QCOMPARE(end.track(0).status, TrackStatus::Tracked);
        QVERIFY((end.observer().estimate_m(0) - end.truth_m(0)).norm() < 100);
        const auto lost = std::find_if(mission.events().begin(), mission.events().end(),
                                       [](const auto& e) { return e.kind == EventKind::Lost; });
        // It is not lost before its estimate was in the middle of the view, 150 m.
        QVERIFY(lost->time_s >= 2850 / 22.0 - 1 && lost->time_s < 3000 / 22.0 + 2);
        for (const PlanReason reason : {PlanReason::Lost, PlanReason::Found})
            QVERIFY(std::ranges::count(test::flownPlans(mission), reason, &UavPlan::reason) > 0);
    }

    /** Its distance from the estimate reveals its drift. */
    void whereItIsFoundTellsItsVelocity()
    {
        Scenario scenario = ghost(500);
        Iceberg& iceberg = scenario.icebergs[0];
        iceberg.observed_s = 3600;
        iceberg.velocitySd_mps = 0.3;
        // Drifted since the last sighting.
        iceberg.track.position_m[1].y() += 10'000 * 500.0 / 3600;
        const Track track = whenFound(scenario);
        const double error_mps = (track.velocity_mps - Point(0, 500.0 / 3600)).norm();
        QVERIFY2(error_mps < 0.01, qPrintable(QString::number(error_mps)));
        QVERIFY(track.velocity_m2ps2 < 0.01 * 0.01);
        QVERIFY(track.mixed_m2ps > 0);
    }

    /** At an impossible place the sighting reveals no drift; the given velocity is doubted. */
    void whereItCannotBeTellsNoVelocity()
    {
        const Track track = whenFound(ghost(500));
        QCOMPARE(track.velocity_mps, Point(0, 0));
        COMPARE_NEAR(std::sqrt(track.velocity_m2ps2), 0.1, 1e-12);
        QCOMPARE(track.mixed_m2ps, 0.0);
    }

    void sectorSearchFindsToo()
    {
        Scenario scenario = ghost(450);
        scenario.observer.search = SearchPattern::Sector;
        QCOMPARE(count(flownToEnd(scenario), EventKind::Found), 1);
    }

    /**
     * The other icebergs are visited, with more searches in between. The one given up is not
     * planned but counts in zeta.
     */
    void givenUpWhenItIsNowhere()
    {
        const Mission mission = flownToEnd(ghost(20000));
        QCOMPARE(count(mission, EventKind::Lost), 1);
        QVERIFY(count(mission, EventKind::GivenUp) >= 1);
        QCOMPARE(count(mission, EventKind::Found), 0);
        const Simulation& end = mission.simulation();
        QVERIFY(end.track(0).status != TrackStatus::Tracked);
        QVERIFY(end.active(0));
        QVERIFY(!end.available(0, 0));
        QVERIFY(end.track(0).sigma_m2 > 300 * 300 / 2); // it is outside what was seen
        QVERIFY(mission.metrics().visits >= 1);         // the other one
        for (const test::FlownPlan& plan : test::flownPlans(mission))
            if (plan.time_s > 300)
                QVERIFY(std::find(plan.order.begin(), plan.order.end(), IcebergIndex(0)) ==
                        plan.order.end());
    }

    void withoutSearchItIsGivenUpAtOnce()
    {
        Scenario scenario = ghost(600);
        scenario.observer.search = SearchPattern::None;
        const Mission mission = flownToEnd(scenario);
        QCOMPARE(count(mission, EventKind::GivenUp), 1);
        QCOMPARE(count(mission, EventKind::Found), 0);
    }

    /** A search ends as soon as another iceberg gains more. */
    void abandonedForMore()
    {
        Scenario scenario = ghost(20000);
        const auto gaveUp_s = [](const Mission& mission) {
            for (const MissionEvent& event : mission.events())
                if (event.kind == EventKind::GivenUp)
                    return event.time_s;
            return -1.0;
        };
        const double patient_s = gaveUp_s(flownToEnd(scenario));
        scenario.icebergs[1].position_m = {4500, 0};
        scenario.icebergs[1].sigma0_m2 = 1e7;
        const double impatient_s = gaveUp_s(flownToEnd(scenario));
        QVERIFY(impatient_s > 0);
        QVERIFY2(impatient_s + 60 < patient_s, qPrintable(QString::number(patient_s)));
    }

    /** A single missed sample does not mean a loss if the detection probability is low. */
    void missedDetectionsAreNotLosses()
    {
        Scenario scenario = emptySea(120);
        scenario.noise = true;
        scenario.observer = {.model = ObserverModel::Kalman, .detection = 0.5};
        addIceberg(scenario, 100, 0);
        const Mission mission = flownToEnd(scenario);
        QCOMPARE(count(mission, EventKind::Lost), 0);
        QVERIFY(mission.simulation().track(0).sigma_m2 < 5); // measured every other second
    }

    /** With unknown velocities searches find more lost icebergs than chance does. */
    void searchingPays()
    {
        const auto recovered = [](SearchPattern search) {
            double lost = 0;
            double found = 0;
            for (std::int64_t seed = 1; seed <= 16; ++seed) {
                Scenario scenario = measuredField(seed, 0.6);
                scenario.duration_s = 2000;
                scenario.observer.search = search;
                const Mission mission = flownToEnd(scenario);
                lost += count(mission, EventKind::Lost);
                found += count(mission, EventKind::Found);
            }
            return found / lost;
        };
        QVERIFY(recovered(SearchPattern::Square) > recovered(SearchPattern::None) + 0.2);
    }

    void replaysBitForBit()
    {
        Scenario scenario = measuredField(7, 0.6);
        scenario.duration_s = 2000;
        scenario.observer.detection = 0.8;
        const Mission mission = flownToEnd(scenario);
        QVERIFY(count(mission, EventKind::Lost) > 0);
        const RunFile run = runOf(mission);
        const RunFile read = runFromJson(runToJson(run), "run");
        QCOMPARE(read, run);
        const Mission again = replay(read);
        QVERIFY(compareRun(read, runOf(again)).empty());
        for (const double time_s : {333.3, 1200.0, 1999.9}) {
            Mission half(scenario);
            half.advance(time_s);
            QCOMPARE(instantAt(mission, time_s).simulation.state(), half.simulation().state());
        }
    }

    void everyPolicyFliesIt()
    {
        for (const PolicyKind policy :
             {PolicyKind::Visitation, PolicyKind::Path, PolicyKind::Tour, PolicyKind::Nearest,
              PolicyKind::Uncertainty, PolicyKind::Latency, PolicyKind::Coverage}) {
            Scenario scenario = measuredField(3, 0.1);
            scenario.planner.policy = policy;
            scenario.observer.detection = 0.9;
            const Mission mission = flownToEnd(scenario);
            scenario.observer = {};
            QVERIFY2(2 * mission.metrics().visits >= flownToEnd(scenario).metrics().visits,
                     qPrintable(QString::number(int(policy))));
            QVERIFY(zetaLowerBound(scenario, {.workLimit = 10'000'000}).zeta_m2s <=
                    mission.metrics().zeta_m2s);
        }
    }
};

QTEST_APPLESS_MAIN(TestObservedWorld)
#include "tst_observed_world.moc"
