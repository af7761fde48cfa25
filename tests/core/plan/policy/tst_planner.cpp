#include "core/plan/policy/planner.h"
#include "tests/support/approx.h"
#include "tests/support/plan/fleet_requests.h"
#include "tests/support/plan/request_builder.h"
#include "tests/support/plan/test_solvers.h"

#include <memory>

using namespace berg;
using namespace berg::test;

using Ids = IcebergList;

namespace {

// The icebergs of `five()` are 10, 7, 42, 3, 5; with all of them available these are nodes 1 to 5.

SolveOutcome inOrder(const VisitOrder& order)
{
    return {.status = SolveStatus::Feasible, .plan = {order}};
}

/** Returns a function that gives the script's next answers, whatever the problem. */
auto answering(const SolveOutcome& outcome)
{
    return [outcome](const TvpProblem&) { return outcome; };
}

/**
 * Answers of a `ScriptedPolicy`, and the requests it received. Global, because `PolicyMaker` is a
 * plain function.
 */
struct PolicyScript
{
    std::function<Plan(const PlanRequest&)> answer;
    std::vector<PlanRequest> requests;
};
PolicyScript g_script;

class ScriptedPolicy final : public Policy
{
public:
    Plan plan(const PlanRequest& request, const SolveOptions&) override
    {
        g_script.requests.push_back(request);
        return g_script.answer(request);
    }
};

std::unique_ptr<Policy> makeScriptedPolicy(const PlannerSettings&, const TvpSolver&)
{
    return std::make_unique<ScriptedPolicy>();
}

/** A request of UAVs 20 and 21 for the icebergs of `five()`. */
PlanRequest twoForFive()
{
    return fleetRequestOf({{0, 0}, {4000, 0}}, kFive);
}

std::vector<Ids> ordersOf(const Plan& answer)
{
    std::vector<Ids> orders;
    for (const UavPlan& uav : answer.uavs)
        orders.push_back(uav.order);
    return orders;
}

auto answeringFleet(const std::vector<Ids>& orders)
{
    return [orders](const PlanRequest&) {
        Plan answer{.outcome = {.status = SolveStatus::Feasible}};
        for (const Ids& order : orders)
            answer.uavs.push_back({.order = order, .legs = {}, .outlook = {}});
        return answer;
    };
}

} // namespace

class TestPlanner : public QObject
{
    Q_OBJECT

private:
    SolverScript m_script;

    /** Returns a planner with the script, which has the order 3, 10, 42, 5, 7. */
    [[nodiscard]] std::unique_ptr<Planner> plannerWithOrder(const PlannerSettings& settings = {})
    {
        auto planner =
            std::make_unique<Planner>(settings, std::make_unique<ScriptedSolver>(m_script));
        m_script.answer = answering(inOrder({4, 1, 3, 5, 2}));
        const Plan answer = planner->plan(five(), {});
        require(answer.uavs[0].order == Ids{3, 10, 42, 5, 7}, "the script's order is flown");
        m_script = {};
        return planner;
    }

private slots:
    void init()
    {
        m_script = {};
        g_script = {};
    }

    void theSolversOrderIsFlown()
    {
        const std::unique_ptr<Planner> planner = plannerWithOrder();
        m_script.answer = answering(inOrder({2, 1, 4, 3})); // nodes of 10, 7, 42, 5
        const Plan answer = planner->plan(without(five(), {3}), {});
        QVERIFY((answer.uavs[0].order == Ids{7, 10, 5, 42}));
        QVERIFY(!answer.fellBack);
    }

    /**
     * In flight a solve begins with the multipliers of the last ones, by iceberg; a cancelled one
     * stores none.
     */
    void multipliersStayWithTheirIcebergs()
    {
        const std::unique_ptr<Planner> planner = plannerWithOrder();
        SolveOutcome outcome = inOrder({4, 1, 3, 5, 2});
        outcome.multipliers = {0, 1, 2, 3, 4, 5}; // of 10, 7, 42, 3, 5
        m_script.answer = answering(outcome);
        static_cast<void>(planner->plan(five(), {.inFlight = true}));
        outcome = noOrder(StopReason::Cancelled);
        outcome.multipliers = {0, 6, 6, 6, 6, 6};
        m_script.answer = answering(outcome);
        static_cast<void>(planner->plan(five(), {.inFlight = true}));
        m_script.answer = answering(inOrder({1, 2, 3, 4}));
        static_cast<void>(planner->plan(without(five(), {7}), {.inFlight = true}));
        static_cast<void>(planner->plan(without(five(), {7}), {}));
        QCOMPARE(m_script.options.at(2).multipliers, (std::vector<double>{0, 1, 3, 4, 5}));
        QVERIFY(m_script.options.at(3).multipliers.empty());
    }

    /**
     * The paper's second advantage: without a solution in time, the next iceberg of the last plan
     * is flown.
     */
    void fallsBackToTheRestOfTheLastPlan_data()
    {
        QTest::addColumn<StopReason>("reason");
        QTest::newRow("time limit") << StopReason::TimeLimit;
        QTest::newRow("work limit") << StopReason::WorkLimit;
        QTest::newRow("unable") << StopReason::Unable;
    }

    void fallsBackToTheRestOfTheLastPlan()
    {
        QFETCH(StopReason, reason);
        const std::unique_ptr<Planner> planner = plannerWithOrder();
        m_script.answer = answering(noOrder(reason));
        const Plan first = planner->plan(without(five(), {3}), {});
        QVERIFY((first.uavs[0].order == Ids{10, 42, 5, 7}));
        QVERIFY(first.fellBack);
        QCOMPARE(first.outcome.reason, reason);
        // The next fallback starts from there: 10 is reached, 42 was seen meanwhile.
        const Plan second = planner->plan(without(five(), {10, 42}), {});
        QVERIFY((second.uavs[0].order == Ids{5, 7}));
        QVERIFY(second.fellBack);
    }

    void fallsBackToTheNearestWithNoPlanInHand()
    {
        Planner planner({}, std::make_unique<ScriptedSolver>(m_script));
        m_script.answer = answering(noOrder(StopReason::TimeLimit));
        const Plan answer = planner.plan(five(), {});
        QVERIFY(answer.uavs[0].order == Ids{10});
        QVERIFY(answer.fellBack);
        // No iceberg of the last plan is left, so the nearest is next again, now 7.
        const Plan next = planner.plan(without(five(), {10}), {});
        QVERIFY(next.uavs[0].order == Ids{7});
        QVERIFY(next.fellBack);
    }

    void nearestTiesGoToTheFirst()
    {
        Planner planner({}, std::make_unique<ScriptedSolver>(m_script));
        m_script.answer = answering(noOrder(StopReason::TimeLimit));
        const PlanRequest request =
            requestOf({0, 0}, {{1, {50, 0}, 1}, {9, {0, 700}, 1}, {4, {700, 0}, 8}});
        QVERIFY(planner.plan(without(request, {1}), {}).uavs[0].order == Ids{9});
    }

    void nothingAvailableIsNoFallBack()
    {
        const std::unique_ptr<Planner> planner = plannerWithOrder();
        const Plan answer = planner->plan(without(five(), {10, 7, 42, 3, 5}), {});
        QVERIFY(answer.uavs[0].order.empty());
        QVERIFY(!answer.fellBack);
    }

    /** Icebergs that have disappeared are not flown to. */
    void fallBackForgetsWhatIsGone()
    {
        const std::unique_ptr<Planner> planner = plannerWithOrder();
        m_script.answer = answering(noOrder(StopReason::TimeLimit));
        const PlanRequest two = requestOf({0, 0}, {kFive[1], kFive[2]}); // 7 and 42
        QVERIFY((planner->plan(two, {}).uavs[0].order == Ids{42, 7}));
    }

    void cancelledLeavesTheMemoryAsItWas_data()
    {
        QTest::addColumn<bool>("withOrder");
        QTest::newRow("without order") << false;
        QTest::newRow("with the best order so far") << true;
    }

    void cancelledLeavesTheMemoryAsItWas()
    {
        QFETCH(bool, withOrder);
        const std::unique_ptr<Planner> planner = plannerWithOrder();
        SolveOutcome cancelled = withOrder ? inOrder({3, 4, 2, 1}) : noOrder(StopReason::Cancelled);
        cancelled.reason = StopReason::Cancelled;
        m_script.answer = answering(cancelled);
        const Plan answer = planner->plan(without(five(), {3}), {});
        QCOMPARE(answer.outcome.reason, StopReason::Cancelled);
        QVERIFY(!answer.fellBack);

        m_script = {};
        m_script.answer = answering(noOrder(StopReason::TimeLimit));
        QVERIFY((planner->plan(without(five(), {3}), {}).uavs[0].order == Ids{10, 42, 5, 7}));
        QVERIFY((m_script.options.at(0).hint == FleetPlan{{1, 3, 4, 2}})); // still the first plan's
    }

    /** The paper's first advantage: the rest of the last plan starts the next solve. */
    void warmStartReachesTheSolver()
    {
        const std::unique_ptr<Planner> planner = plannerWithOrder();
        (void)planner->plan(without(five(), {3}), {.gap = 0.125});
        QCOMPARE(m_script.options.size(), std::size_t{1});
        // 10, 42, 5, 7 are left; 10, 7, 42, 5 are nodes 1 to 4.
        QVERIFY((m_script.options[0].hint == FleetPlan{{1, 3, 4, 2}}));
        QCOMPARE(m_script.options[0].gap, 0.125);
        QCOMPARE(m_script.problems.at(0).icebergCount(), 4);
    }

    void firstPlanHasNoWarmStart()
    {
        Planner planner({}, std::make_unique<ScriptedSolver>(m_script));
        (void)planner.plan(five(), {});
        QVERIFY(m_script.options.at(0).hint.empty());
    }

    void newIcebergsGoToTheEndOfTheWarmStart()
    {
        const std::unique_ptr<Planner> planner = plannerWithOrder();
        std::vector<Place> seven = kFive;
        // It becomes node 1; the others move up by one.
        seven.insert(seven.begin(), {77, {4000, 4000}, 3});
        seven.push_back({88, {100, 100}, 3});
        (void)planner->plan(requestOf({0, 0}, seven), {});
        // 3, 10, 42, 5, 7 are nodes 5, 2, 4, 6, 3; then 77 and 88.
        QVERIFY((m_script.options.at(0).hint == FleetPlan{{5, 2, 4, 6, 3, 1, 7}}));
    }

    /** Without warm start the solver starts cold, but a limit still finds the last plan. */
    void warmStartCanBeTurnedOff()
    {
        const std::unique_ptr<Planner> planner = plannerWithOrder();
        m_script.answer = answering(noOrder(StopReason::WorkLimit));
        const Plan answer = planner->plan(without(five(), {3}), {}, false);
        QVERIFY(m_script.options.at(0).hint.empty());
        QVERIFY((answer.uavs[0].order == Ids{10, 42, 5, 7}));
        QVERIFY(answer.fellBack);
    }

    void settingsChangeInFlight()
    {
        const std::unique_ptr<Planner> planner = plannerWithOrder({.tau = 1});
        planner->setSettings({.tau = 2.5, .route = Route::Closed});
        QCOMPARE(planner->settings().tau, 2.5);
        (void)planner->plan(without(five(), {3}), {});
        const double muClosed = m_script.problems.at(0).mu;
        QCOMPARE(m_script.problems[0].route, Route::Closed);
        QVERIFY((m_script.options[0].hint == FleetPlan{{1, 3, 4, 2}})); // the last order stays

        planner->setSettings({.tau = 5, .route = Route::Open});
        (void)planner->plan(without(five(), {3}), {});
        QCOMPARE(m_script.problems.at(1).route, Route::Open);
        COMPARE_NEAR(m_script.problems[1].mu, 2 * muClosed, 1e-12); // Eq. (14): proportional to tau
    }

    void otherPolicyInFlightAndBack()
    {
        const std::unique_ptr<Planner> planner = plannerWithOrder();
        planner->setSettings({.policy = PolicyKind::Nearest});
        QVERIFY((planner->plan(without(five(), {3}), {}).uavs[0].order == Ids{10, 7, 5, 42}));
        QVERIFY(m_script.problems.empty()); // no solver was called
        planner->setSettings({});
        (void)planner->plan(without(five(), {3, 10}), {});
        // The warm start is the order of the other policy: 7, 5, 42 of the nodes 7, 42, 5.
        QVERIFY((m_script.options.at(0).hint == FleetPlan{{1, 3, 2}}));
    }

    void refusedSettingsChangeNothing()
    {
        const std::unique_ptr<Planner> planner = plannerWithOrder({.tau = 1.5});
        QVERIFY_THROWS_EXCEPTION(Error, planner->setSettings({.policy = PolicyKind::Coverage}));
        QVERIFY((planner->settings() == PlannerSettings{.tau = 1.5}));
        m_script.answer = answering(noOrder(StopReason::TimeLimit));
        QVERIFY((planner->plan(without(five(), {3}), {}).uavs[0].order == Ids{10, 42, 5, 7}));
    }

    void unsupportedPolicyIsRefused()
    {
        try {
            const Planner planner(PlannerSettings{.policy = PolicyKind::Coverage});
            QFAIL("nothing thrown");
        } catch (const Error& e) {
            QCOMPARE(e.code(), ErrorCode::Unsupported);
        }
    }

    /** Without a given solver it uses the back end of the settings, also after a change. */
    void ownBackEndOfTheSettings()
    {
        Planner planner({.backend = Backend::Exact});
        const Plan answer = planner.plan(five(), {});
        QCOMPARE(answer.outcome.status, SolveStatus::Optimal);
        QCOMPARE(answer.outcome.source, AnswerSource::Exact);
        COMPARE_NEAR(answer.outcome.objective,
                     bruteForce(problemOfUav(answer.problem, 0)).objective, 1e-9);
        planner.setSettings({.tau = 0.2, .backend = Backend::Auto});
        const Plan changed = planner.plan(five(), {});
        COMPARE_NEAR(changed.outcome.objective,
                     bruteForce(problemOfUav(changed.problem, 0)).objective, 1e-9);
        COMPARE_NEAR(changed.problem.mu, 0.2 * answer.problem.mu, 1e-12);
    }

    void fleetsStartFromTheirLastOrders()
    {
        Planner planner({}, nullptr, makeScriptedPolicy);
        g_script.answer = answeringFleet({{10, 7, 5}, {42, 3}});
        const Plan first = planner.plan(twoForFive(), {});
        QVERIFY((ordersOf(first) == std::vector<Ids>{{10, 7, 5}, {42, 3}}));
        QVERIFY(!first.fellBack);
        QVERIFY(g_script.requests[0].uavs[0].lastRest.empty());

        // Now the UAVs are exchanged, 10 is in view, and 3 is no longer available to the second
        // UAV.
        PlanRequest next = withoutIceberg(twoForFive(), 10);
        next.uavs[1].available[3] = false;
        std::swap(next.uavs[0], next.uavs[1]);
        (void)planner.plan(next, {});
        QVERIFY((g_script.requests[1].uavs[0].lastRest == Ids{42}));
        QVERIFY((g_script.requests[1].uavs[1].lastRest == Ids{7, 5}));
        (void)planner.plan(next, {}, false);
        QVERIFY(g_script.requests[2].uavs[0].lastRest.empty());
    }

    /**
     * UAVs fly to the rest of their last orders, else to the nearest iceberg that no other one
     * flies to.
     */
    void fleetsFallBack_data()
    {
        QTest::addColumn<bool>("throws");
        QTest::newRow("no order") << false;
        QTest::newRow("failure") << true;
    }
    void fleetsFallBack()
    {
        QFETCH(bool, throws);
        Planner planner({}, nullptr, makeScriptedPolicy);
        const auto fail = [throws](const PlanRequest&) -> Plan {
            if (throws)
                throw std::runtime_error("out of order");
            return {.outcome = {.status = SolveStatus::None, .reason = StopReason::TimeLimit}};
        };
        g_script.answer = fail;
        const Plan first = planner.plan(twoForFive(), {});
        QVERIFY((ordersOf(first) == std::vector<Ids>{{10}, {42}}));
        QVERIFY(first.fellBack);
        QCOMPARE(first.failure.empty(), !throws);

        g_script.answer = answeringFleet({{7, 10, 3}, {}});
        QVERIFY((ordersOf(planner.plan(twoForFive(), {})) == std::vector<Ids>{{7, 10, 3}, {}}));
        g_script.answer = fail;
        const Plan second = planner.plan(withoutIceberg(twoForFive(), 7), {});
        QVERIFY((ordersOf(second) == std::vector<Ids>{{10, 3}, {42}}));
        // The second UAV has nothing left to visit.
        PlanRequest busy = withoutUav(twoForFive(), 1);
        QVERIFY((ordersOf(planner.plan(busy, {})) == std::vector<Ids>{{10, 3}, {}}));
        busy = withoutUav(busy, 0);
        const Plan none = planner.plan(busy, {});
        QVERIFY((ordersOf(none) == std::vector<Ids>{{}, {}}));
        QVERIFY(!none.fellBack);
    }

    void cancelledFleetsLeaveTheMemoryAsItWas()
    {
        Planner planner({}, nullptr, makeScriptedPolicy);
        g_script.answer = answeringFleet({{7, 10}, {42, 3, 5}});
        (void)planner.plan(twoForFive(), {});
        g_script.answer = [](const PlanRequest&) {
            return Plan{.outcome = {.reason = StopReason::Cancelled}};
        };
        QVERIFY(!planner.plan(twoForFive(), {}).fellBack);
        (void)planner.plan(twoForFive(), {});
        QVERIFY((g_script.requests.back().uavs[1].lastRest == Ids{42, 3, 5}));
    }

    /** No two UAVs fly to one iceberg, whatever the policy answers. */
    void noTwoUavsFlyToOneIceberg()
    {
        Planner planner({}, nullptr, makeScriptedPolicy);
        g_script.answer = answeringFleet({{7, 10}, {7, 42, 3}});
        QVERIFY((ordersOf(planner.plan(twoForFive(), {})) == std::vector<Ids>{{7, 10}, {42, 3}}));
        const PlanRequest later = withoutIceberg(twoForFive(), 7);
        QVERIFY((ordersOf(planner.plan(later, {})) == std::vector<Ids>{{10}, {42, 3}}));
    }

    void membersOfClustersFollowInFleets()
    {
        Planner planner({}, nullptr, makeScriptedPolicy);
        PlanRequest request = twoForFive();
        request.clusters = {{10, 98, 99}, {42, 97}};
        g_script.answer = answeringFleet({{7, 10}, {3}});
        const Plan answer = planner.plan(request, {});
        QVERIFY((ordersOf(answer) == std::vector<Ids>{{7, 10, 98, 99}, {3}}));
        QVERIFY((answer.uavs[0].clusters == std::vector<Ids>{{10, 98, 99}}));
        (void)planner.plan(request, {});
        QVERIFY((g_script.requests.back().uavs[0].lastRest == Ids{7, 10}));
    }

    /** In flight each plan starts from the rest of the previous one. */
    void fleetsAreReplannedWarm()
    {
        Planner planner({});
        const PlanRequest all = randomFleetRequest(5, 3, 20);
        Plan answer = planner.plan(all, {});
        QVERIFY(!answer.outcome.hintUsed);
        const PlanRequest next = withoutIceberg(all, answer.uavs[1].order.front());
        const Plan warm = planner.plan(next, {});
        QVERIFY(warm.outcome.hintUsed);
        QVERIFY(warm.outcome.status == SolveStatus::Optimal);
        COMPARE_NEAR(warm.outcome.objective, Planner({}).plan(next, {}).outcome.objective, 1e-9);
    }
};

QTEST_APPLESS_MAIN(TestPlanner)
#include "tst_planner.moc"
