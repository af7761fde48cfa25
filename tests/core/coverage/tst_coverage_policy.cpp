#include "core/coverage/coverage_model.h"
#include "core/coverage/coverage_policy.h"
#include "core/mission/mission.h"
#include "core/mission/plan_requests.h"
#include "core/plan/policy/planner.h"
#include "core/presets/presets.h"
#include "tests/support/flight/fleet_flight.h"
#include "tests/support/flight/scenario_builder.h"
#include "tests/support/plan/test_solvers.h"

#include <QTest>

#include <algorithm>
#include <set>

using namespace berg;
using test::addIceberg;
using test::emptySea;

namespace {

constexpr std::int64_t kWork = 100'000;

std::unique_ptr<Policy> coverage()
{
    static const std::unique_ptr<TvpSolver> solver = makeSolver(Backend::Auto);
    return makeFlownPolicy({.policy = PolicyKind::Coverage}, *solver);
}

/** Returns the request of a planner with this rest of its last plan. */
PlanRequest withRest(PlanRequest request, const IcebergList& rest)
{
    request.uavs[0].lastRest = rest;
    return request;
}

PlanRequest requestOf(const Scenario& scenario)
{
    return planRequest(Simulation(scenario));
}

/**
 * Verifies that every available id is in the order once, that the first leg sees the first one, and
 * that the numbers agree.
 */
void verifyAnswer(const Plan& answer, const PlanRequest& request)
{
    std::multiset<IcebergIndex> available;
    for (std::size_t k = 0; k < request.ids.size(); ++k)
        if (request.uavs[0].available[k])
            available.insert(request.ids[k]);
    QVERIFY(std::multiset<IcebergIndex>(answer.uavs[0].order.begin(), answer.uavs[0].order.end()) ==
            available);
    QVERIFY(isFleetPlan(answer.problem, answer.outcome.plan));
    QVERIFY(answer.solvedIds == answer.uavs[0].order);
    QVERIFY(answer.outcome.status == SolveStatus::Feasible);
    QVERIFY(!answer.uavs[0].legs.empty());
    QVERIFY(answer.predictedZeta_m2s.has_value());
    double before_s = request.uavs[0].prediction->time_s;
    for (const AimedLeg& leg : answer.uavs[0].legs) {
        QVERIFY(leg.sighting_s >= before_s);
        QVERIFY(leg.sighting_s <= request.uavs[0].prediction->until_s + 1e-9);
        before_s = leg.sighting_s;
    }
}

} // namespace

class TestCoveragePolicy : public QObject
{
    Q_OBJECT

private slots:
    /** The policy once took icebergs in view for reached, 300 to 490 m away. */
    void reachRadiusIsObeyed()
    {
        int visits = 0;
        for (std::uint64_t seed = 1; seed <= 48; ++seed) {
            Random random(seed, 330);
            Scenario scenario = test::withUavs(
                randomScenario(static_cast<std::int64_t>(seed), {.icebergs = 8}), 1 + seed % 2);
            scenario.planner.policy = PolicyKind::Coverage;
            scenario.reachRadius_m = random.uniform(50, 280);
            scenario.fovShape = static_cast<FovShape>(random.below(3));
            const bool isMeasured = random.below(2) == 0;
            if (isMeasured)
                scenario.observer.model = ObserverModel::Kalman;
            if (random.below(3) == 0)
                scenario.wind_mps = {random.uniform(-6, 6), random.uniform(-6, 6)};
            Mission mission(scenario, {.workLimit = 20'000});
            std::size_t reported = 0;
            while (!mission.simulation().finished()) {
                mission.advance(mission.simulation().time_s() + scenario.dt_s);
                const Observer& observer = mission.simulation().observer();
                for (; reported < mission.events().size(); ++reported) {
                    const MissionEvent& event = mission.events()[reported];
                    if (event.kind != EventKind::Reached)
                        continue;
                    const Point place_m = isMeasured ? observer.estimate_m(*event.iceberg)
                                                     : mission.simulation().truth_m(*event.iceberg);
                    const Point uav_m = mission.simulation().uav(*event.uav).pose.position_m;
                    const double away_m = (place_m - uav_m).norm();
                    QVERIFY2(away_m <= *scenario.reachRadius_m + 1e-6,
                             qPrintable(QStringLiteral("%1: %2 m").arg(seed).arg(away_m)));
                    ++visits;
                }
            }
        }
        // Each UAV has at least one visit in two minutes, so it does not circle beside an iceberg
        // that it cannot reach.
        QVERIFY2(visits > 48 * 1.5 * 1000 / 120, qPrintable(QString::number(visits)));
    }

    void plansAllThatIsAvailable()
    {
        for (int seed = 1; seed <= 10; ++seed) {
            Scenario scenario = randomScenario(seed);
            scenario.icebergs[0].position_m = scenario.uavs[0].position_m; // in view
            const PlanRequest request = requestOf(scenario);
            QVERIFY(!request.uavs[0].available[0]);
            verifyAnswer(coverage()->plan(request, {.workLimit = kWork}), request);
        }
    }

    /** The policy re-plans after each of some flown seconds. */
    void rePlans()
    {
        Simulation simulation(randomScenario(3));
        const std::unique_ptr<Policy> policy = coverage();
        IcebergList last;
        for (int k = 0; k < 15; ++k) {
            const PlanRequest request = planRequest(simulation);
            const Plan answer = policy->plan(withRest(request, last), {.workLimit = kWork});
            verifyAnswer(answer, request);
            QCOMPARE(answer.outcome.hintUsed, k > 0);
            simulation.setTarget(0, answer.uavs[0].order.front(), answer.uavs[0].legs.front());
            for (int i = 0; i < 200 && simulation.planReason() == PlanReason::None; ++i)
                simulation.advanceStep();
            last = answer.uavs[0].order;
        }
    }

    /** A plan from a warm start costs no more than the rest of the plan before. */
    void warmStartIsKept()
    {
        Scenario scenario = randomScenario(5);
        scenario.noise = false;
        Simulation simulation(scenario);
        const std::unique_ptr<Policy> policy = coverage();
        const Plan first = policy->plan(planRequest(simulation), {});
        simulation.setTarget(0, first.uavs[0].order.front(), first.uavs[0].legs.front());
        while (simulation.planReason() == PlanReason::None)
            simulation.advanceStep();
        const PlanRequest request = planRequest(simulation);
        const double left_m2s = *first.predictedZeta_m2s - simulation.zeta_m2s();
        const Plan warm = policy->plan(withRest(request, first.uavs[0].order), {.workLimit = 1});
        QVERIFY(*warm.predictedZeta_m2s < 1.005 * left_m2s);
        const Plan cold = policy->plan(request, {.workLimit = 1});
        QVERIFY(!cold.outcome.hintUsed);
        QVERIFY(*cold.predictedZeta_m2s > 1.03 * left_m2s); // The plan has greedy legs only.
    }

    void nothingAvailable()
    {
        Scenario scenario = emptySea();
        addIceberg(scenario, 50, 0);
        const Plan answer = coverage()->plan(requestOf(scenario), {});
        QVERIFY(answer.uavs[0].order.empty());
        QVERIFY(answer.uavs[0].legs.empty());
        QVERIFY(!answer.predictedZeta_m2s);
        QVERIFY(coverage()->plan(requestOf(emptySea()), {}).uavs[0].order.empty());
    }

    void cancelLeavesNoTrace()
    {
        std::stop_source source;
        source.request_stop();
        const PlanRequest request = requestOf(randomScenario(6));
        const std::unique_ptr<Policy> policy = coverage();
        const Plan cut = policy->plan(request, {.stop = source.get_token()});
        QVERIFY(cut.outcome.reason == StopReason::Cancelled);
        QVERIFY(cut.uavs.empty());
        const SolveOptions options{.workLimit = kWork};
        QVERIFY(policy->plan(request, options).uavs[0].legs ==
                coverage()->plan(request, options).uavs[0].legs);
    }

    void timeLimitStillGivesAPlan()
    {
        const PlanRequest request = requestOf(randomScenario(6));
        const Plan answer = coverage()->plan(request, {.timeLimit_s = 0});
        QVERIFY(answer.outcome.reason == StopReason::TimeLimit);
        verifyAnswer(answer, request);
    }

    /** New icebergs are in the next plan, and icebergs that have disappeared are not. */
    void inputsMayChange()
    {
        const std::unique_ptr<Policy> policy = coverage();
        const SolveOptions options{.workLimit = kWork};
        PlanRequest request = requestOf(randomScenario(7, {.icebergs = 8}));
        const IcebergList order = policy->plan(request, options).uavs[0].order;
        const PlanRequest more = requestOf(randomScenario(7, {.icebergs = 10}));
        verifyAnswer(policy->plan(withRest(more, order), options), more);
        const PlanRequest fewer = requestOf(randomScenario(7, {.icebergs = 3}));
        verifyAnswer(policy->plan(withRest(fewer, order), options), fewer);
    }

    void longRunsAreJudgedByAPart()
    {
        Scenario scenario = randomScenario(8);
        scenario.duration_s = 4000;
        const PlanRequest request = requestOf(scenario);
        const Plan answer = coverage()->plan(request, {.workLimit = kWork});
        verifyAnswer(answer, request);
        QVERIFY(answer.uavs[0].legs.back().sighting_s < 1500);
    }

    /** Order, times and zeta of the prediction belong together. */
    void outlookOfThePlan()
    {
        Scenario scenario = randomScenario(8);
        const PlanRequest request = requestOf(scenario);
        const Plan answer = coverage()->plan(request, {.workLimit = kWork});
        const AimedOutlook outlook = answer.uavs[0].outlook.value();
        QCOMPARE(outlook.until_s, scenario.duration_s);
        QVERIFY(std::abs(outlook.zeta_m2s - *answer.predictedZeta_m2s) < 1e-6 * outlook.zeta_m2s);
        QVERIFY(outlook.sightings_s.size() <= answer.uavs[0].order.size());
        QVERIFY(outlook.sightings_s.size() > 6);
        QVERIFY(std::is_sorted(outlook.sightings_s.begin(), outlook.sightings_s.end()));
        QCOMPARE(outlook.sightings_s.front(), answer.uavs[0].legs.front().sighting_s);

        Simulation simulation(scenario); // The first iceberg of the order is seen then.
        simulation.setTarget(0, answer.uavs[0].order.front(), answer.uavs[0].legs.front());
        while (simulation.planReason() == PlanReason::None)
            simulation.advanceStep();
        QVERIFY(std::abs(simulation.time_s() - outlook.sightings_s.front()) < 1.5);
        QVERIFY(simulation.track(answer.uavs[0].order.front()).inView);
    }

    void outlookOfALongRunEndsEarlier()
    {
        Scenario scenario = randomScenario(8);
        scenario.duration_s = 4000;
        const Plan answer = coverage()->plan(requestOf(scenario), {.workLimit = kWork});
        QCOMPARE(answer.uavs[0].outlook->until_s, 800.0);
        QVERIFY(answer.uavs[0].outlook->zeta_m2s <
                0.99 * *answer.predictedZeta_m2s); // The rest beyond the horizon counts, too.
        QVERIFY(answer.uavs[0].outlook->sightings_s.back() <= 800);
    }

    /**
     * A progress callback receives better and better first plans, and does not change the result.
     */
    void firstPlanIsSeenImproving()
    {
        const PlanRequest request = requestOf(randomScenario(9));
        const SolveOptions quiet{.workLimit = 3'000'000};
        std::vector<SolveProgress> reported;
        SolveOptions watched = quiet;
        watched.onProgress = [&](const SolveProgress& progress) { reported.push_back(progress); };
        const std::unique_ptr<Policy> policy = coverage();
        const Plan answer = policy->plan(request, watched);
        QVERIFY(answer.uavs[0].legs == coverage()->plan(request, quiet).uavs[0].legs);
        QVERIFY(!reported.empty());
        for (std::size_t i = 0; i < reported.size(); ++i) {
            QVERIFY(std::is_permutation(reported[i].orders[0].begin(), reported[i].orders[0].end(),
                                        answer.uavs[0].order.begin(), answer.uavs[0].order.end()));
            QVERIFY(!reported[i].legs.empty());
            QVERIFY(reported[i].objective >= *answer.predictedZeta_m2s);
            QVERIFY(i == 0 || reported[i].objective < reported[i - 1].objective);
        }
        reported.clear();
        // The later plan takes a moment only.
        (void)policy->plan(withRest(request, answer.uavs[0].order), watched);
        QVERIFY(reported.empty());
    }

    void otherPoliciesAreMadeToo()
    {
        const std::unique_ptr<TvpSolver> solver = makeSolver(Backend::Auto);
        const PlanRequest request = requestOf(randomScenario(9));
        const PlannerSettings settings{.policy = PolicyKind::Nearest};
        const Plan answer = makeFlownPolicy(settings, *solver)->plan(request, {});
        QVERIFY(answer.uavs[0].order ==
                makePolicy(settings, *solver)->plan(request, {}).uavs[0].order);
        QVERIFY(answer.uavs[0].legs.empty());
    }

    void anInputIsNeeded()
    {
        PlanRequest request = requestOf(randomScenario(9));
        request.uavs[0].prediction = nullptr;
        QVERIFY_THROWS_EXCEPTION(std::logic_error, (void)coverage()->plan(request, {}));
    }
};

QTEST_APPLESS_MAIN(TestCoveragePolicy)
#include "tst_coverage_policy.moc"
