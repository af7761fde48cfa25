#include "core/coverage/coverage_policy.h"
#include "core/coverage/coverage_search.h"
#include "core/coverage/coverage_settings.h"
#include "core/coverage/plan_conversion.h"
#include "core/mission/mission.h"
#include "core/mission/plan_requests.h"
#include "core/presets/presets.h"
#include "tests/support/flight/flown_plans.h"
#include "tests/support/flight/scenario_builder.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

using namespace berg;
using test::addIceberg;
using test::emptySea;

namespace {

Scenario measured(Scenario scenario, double velocitySd_mps, double sd_m = 5)
{
    scenario.planner.policy = PolicyKind::Coverage;
    scenario.observer = {.model = ObserverModel::Kalman, .positionSd_m = sd_m};
    for (Iceberg& iceberg : scenario.icebergs)
        iceberg.velocitySd_mps = velocitySd_mps;
    return scenario;
}

CoverageModel modelOf(const Scenario& scenario, double length_s = 1000)
{
    return CoverageModel(*planRequest(Simulation(scenario)).uavs[0].prediction,
                         {.length_s = length_s});
}

/** Makes a scenario with one iceberg ahead that comes into view during the flight. */
Scenario oneAhead()
{
    Scenario scenario = emptySea(400);
    scenario.noise = false;
    addIceberg(scenario, 1000, 0, 9).q_m2ps = 0.02;
    addIceberg(scenario, 5000, 3000);
    return measured(scenario, 0);
}

} // namespace

/**
 * Tests coverage with measurements, with which a sample leaves some sigma and keeping an iceberg in
 * view may pay.
 */
class TestCoverageSamples : public QObject
{
    Q_OBJECT

private slots:
    /** The flight has the zeta that the first plan predicts. */
    void predictionIsFlown_data()
    {
        QTest::addColumn<double>("velocitySd_mps");
        QTest::addColumn<double>("sd_m");
        QTest::newRow("known") << 0.0 << 5.0;
        QTest::newRow("unknown") << 0.1 << 5.0;
        QTest::newRow("coarse") << 0.1 << 20.0;
    }
    void predictionIsFlown()
    {
        QFETCH(double, velocitySd_mps);
        QFETCH(double, sd_m);
        for (int seed = 1; seed <= 2; ++seed) {
            Mission mission(measured(randomScenario(seed), velocitySd_mps, sd_m),
                            {.record = false});
            mission.advance(1000);
            const double ratio =
                mission.metrics().zeta_m2s / *mission.plans().front()->predictedZeta_m2s;
            qInfo("seed %d: flown / predicted %.3f", seed, ratio);
            QVERIFY(ratio > 0.93 && ratio < 1.18);
        }
    }

    /**
     * A sighting at an unexpected position ends the line, and with it the sightings it would have
     * led to; another order makes up for them.
     */
    void setbacksAreMadeUpFor_data()
    {
        QTest::addColumn<int>("seed");
        QTest::newRow("first") << 40003;
        QTest::newRow("second") << 40005;
    }
    void setbacksAreMadeUpFor()
    {
        QFETCH(int, seed);
        Mission mission(measured(randomScenario(seed), 0.3), {.record = false});
        mission.advance(200);
        double before_m2s = std::numeric_limits<double>::infinity();
        for (const test::FlownPlan& plan : test::flownPlans(mission)) {
            const double total_m2s = plan.plan->zeta_m2s + *plan.plan->predictedZeta_m2s;
            QVERIFY2(total_m2s < 1.2 * before_m2s, qPrintable(QString::number(plan.time_s)));
            before_m2s = total_m2s;
        }
    }

    /** Sigma is reduced by exactly the information of the path through the view. */
    void aLookLeavesSigma()
    {
        const CoverageModel model = modelOf(oneAhead());
        CoverageState state = model.start();
        QVERIFY(model.paysForSamples());
        QVERIFY(model.fly(state, {.iceberg = 0}));
        const double before_m2 = model.sigma_m2(state, 0);
        QVERIFY(before_m2 > 9);
        QVERIFY(model.fly(state, holdOf(10)));
        // Ten samples of 25 m2 each leave 1 / (1 / 9.6 + 10 / 25).
        QVERIFY(std::abs(model.sigma_m2(state, 0) - 1 / (1 / before_m2 + 0.4)) < 0.15);
        QVERIFY(std::abs((state.uav.position_m - Point(state.time_s * 22, 0)).norm()) < 1e-6);
    }

    /** A stay has the effect of a hold straight on. */
    void stayIsAHold()
    {
        const CoverageModel model = modelOf(oneAhead());
        CoverageState stayed = model.start();
        QVERIFY(model.fly(stayed, {.iceberg = 0, .offset_m = 50, .stay_s = 12}));
        CoverageState held = model.start();
        QVERIFY(model.fly(held, {.iceberg = 0, .offset_m = 50}));
        QVERIFY(model.fly(held, holdOf(12)));
        QCOMPARE(stayed.time_s, held.time_s);
        QCOMPARE(model.total_m2s(stayed), model.total_m2s(held));
        // Half a circle to the left and half a one to the right come out beside the line.
        const double half_s = M_PI / maxTurnRate_radps(UavSpec{});
        for (const int side : {1, -1}) {
            CoverageState turned = model.start();
            QVERIFY(model.fly(turned, holdOf(half_s, side)));
            QVERIFY(std::abs(turned.time_s - half_s) < 1e-9);
            const Point end_m(0, side * 2 * turnRadius_m(UavSpec{}));
            QVERIFY((turned.uav.position_m - end_m).norm() < 1e-6);
        }
    }

    /** A hold is flown to its end, and then the simulation requests a plan. */
    void holdsAreFlown_data()
    {
        QTest::addColumn<int>("side");
        QTest::addColumn<double>("wind_mps");
        QTest::newRow("straight") << 0 << 0.0;
        QTest::newRow("left") << 1 << 0.0;
        QTest::newRow("right") << -1 << 0.0;
        QTest::newRow("straight in wind") << 0 << 8.0;
        QTest::newRow("left in wind") << 1 << 8.0;
    }
    void holdsAreFlown()
    {
        QFETCH(int, side);
        QFETCH(double, wind_mps);
        Scenario scenario = oneAhead();
        scenario.wind_mps = {0, wind_mps};
        Simulation simulation(scenario);
        const PlanRequest request = planRequest(simulation);
        const CoverageModel model(*request.uavs[0].prediction, {.length_s = 400});
        const CoveragePlan plan{holdOf(7.3, side), {.iceberg = 1}};
        const DescribedPlan described = describe(model, request.uavs[0], request.ids, plan);
        QCOMPARE(described.legs.size(), std::size_t{2});
        QVERIFY(described.legs[0].end_s && !described.legs[1].end_s);
        QVERIFY(std::abs(*described.legs[0].end_s - 7.3) < 1e-9);
        QCOMPARE(described.legs[0].iceberg,
                 IcebergIndex(1)); // The iceberg is that of the leg after the hold.
        simulation.setTarget(0, IcebergIndex(0), described.legs[0]);
        while (simulation.planReason() == PlanReason::None)
            simulation.advanceStep();
        QCOMPARE(simulation.planReason(), PlanReason::HoldFlown);
        QVERIFY(std::abs(simulation.time_s() - 7.3) < 1e-9);
        CoverageState state = model.start();
        QVERIFY(model.fly(state, plan[0]));
        const Point end_m = state.uav.position_m + scenario.wind_mps * state.time_s;
        QVERIFY((simulation.uav(0).pose.position_m - end_m).norm() < 0.5);
    }

    /** Lines to an uncertain iceberg use a narrower view. */
    void doubtNarrowsTheView()
    {
        Scenario scenario = oneAhead();
        scenario.icebergs[0].position_m = {0, 260};
        const auto inView = [&](double sigma_m2) {
            PredictionInput input = *planRequest(Simulation(scenario)).uavs[0].prediction;
            input.tracks[0].inView = false;
            input.tracks[0].anchor_m = {0, 260};
            input.tracks[0].sigma_m2 = sigma_m2;
            input.uav.position_m = {-600, 0};
            const CoverageModel model(input, {.length_s = 100});
            CoverageState state = model.start();
            (void)model.fly(state, holdOf(600 / 22.0));
            return model.inView(state, 0);
        };
        QVERIFY(inView(25));
        QVERIFY(!inView(60 * 60));
    }

    /** No plan flies to and fro between icebergs that are not found. */
    void lostIcebergsAreWorthLess()
    {
        PredictionInput input = *planRequest(Simulation(oneAhead())).uavs[0].prediction;
        const auto total_m2s = [&](double chance) {
            input.tracks[0].status = TrackStatus::GivenUp;
            input.chances = {chance, 1};
            const CoverageModel model(input, {.length_s = 300});
            CoverageState state = model.start();
            (void)model.fly(state, {.iceberg = 0});
            return model.total_m2s(state);
        };
        QVERIFY(total_m2s(0.4) < total_m2s(0.1));
        QVERIFY(total_m2s(0.1) < total_m2s(0));
    }

    /** Each place of a lost iceberg counts with its own probability, once. */
    void placesOfALostOne()
    {
        const Scenario scenario = oneAhead();
        PredictionInput input = *planRequest(Simulation(scenario)).uavs[0].prediction;
        input.tracks[0].status = TrackStatus::Lost;
        input.places = {
            {{.offset_m = {0, 600}, .chance = 0.5}, {.offset_m = {0, -600}, .chance = 0.25}}, {}};
        const CoverageModel model(input, {.length_s = 300});
        QCOMPARE(model.placeCount(), 3); // There are two icebergs and one more place.
        QCOMPARE(model.icebergAt(2), ModelPlace(0));
        CoverageState state = model.start();
        QCOMPARE(model.chanceAt(state, 0), 0.5);
        const double unseen_m2 = model.sigma_m2(state, 0);
        CoverageState second = state;
        QVERIFY(model.fly(state, {.iceberg = 0}));
        const double first_m2 = model.sigma_m2(state, 0);
        QVERIFY(first_m2 < 0.75 * unseen_m2 && first_m2 > 0.45 * unseen_m2);
        QVERIFY(!model.fly(state, {.iceberg = 0})); // A second view of the place changes nothing.
        // The probability is relative to the places that remain.
        QVERIFY(std::abs(model.chanceAt(state, 2) - 0.5) < 1e-12);
        QVERIFY(model.fly(state, {.iceberg = 2}));
        // Sigma has decreased although it grows during the flight.
        QVERIFY(model.sigma_m2(state, 0) < first_m2);
        QVERIFY(model.fly(second, {.iceberg = 2}));
        QVERIFY(model.sigma_m2(second, 0) > first_m2);
    }

    /**
     * The answer reports each place where the plan searches for a lost iceberg, with time and
     * probability.
     */
    void searchesAreTold()
    {
        const Scenario scenario = oneAhead();
        PlanRequest request = planRequest(Simulation(scenario));
        PredictionInput input = *request.uavs[0].prediction;
        input.tracks[0].status = TrackStatus::Lost;
        input.places = {
            {{.offset_m = {0, 600}, .chance = 0.5}, {.offset_m = {0, -600}, .chance = 0.25}}, {}};
        request.uavs[0].prediction = std::make_shared<const PredictionInput>(input);
        request.uavs[0].available[0] = false;
        const std::vector<CoverageModel> models(2, CoverageModel(input, {.length_s = 300}));
        const CoveragePlan plan{{.iceberg = 2}, {.iceberg = 0}, {.iceberg = 2}, {.iceberg = 1}};
        const AimedOutlook alone = describe(models[0], request.uavs[0], request.ids, plan).outlook;
        QCOMPARE(alone.searches.size(), std::size_t{2});
        QCOMPARE(alone.searches[0].chance, 0.25);
        QCOMPARE(alone.searches[1].chance, 0.5);
        for (const PlannedSearch& search : alone.searches) {
            QCOMPARE(search.iceberg, IcebergIndex(0));
            const double offset_m = search.chance > 0.3 ? 600 : -600;
            const Point there_m = input.tracks[0].estimate_m(search.time_s);
            QVERIFY((search.place_m - there_m - Point(0, offset_m)).norm() < 1e-9);
        }
        CoverageState state = models[0].start();
        QVERIFY(models[0].fly(state, plan[0]));
        QVERIFY(std::abs(alone.searches[0].time_s - state.time_s) < 1e-6);
        QVERIFY(alone.searches[1].time_s > alone.searches[0].time_s + 30);
        // The search belongs to the first UAV at the place.
        request.uavs.push_back(request.uavs[0]);
        const std::vector<UavPlan> answers =
            describeFleet(models, request, std::vector<CoveragePlan>{plan, {{.iceberg = 0}}});
        QCOMPARE(answers[0].outlook->searches.size(), std::size_t{1});
        QCOMPARE(answers[0].outlook->searches[0].chance, 0.25);
        QCOMPARE(answers[1].outlook->searches.size(), std::size_t{1});
        QCOMPARE(answers[1].outlook->searches[0].chance, 0.5);
    }

    /** A place that another UAV has in view counts as searched, once. */
    void othersSearchToo()
    {
        PredictionInput input = *planRequest(Simulation(oneAhead())).uavs[0].prediction;
        input.tracks[0].status = TrackStatus::Lost;
        input.places = {
            {{.offset_m = {0, 600}, .chance = 0.5}, {.offset_m = {0, -600}, .chance = 0.25}}, {}};
        CoverageModel model(input, {.length_s = 300});
        const double alone_m2s = model.total_m2s(model.start());
        model.setOthers({{.iceberg = 2, .enter_s = 20, .leave_s = 30}});
        const double second_m2s = model.total_m2s(model.start());
        model.setOthers({{.iceberg = 0, .enter_s = 20, .leave_s = 30}});
        const double first_m2s = model.total_m2s(model.start());
        QVERIFY(first_m2s < second_m2s && second_m2s < alone_m2s);
        model.setOthers({{.iceberg = 2, .enter_s = 20, .leave_s = 30},
                         {.iceberg = 0, .enter_s = 10, .leave_s = 15},
                         {.iceberg = 0, .enter_s = 100, .leave_s = 105}});
        QVERIFY(model.total_m2s(model.start()) < first_m2s);
        // The account has the same result step by step.
        CoverageState state = model.start();
        QVERIFY(model.fly(state, holdOf(15, 1)));
        QVERIFY(model.inView(state, 0)); // nothing is gained there
        QVERIFY(std::abs(model.chanceAt(state, 2) - 0.5) < 1e-12);
        QVERIFY(model.fly(state, holdOf(10, 1)));
        QVERIFY(!model.fly(state, {.iceberg = 2}));
        QVERIFY(std::abs(model.total_m2s(state) / model.total_m2s(model.start()) - 1) < 1e-9);
    }

    /** The rest of a plan goes to the same places, even if their numbers have changed. */
    void placesAreKept()
    {
        PredictionInput input = *planRequest(Simulation(oneAhead())).uavs[0].prediction;
        input.tracks[0].status = TrackStatus::Lost;
        const SearchPlace north{.offset_m = {0, 600}, .chance = 0.5};
        const SearchPlace south{.offset_m = {0, -600}, .chance = 0.25};
        input.places = {{north, south}, {}};
        const CoverageModel before(input, {.length_s = 300});
        const IcebergList ids{7, 9};
        const KeptPlan kept =
            keptPlan({{.iceberg = 2}, {.iceberg = 1}, {.iceberg = 0}}, before, ids);
        const auto placesNow = [&](std::vector<SearchPlace> places) {
            input.places = {std::move(places), {}};
            std::vector<int> now;
            for (const CoverageLeg& leg :
                 restOf(kept, CoverageModel(input, {.length_s = 300}), ids))
                now.push_back(leg.iceberg.number());
            return now;
        };
        QCOMPARE(placesNow({north, south}), (std::vector{2, 1, 0}));
        QCOMPARE(placesNow({south, north}), (std::vector{0, 1, 2}));
        QCOMPARE(placesNow({}), (std::vector{0, 1, 0}));
    }

    /**
     * Legs of the plan search for lost icebergs, and no search pattern of the autopilot interrupts
     * them.
     */
    void plansSearch_data()
    {
        QTest::addColumn<int>("uavs");
        QTest::newRow("one UAV") << 1;
        QTest::newRow("two UAVs") << 2;
    }
    void plansSearch()
    {
        QFETCH(int, uavs);
        int lost = 0;
        int found = 0;
        for (int seed = 1; seed <= 4; ++seed) {
            Scenario scenario = measured(randomScenario(seed), 0.8);
            scenario.uavs.resize(static_cast<std::size_t>(uavs), scenario.uavs[0]);
            scenario.uavs.back().id = "last";
            scenario.uavs.back().position_m.y() += 2000.0 * (uavs - 1);
            Mission mission(scenario, {.workLimit = 20'000, .record = false});
            for (int until_s = 5; until_s <= 1000; until_s += 5) {
                mission.advance(until_s);
                for (const Autopilot& uav : mission.simulation().fleet().autopilots())
                    QVERIFY(uav.mode() != FlightMode::Search);
            }
            for (const MissionEvent& event : mission.events()) {
                lost += event.kind == EventKind::Lost;
                found += event.kind == EventKind::Found;
            }
        }
        qInfo("lost %d, found %d", lost, found);
        QVERIFY(lost > (uavs == 1 ? 10 : 5));
        QVERIFY(2 * found > lost);
    }

    /**
     * While a slow plan is being made, the autopilot does not end the searches of the present plan.
     */
    void searchesWaitForPlans()
    {
        int lost = 0;
        for (int seed = 1; seed <= 3; ++seed) {
            Scenario scenario = measured(randomScenario(seed), 0.8);
            scenario.planningTime_s = 2;
            Mission mission(scenario, {.workLimit = 20'000, .record = false});
            mission.advance(600);
            for (const MissionEvent& event : mission.events()) {
                lost += event.kind == EventKind::Lost;
                QVERIFY(event.kind != EventKind::GivenUp);
            }
        }
        QVERIFY(lost > 5);
    }

    /** Plans contain holds, and are never worse than those they start from. */
    void searchUsesHolds()
    {
        int holds = 0;
        for (int seed = 1; seed <= 3; ++seed) {
            const CoverageModel model = modelOf(measured(randomScenario(seed), 0.1));
            CoverageSearch search(model, Random(static_cast<std::uint64_t>(seed)));
            const CoverageResult start = search.completed({});
            const CoverageResult found =
                search.improved(start, search.work() + 500'000, 0.001, SolveWatch({}));
            QVERIFY(found.total_m2s < 0.95 * start.total_m2s);
            CoverageState state = model.start();
            for (const CoverageLeg& leg : found.plan)
                QVERIFY(model.fly(state, leg));
            QVERIFY(std::abs(model.total_m2s(state) / found.total_m2s - 1) < 1e-12);
            holds += static_cast<int>(std::ranges::count_if(
                found.plan, [](const CoverageLeg& leg) { return leg.isHold() || leg.stay_s > 0; }));
        }
        QVERIFY(holds > 0);
    }

    /** The sightings of another UAV are filtered, too, and leave some sigma. */
    void othersLookToo()
    {
        const Scenario scenario = oneAhead();
        CoverageModel model = modelOf(scenario, 300);
        const CoverageState alone = model.start();
        const double alone_m2s = model.total_m2s(alone);
        model.setOthers({{.iceberg = 0, .enter_s = 100, .leave_s = 110},
                         {.iceberg = 0, .enter_s = 200, .leave_s = 205}});
        CoverageState waiting = model.start();
        const double total_m2s = model.total_m2s(waiting);
        QVERIFY(total_m2s < alone_m2s);
        // The account has the same result step by step.
        QVERIFY(model.fly(waiting, holdOf(30, 1)));
        QVERIFY(model.fly(waiting, holdOf(75, 1)));
        QVERIFY(model.sigma_m2(waiting, 0) > 1.5);
        QVERIFY(model.sigma_m2(waiting, 0) < 3);
        QVERIFY(model.fly(waiting, holdOf(150, 1)));
        QVERIFY(std::abs(model.total_m2s(waiting) / total_m2s - 1) < 1e-9);
    }

    /** The horizon is longer if paths are long, so that it holds two visits to each iceberg. */
    void farIcebergsAreJudgedByTwoRounds()
    {
        Scenario square = emptySea(8 * 3600);
        for (const auto& [x_m, y_m] : {std::pair(0, 0), {9000, 0}, {9000, 9000}, {0, 9000}})
            addIceberg(square, x_m, y_m);
        const double speed_mps = square.uavs[0].spec.airspeed_mps;
        const auto length_s = [](const Scenario& scenario, std::size_t uavs = 1) {
            const PredictionInput input = *planRequest(Simulation(scenario)).uavs[0].prediction;
            return horizonOf(std::vector<PredictionInput>(uavs, input)).length_s;
        };
        // The horizon is the usual one because sigma is 0 in view.
        QCOMPARE(length_s(square), 800.0);
        square = measured(square, 0.1);
        // The tree has three sides, and each tour is a quarter longer.
        const double two_s = 2 * 1.25 * 27000 / speed_mps;
        QVERIFY(two_s > 1600);
        QCOMPARE(length_s(square), two_s);
        QCOMPARE(length_s(square, 2), two_s / 2);
        square.duration_s = 3600; // The run is not much longer, so it is judged as a whole.
        QCOMPARE(length_s(square), 3600.0);
        QCOMPARE(length_s(measured(randomScenario(1, {.icebergs = 4}), 0.1)), 1000.0);
        Scenario row = measured(emptySea(24 * 3600), 0);
        for (int i = 0; i < 50; ++i)
            addIceberg(row, 3000.0 * i, 0);
        QCOMPARE(length_s(row), 40 * 1.25 * 3000 * 49 / 50 / speed_mps);
    }

    /** A flight is reproduced exactly, even if the planner has other requests in between. */
    void missionsReplay()
    {
        const Scenario scenario = measured(randomScenario(4), 0.1);
        const auto zeta_m2s = [&] {
            Mission mission(scenario, {.workLimit = 20'000, .record = false});
            mission.advance(400);
            return mission.metrics().zeta_m2s;
        };
        QCOMPARE(zeta_m2s(), zeta_m2s());
    }
};

QTEST_APPLESS_MAIN(TestCoverageSamples)
#include "tst_coverage_samples.moc"
