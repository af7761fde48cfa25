#include "core/plan/policy/policy.h"
#include "tests/support/approx.h"
#include "tests/support/plan/fleet_requests.h"
#include "tests/support/plan/request_builder.h"
#include "tests/support/plan/test_solvers.h"

#include <algorithm>
#include <array>
#include <memory>
#include <set>

using namespace berg;
using namespace berg::test;

using Ids = IcebergList;
Q_DECLARE_METATYPE(Ids)

namespace {

/** Computes mu by Eq. (10)-(14) independently. */
double muByHand(const TvpProblem& problem, double tau)
{
    std::vector<double> sorted = problem.sigma_m2;
    std::sort(sorted.begin(), sorted.end());
    double f1Max = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i)
        f1Max += static_cast<double>(i) * sorted[i];
    const auto n = static_cast<double>(sorted.size());
    const double average_m = problem.distance_m.sum() / (n * (n - 1)); // the diagonal is 0
    return tau * f1Max / (average_m * (n - 1));
}

/** Returns the problem of the UAV and the available icebergs alone. */
TvpProblem subProblem(const PlanRequest& request)
{
    std::vector<int> nodes{0};
    for (std::size_t k = 0; k < request.ids.size(); ++k)
        if (request.uavs[0].available[k])
            nodes.push_back(static_cast<int>(k) + 1);
    TvpProblem sub;
    const auto n = static_cast<Eigen::Index>(nodes.size());
    sub.distance_m.resize(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const int from = nodes[static_cast<std::size_t>(i)];
        sub.sigma_m2.push_back(request.sigma_m2[static_cast<std::size_t>(from)]);
        for (Eigen::Index j = 0; j < n; ++j)
            sub.distance_m(i, j) =
                request.uavs[0].distance_m(from, nodes[static_cast<std::size_t>(j)]);
    }
    return sub;
}

constexpr std::array kFlown{PolicyKind::Visitation, PolicyKind::Path,        PolicyKind::Tour,
                            PolicyKind::Nearest,    PolicyKind::Uncertainty, PolicyKind::Latency};

} // namespace

class TestPolicy : public QObject
{
    Q_OBJECT

private:
    SolverScript m_script;
    std::unique_ptr<ScriptedSolver> m_solver;

    [[nodiscard]] std::unique_ptr<Policy> policy(PolicyKind kind) const
    {
        return makePolicy({.policy = kind}, *m_solver);
    }

private slots:
    void init()
    {
        m_script = {.answer = triedAll};
        m_solver = std::make_unique<ScriptedSolver>(m_script);
    }

    void nodesAndTheirIcebergs()
    {
        const IcebergList ids{10, 7, 42};
        QVERIFY(nodeOf(ids, 42) == 3);
        QVERIFY(icebergOf(ids, 1) == 10);
        for (const IcebergIndex id : ids)
            QVERIFY(icebergOf(ids, nodeOf(ids, id)) == id);
        QVERIFY_THROWS_EXCEPTION(std::logic_error, (void)nodeOf(ids, 1));
    }

    /** 10 is nearest; from there 7 (1803 m), 5 (2236 m), 42 (5000 m), 3. */
    void nearestByHand()
    {
        const Plan answer = policy(PolicyKind::Nearest)->plan(five(), {});
        QVERIFY((answer.uavs[0].order == Ids{10, 7, 5, 42, 3}));
        QVERIFY(m_script.problems.empty()); // no solver was called
        // Distances 1000, 1803, 2236, 5000, 1500 m; mu = 0 in the request: the reward alone.
        COMPARE_NEAR(fleetDistance(answer.problem, answer.outcome.plan),
                     1000 + std::sqrt(3.25e6) + std::sqrt(5e6) + 5000 + 1500, 1e-9);
        // N = 6: 2 x 4 + 9 x 3 + 1 x 2 + 5 x 1
        COMPARE_NEAR(answer.outcome.objective, -42, 1e-12);
    }

    void uncertaintyByHand()
    {
        const Plan answer = policy(PolicyKind::Uncertainty)->plan(five(), {});
        // 7 and 3 both have 9: the smaller node comes first (7, first in the request), not the
        // smaller id.
        QVERIFY((answer.uavs[0].order == Ids{7, 3, 42, 10, 5}));
        QVERIFY(m_script.problems.empty());
    }

    void nearestTiesGoToTheFirst()
    {
        const PlanRequest request =
            requestOf({0, 0}, {{9, {0, 700}, 1}, {4, {700, 0}, 8}, {2, {-700, 0}, 9}});
        QCOMPARE(policy(PolicyKind::Nearest)->plan(request, {}).uavs[0].order.front(),
                 IcebergIndex(9));
    }

    void visitationIsTheOptimum_data()
    {
        QTest::addColumn<double>("tau");
        QTest::addColumn<Route>("route");
        QTest::addColumn<int>("icebergs");
        for (const double tau : {0.3, 1.0, 3.0})
            for (const auto& route : kRouteNames)
                for (const int icebergs : {1, 2, 4, 6})
                    QTest::addRow("tau %g, %s, %d icebergs", tau, route.name.data(), icebergs)
                        << tau << route.value << icebergs;
    }

    void visitationIsTheOptimum()
    {
        QFETCH(double, tau);
        QFETCH(Route, route);
        QFETCH(int, icebergs);
        Random random(1, static_cast<std::uint64_t>(icebergs));
        const PlannerSettings settings{.tau = tau, .route = route};
        const std::unique_ptr<Policy> policy = makePolicy(settings, *m_solver);
        for (int k = 0; k < 5; ++k) {
            // One more iceberg is in view and must not affect the plan, not even mu.
            PlanRequest request = requestOf({-500, 500}, randomPlaces(random, icebergs + 1));
            request = without(request, {request.ids[static_cast<std::size_t>(k % icebergs)]});
            const Plan answer = policy->plan(request, {});

            TvpProblem expected = subProblem(request);
            expected.mu = muByHand(expected, tau);
            expected.route = route;
            COMPARE_NEAR(answer.problem.mu, expected.mu, 1e-12 * expected.mu);
            QCOMPARE(answer.problem.route, route);
            QVERIFY(answer.problem.distance_m.at(0) == expected.distance_m);
            QVERIFY(answer.problem.sigma_m2 == expected.sigma_m2);
            const BruteForce best = bruteForce(expected);
            COMPARE_NEAR(answer.outcome.objective, best.objective, 1e-9);
            COMPARE_NEAR(answer.outcome.objective, objective(expected, answer.outcome.order()),
                         1e-9);
            Ids ids;
            for (const NodeIndex node : answer.outcome.order())
                ids.push_back(icebergOf(answer.solvedIds, node));
            QVERIFY(answer.uavs[0].order == ids);
            for (const IcebergIndex id : ids)
                QVERIFY(request.uavs[0].available[toIndex(nodeOf(request.ids, id)) - 1]);
        }
    }

    void windMakesNoOtherOrder_data()
    {
        QTest::addColumn<Route>("route");
        for (const auto& route : kRouteNames)
            QTest::newRow(route.name.data()) << route.value;
    }

    /**
     * The differences that a uniform wind makes between directions of legs sum to a value that
     * depends on the ends of an order. They do not affect the choice, but the flight time.
     */
    void windMakesNoOtherOrder()
    {
        QFETCH(Route, route);
        const PlannerSettings settings{.route = route};
        const std::unique_ptr<Policy> policy = makePolicy(settings, *m_solver);
        const PlanRequest calm = five();
        PlanRequest windy = calm;
        constexpr double kPerPlace_m = 150; // nodes farther downwind have higher numbers
        Eigen::MatrixXd& all_m = windy.uavs[0].distance_m;
        for (int i = 0; i < all_m.rows(); ++i)
            for (int j = 0; j < all_m.cols(); ++j)
                all_m(i, j) -= kPerPlace_m * (j - i);
        const Plan expected = policy->plan(calm, {});
        const Plan answer = policy->plan(windy, {});
        QVERIFY(answer.uavs[0].order == expected.uavs[0].order);
        COMPARE_NEAR(answer.problem.mu, expected.problem.mu, 1e-12);
        COMPARE_NEAR(answer.outcome.objective, expected.outcome.objective, 1e-9);
        const NodeIndex end =
            route == Route::Closed ? NodeIndex() : nodeOf(calm.ids, expected.uavs[0].order.back());
        const double made_m = kPerPlace_m * end.number();
        COMPARE_NEAR(answer.distance_m, expected.distance_m - made_m, 1e-9);
    }

    /** High tau: the shortest path. Low tau: largest sigma first. */
    void tauTradesDistanceForUncertainty()
    {
        const PlanRequest request = five();
        const auto order = [&](double tau) {
            return makePolicy({.tau = tau}, *m_solver)->plan(request, {}).uavs[0].order;
        };
        const Ids direct = order(1000);
        forEachOrder(request, [&](const Ids& other) {
            QVERIFY(pathLength_m(request, direct) <= pathLength_m(request, other) + 1e-9);
        });
        const Ids uncertain = order(1e-6);
        // mu D decides between the two with sigma 9: 7, 3, 42, ... is shorter than 3, 7, 42, ...
        QVERIFY((uncertain == Ids{7, 3, 42, 10, 5}));
    }

    /**
     * With every sigma 0 the plan is by distance alone, not by mu = 0, which would give no order.
     */
    void nothingUncertainMeansShortestPath()
    {
        std::vector<Place> places = kFive;
        for (Place& place : places)
            place.sigma_m2 = 0;
        const PlanRequest request = requestOf({0, 0}, places);
        const Plan answer = policy(PolicyKind::Visitation)->plan(request, {});
        QCOMPARE(answer.problem.mu, 1.0);
        forEachOrder(request, [&](const Ids& other) {
            QVERIFY(pathLength_m(request, answer.uavs[0].order) <=
                    pathLength_m(request, other) + 1e-9);
        });
    }

    void latencyWithoutSigmaMeansShortestPath()
    {
        std::vector<Place> places = kFive;
        for (Place& place : places)
            place.sigma_m2 = 0;
        const PlanRequest request = requestOf({0, 0}, places);
        const Plan answer = policy(PolicyKind::Latency)->plan(request, {});
        QCOMPARE(answer.problem.mu, 1.0);
        forEachOrder(request, [&](const Ids& other) {
            QVERIFY(pathLength_m(request, answer.uavs[0].order) <=
                    pathLength_m(request, other) + 1e-9);
        });
    }

    /**
     * The plan minimises the sum of sigma times arrival time over the available icebergs, whatever
     * tau and route are.
     */
    void latencyIsTheOptimum()
    {
        const PlanRequest request = without(five(), {42});
        const auto waiting_m2s = [&](const Ids& ids) {
            double time_s = 0;
            double sum_m2s = 0;
            NodeIndex from;
            for (const IcebergIndex id : ids) {
                const NodeIndex to = nodeOf(request.ids, id);
                time_s += legBetween(request.uavs[0].distance_m, from, to) / request.speed_mps;
                sum_m2s += request.sigma_m2[toIndex(to)] * time_s;
                from = to;
            }
            return sum_m2s;
        };
        for (const PlannerSettings& settings :
             {PlannerSettings{.policy = PolicyKind::Latency, .tau = 0},
              PlannerSettings{.policy = PolicyKind::Latency, .tau = 5, .route = Route::Closed}}) {
            const Plan answer = makePolicy(settings, *m_solver)->plan(request, {});
            QCOMPARE(answer.uavs[0].order.size(), std::size_t{4});
            COMPARE_NEAR(answer.outcome.objective, waiting_m2s(answer.uavs[0].order), 1e-9);
            forEachOrder(request, [&](Ids other) {
                std::erase(other, IcebergIndex(42));
                QVERIFY(waiting_m2s(answer.uavs[0].order) <= waiting_m2s(other) + 1e-9);
            });
        }
    }

    /** The MILPs are those of Eq. (1). */
    void latencyIsNotForCbc()
    {
        const PlannerSettings settings{.policy = PolicyKind::Latency, .backend = Backend::Cbc};
        try {
            (void)makePolicy(settings, *m_solver);
            QFAIL("nothing thrown");
        } catch (const Error& e) {
            QCOMPARE(e.code(), ErrorCode::Unsupported);
            QCOMPARE(e.subject(), std::string("planner.backend"));
        }
    }

    /** The first iceberg of the order is never in view, and there is one if possible. */
    void firstIsAlwaysAvailable_data()
    {
        QTest::addColumn<PolicyKind>("kind");
        for (const PolicyKind kind : kFlown)
            QTest::newRow(nameOf(kPolicyNames, kind).c_str()) << kind;
    }

    void firstIsAlwaysAvailable()
    {
        QFETCH(PolicyKind, kind);
        const std::unique_ptr<Policy> lasting = policy(kind);
        Random random(2);
        for (unsigned mask = 0; mask < 32; ++mask) {
            // Tests each mask on a new policy, and a random walk of masks on one that keeps its
            // state.
            for (const bool remembers : {false, true}) {
                const unsigned bits = remembers ? static_cast<unsigned>(random.below(32)) : mask;
                PlanRequest request = five();
                for (unsigned k = 0; k < 5; ++k)
                    request.uavs[0].available[k] = (bits >> k & 1U) != 0;
                const std::unique_ptr<Policy> fresh = policy(kind);
                const Plan answer = (remembers ? *lasting : *fresh).plan(request, {});
                QCOMPARE(answer.uavs[0].order.empty(), bits == 0);
                if (bits == 0)
                    continue;
                const std::size_t first = toIndex(nodeOf(request.ids, answer.uavs[0].order[0])) - 1;
                QVERIFY(request.uavs[0].available.at(first));
                const std::set<IcebergIndex> different(answer.uavs[0].order.begin(),
                                                       answer.uavs[0].order.end());
                QCOMPARE(different.size(), answer.uavs[0].order.size());
            }
        }
    }

    /** Once, a UAV got no iceberg if another UAV was nearer to all of them, and circled. */
    void eachUavHasAFirst_data()
    {
        QTest::addColumn<PolicyKind>("kind");
        QTest::newRow("nearest") << PolicyKind::Nearest;
        QTest::newRow("uncertainty") << PolicyKind::Uncertainty;
    }

    void eachUavHasAFirst()
    {
        QFETCH(PolicyKind, kind);
        const PlanRequest request = test::fleetRequestOf({{0, 0}, {-5000, 0}}, kFive);
        const Plan answer = policy(kind)->plan(request, {});
        QVERIFY(!answer.uavs[0].order.empty());
        QVERIFY(!answer.uavs[1].order.empty());
    }

    void noIcebergNoOrder_data() { firstIsAlwaysAvailable_data(); }

    void noIcebergNoOrder()
    {
        QFETCH(PolicyKind, kind);
        const std::unique_ptr<Policy> lonely = policy(kind);
        QVERIFY(lonely->plan(requestOf({0, 0}, {}), {}).uavs[0].order.empty());
        // When the first iceberg appears, it is flown to.
        QVERIFY((lonely->plan(requestOf({0, 0}, {kFive[0]}), {}).uavs[0].order == Ids{10}));
    }

    /** Policies that plan each time hold every available iceberg and no other. */
    void ordersHoldTheAvailable_data()
    {
        QTest::addColumn<PolicyKind>("kind");
        for (const PolicyKind kind : {PolicyKind::Visitation, PolicyKind::Path, PolicyKind::Nearest,
                                      PolicyKind::Uncertainty, PolicyKind::Latency})
            QTest::newRow(nameOf(kPolicyNames, kind).c_str()) << kind;
    }

    void ordersHoldTheAvailable()
    {
        QFETCH(PolicyKind, kind);
        for (const std::set<IcebergIndex>& available :
             {std::set<IcebergIndex>{10, 7, 42, 3, 5}, {7, 3}, {5}, {42, 10, 5}}) {
            const Plan answer = policy(kind)->plan(withAvailable(five(), available), {});
            QVERIFY(std::set<IcebergIndex>(answer.uavs[0].order.begin(),
                                           answer.uavs[0].order.end()) == available);
            QCOMPARE(answer.uavs[0].order.size(), available.size());
        }
    }

    /** The hint is the rest of the last plan by node numbers, newcomers last. */
    void hintReachesTheSolver_data()
    {
        QTest::addColumn<Ids>("lastRest");
        QTest::addColumn<VisitOrder>("hint"); // nodes: 10, 42, 3, 5 are 1, 2, 3, 4 with 7 in view
        QTest::newRow("none") << Ids{} << VisitOrder{};
        QTest::newRow("all") << Ids{5, 42, 3, 10} << VisitOrder{4, 2, 3, 1};
        QTest::newRow("some, the others follow") << Ids{3, 10} << VisitOrder{3, 1, 2, 4};
        QTest::newRow("one that is gone") << Ids{3, 99, 10, 42, 5} << VisitOrder{3, 1, 2, 4};
    }

    void hintReachesTheSolver()
    {
        QFETCH(Ids, lastRest);
        QFETCH(VisitOrder, hint);
        const SolveOptions options{.timeLimit_s = 12, .workLimit = 345, .gap = 0.25};
        PlanRequest request = without(five(), {7});
        request.uavs[0].lastRest = lastRest;
        (void)policy(PolicyKind::Visitation)->plan(request, options);
        QCOMPARE(m_script.options.size(), std::size_t{1});
        QVERIFY(m_script.options[0].hint == (hint.empty() ? FleetPlan{} : FleetPlan{hint}));
        QCOMPARE(m_script.options[0].timeLimit_s, options.timeLimit_s);
        QCOMPARE(m_script.options[0].workLimit, options.workLimit);
        QCOMPARE(m_script.options[0].gap, 0.25);
    }

    void noOrderFromTheSolver_data()
    {
        QTest::addColumn<PolicyKind>("kind");
        for (const PolicyKind kind :
             {PolicyKind::Visitation, PolicyKind::Path, PolicyKind::Tour, PolicyKind::Latency})
            QTest::newRow(nameOf(kPolicyNames, kind).c_str()) << kind;
    }

    /** Without an order there is no plan; the next call calls the solver again. */
    void noOrderFromTheSolver()
    {
        QFETCH(PolicyKind, kind);
        const std::unique_ptr<Policy> tried = policy(kind);
        m_script.answer = [](const TvpProblem&) { return noOrder(StopReason::TimeLimit); };
        const Plan nothing = tried->plan(five(), {});
        QVERIFY(nothing.uavs[0].order.empty());
        QCOMPARE(nothing.outcome.reason, StopReason::TimeLimit);
        m_script.answer = triedAll;
        const Plan answer = tried->plan(five(), {});
        QVERIFY(answer.uavs[0].order == policy(kind)->plan(five(), {}).uavs[0].order);
    }

    void cancelledSolveIsNotKept_data() { noOrderFromTheSolver_data(); }

    /**
     * A cancelled solve may return the best order so far. The caller repeats the call later, and
     * must get the result of a first call.
     */
    void cancelledSolveIsNotKept()
    {
        QFETCH(PolicyKind, kind);
        const std::unique_ptr<Policy> cancelled = policy(kind);
        m_script.answer = [](const TvpProblem& problem) {
            SolveOutcome outcome = triedAll(problem);
            VisitOrder& order = outcome.plan.front();
            std::reverse(order.begin(), order.end());
            std::swap(order.front(), order.back()); // an order of no merit
            outcome.status = SolveStatus::Feasible;
            outcome.reason = StopReason::Cancelled;
            return outcome;
        };
        QCOMPARE(cancelled->plan(five(), {}).outcome.reason, StopReason::Cancelled);
        m_script.answer = triedAll;
        const Plan answer = cancelled->plan(five(), {});
        QVERIFY(answer.uavs[0].order == policy(kind)->plan(five(), {}).uavs[0].order);
        QCOMPARE(answer.outcome.reason, StopReason::Finished);
    }

    void unsupportedPoliciesAreRefused_data()
    {
        QTest::addColumn<PolicyKind>("kind");
        QTest::newRow("coverage") << PolicyKind::Coverage;
    }

    void unsupportedPoliciesAreRefused()
    {
        QFETCH(PolicyKind, kind);
        try {
            (void)policy(kind);
            QFAIL("nothing thrown");
        } catch (const Error& e) {
            QCOMPARE(e.code(), ErrorCode::Unsupported);
            QCOMPARE(e.subject(), std::string("planner.policy"));
            QVERIFY(std::string(e.what()).find(nameOf(kPolicyNames, kind)) != std::string::npos);
        }
    }

    void everyNameHasOneValue()
    {
        for (const auto& row : kPolicyNames) {
            QCOMPARE(valueOf(kPolicyNames, row.name).value(), row.value);
            QCOMPARE(nameOf(kPolicyNames, row.value), std::string(row.name));
        }
        QVERIFY(!valueOf(kPolicyNames, "Tour").has_value());
        QVERIFY(!valueOf(kBackendNames, "").has_value());
        QCOMPARE(allowedNames(kRouteNames), std::string("open, closed"));
    }
};

QTEST_APPLESS_MAIN(TestPolicy)
#include "tst_policy.moc"
