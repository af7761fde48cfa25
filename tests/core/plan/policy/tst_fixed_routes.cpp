#include "core/plan/policy/policy.h"
#include "tests/support/approx.h"
#include "tests/support/plan/fleet_requests.h"
#include "tests/support/plan/request_builder.h"
#include "tests/support/plan/test_solvers.h"

#include <algorithm>
#include <memory>

using namespace berg;
using namespace berg::test;

using Ids = IcebergList;

namespace {

/** Returns the length of the cycle of the icebergs alone, without the UAV. */
double cycleLength_m(const PlanRequest& request, const Ids& ids)
{
    double length_m = 0;
    for (std::size_t i = 0; i < ids.size(); ++i)
        length_m += legBetween(request.uavs[0].distance_m, nodeOf(request.ids, ids[i]),
                               nodeOf(request.ids, ids[(i + 1) % ids.size()]));
    return length_m;
}

/** sum sigma_i t_i with t_i the distance flown until iceberg i. */
double waiting(const PlanRequest& request, const Ids& ids)
{
    double sum = 0;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const Ids until(ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(i) + 1);
        sum +=
            pathLength_m(request, until) * request.sigma_m2[toIndex(nodeOf(request.ids, ids[i]))];
    }
    return sum;
}

} // namespace

/** The two policies that keep one sequence: `path` and `tour`. */
class TestFixedRoutes : public QObject
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
    /** A UAV flies to an iceberg assigned to it although one that is on its way home had it. */
    void assignedIcebergsAreNotWaitedFor()
    {
        const std::unique_ptr<Policy> path = policy(PolicyKind::Path);
        const PlanRequest all =
            fleetRequestOf({{0, 0}, {9000, 0}, {0, 9000}}, {{1, {500, 0}, 5},
                                                            {2, {1000, 0}, 5},
                                                            {3, {9500, 0}, 5},
                                                            {4, {500, 9000}, 5},
                                                            {5, {900, 9000}, 5}});
        QCOMPARE(path->plan(all, {}).uavs[0].order, (Ids{1, 2}));
        PlanRequest others = all;
        others.uavs.erase(others.uavs.begin());
        others.uavs[0].available = {false, true, false, false, false};
        others.uavs[1].available = {false, false, false, true, true};
        QVERIFY(path->plan(others, {}).uavs[0].order.empty()); // the first UAV returns to it later
        others.uavs[0].assigned = {2};
        const Plan answer = path->plan(others, {});
        QCOMPARE(answer.uavs[0].order, Ids{2});
        QCOMPARE(answer.uavs[1].order, (Ids{4, 5}));
    }

    /**
     * An iceberg that appears to one UAV alone, after it has flown its part, need not wait for the
     * others.
     */
    void aUavWhosePartIsFlownGetsItsOwnIcebergs()
    {
        const std::unique_ptr<Policy> path = policy(PolicyKind::Path);
        const PlanRequest all = fleetRequestOf(
            {{0, 0}, {9000, 0}},
            {{1, {500, 0}, 5}, {2, {1000, 0}, 5}, {3, {1500, 0}, 5}, {4, {9500, 0}, 5}});
        PlanRequest now = withoutIceberg(all, 4); // in view at first
        static_cast<void>(path->plan(now, {}));
        now = all;
        now.uavs[0].available = {true, true, true, false};
        now.uavs[1].available = {false, false, false, true};
        const Plan answer = path->plan(now, {});
        QVERIFY(!answer.uavs[0].order.empty());
        QCOMPARE(answer.uavs[1].order, Ids{4});
        QCOMPARE(path->plan(now, {}).uavs[1].order, Ids{4});
        // The iceberg is assigned in flight, although it is in the other UAV's part.
        now.uavs[0].available = {true, true, false, false};
        now.uavs[1].available = {false, false, true, false};
        QCOMPARE(path->plan(now, {}).uavs[1].order, Ids{3});
    }

    void init()
    {
        m_script = {.answer = triedAll};
        m_solver = std::make_unique<ScriptedSolver>(m_script);
    }

    void pathIsTheShortest_data()
    {
        QTest::addColumn<int>("icebergs");
        for (const int icebergs : {1, 2, 3, 5, 6, 7})
            QTest::addRow("%d icebergs", icebergs) << icebergs;
    }

    void pathIsTheShortest()
    {
        QFETCH(int, icebergs);
        Random random(3, static_cast<std::uint64_t>(icebergs));
        for (int k = 0; k < 5; ++k) {
            PlanRequest request = requestOf({-500, 500}, randomPlaces(random, icebergs));
            for (double& sigma_m2 : request.sigma_m2)
                sigma_m2 *= 1000; // as large as the distances, but without influence
            const Plan answer = policy(PolicyKind::Path)->plan(request, {});
            double shortest_m = 1e300;
            forEachOrder(request, [&](const Ids& ids) {
                shortest_m = std::min(shortest_m, pathLength_m(request, ids));
            });
            COMPARE_NEAR(pathLength_m(request, answer.uavs[0].order), shortest_m, 1e-9);
            QCOMPARE(answer.uavs[0].order.size(), request.ids.size());
        }
    }

    /** The path is flown to its end although the icebergs change; only then is a new one made. */
    void pathContinuesItsSequence()
    {
        const std::unique_ptr<Policy> path = policy(PolicyKind::Path);
        Ids rest = path->plan(five(), {}).uavs[0].order;
        while (rest.size() > 1) {
            const IcebergIndex reached = rest.front();
            rest.erase(rest.begin());
            std::vector<Place> later = kFive;
            for (Place& place : later) // nearest-first and sigma-first would both go elsewhere
                place.sigma_m2 = 20 - place.sigma_m2;
            const PlanRequest request = requestOf({4000, 4000}, later);
            QVERIFY(path->plan(without(request, {reached}), {}).uavs[0].order == rest);
            QCOMPARE(m_script.problems.size(), std::size_t{1});
        }
        const Plan again = path->plan(without(five(), {rest.front()}), {});
        QCOMPARE(m_script.problems.size(), std::size_t{2});
        QCOMPARE(again.uavs[0].order.size(), std::size_t{4}); // all but the one in view
    }

    /** An iceberg seen during an earlier leg is skipped when its turn comes. */
    void pathPassesOverWhatIsInView()
    {
        const std::unique_ptr<Policy> path = policy(PolicyKind::Path);
        const Ids order = path->plan(five(), {}).uavs[0].order;
        const Plan answer = path->plan(without(five(), {order[0], order[1]}), {});
        QVERIFY((answer.uavs[0].order == Ids{order[2], order[3], order[4]}));
        // It stays passed over when it is out of view again.
        const Plan next = path->plan(without(five(), {order[2]}), {});
        QVERIFY((next.uavs[0].order == Ids{order[3], order[4]}));
    }

    /** An iceberg in view long before its turn stays in the sequence. */
    void pathKeepsWhatIsInViewEarly()
    {
        const std::unique_ptr<Policy> path = policy(PolicyKind::Path);
        const Ids order = path->plan(five(), {}).uavs[0].order;
        const Plan answer = path->plan(without(five(), {order[0], order[2]}), {});
        QVERIFY((answer.uavs[0].order == Ids{order[1], order[2], order[3], order[4]}));
        QCOMPARE(path->plan(without(five(), {order[1]}), {}).uavs[0].order.front(), order[2]);
    }

    void fixedRoutesStartAnewWithANewIceberg_data()
    {
        QTest::addColumn<PolicyKind>("kind");
        QTest::newRow("path") << PolicyKind::Path;
        QTest::newRow("tour") << PolicyKind::Tour;
    }

    void fixedRoutesStartAnewWithANewIceberg()
    {
        QFETCH(PolicyKind, kind);
        const std::unique_ptr<Policy> route = policy(kind);
        const Ids order = route->plan(five(), {}).uavs[0].order;
        (void)route->plan(without(five(), {order[0]}), {});
        QCOMPARE(m_script.problems.size(), std::size_t{1});
        std::vector<Place> six = kFive;
        six.push_back({77, {2000, 2000}, 5});
        const PlanRequest request = requestOf({1000, 1000}, six);
        const Plan answer = route->plan(request, {});
        QCOMPARE(m_script.problems.size(), std::size_t{2});
        const Plan fresh = policy(kind)->plan(request, {});
        QVERIFY(answer.uavs[0].order == fresh.uavs[0].order);
        QCOMPARE(answer.uavs[0].order.size(), std::size_t{6});
    }

    void tourIsTheShortestCycle_data()
    {
        QTest::addColumn<int>("icebergs");
        QTest::addColumn<bool>("windy");
        for (const int icebergs : {1, 2, 3, 4, 5, 6, 7})
            for (const bool windy : {false, true})
                QTest::addRow("%d icebergs, %s", icebergs, windy ? "windy" : "calm")
                    << icebergs << windy;
    }

    void tourIsTheShortestCycle()
    {
        QFETCH(int, icebergs);
        QFETCH(bool, windy);
        Random random(4, static_cast<std::uint64_t>(icebergs));
        for (int k = 0; k < 4; ++k) {
            PlanRequest request = requestOf({-500, 500}, randomPlaces(random, icebergs));
            for (Eigen::Index i = 0; windy && i <= icebergs; ++i)
                for (Eigen::Index j = 0; j <= icebergs; ++j)
                    request.uavs[0].distance_m(i, j) *= random.uniform(1, 1.5);
            const Ids order = policy(PolicyKind::Tour)->plan(request, {}).uavs[0].order;
            QCOMPARE(order.size(), request.ids.size());

            double shortest_m = 1e300;
            forEachOrder(request, [&](const Ids& ids) {
                shortest_m = std::min(shortest_m, cycleLength_m(request, ids));
            });
            const Ids back(order.rbegin(), order.rend());
            COMPARE_NEAR(std::min(cycleLength_m(request, order), cycleLength_m(request, back)),
                         shortest_m, 1e-9);
            // No other entry into this cycle has a smaller sum of waiting.
            double leastWaiting = 1e300;
            forEachOrder(request, [&](const Ids& ids) {
                const Ids other(ids.rbegin(), ids.rend());
                if (std::min(cycleLength_m(request, ids), cycleLength_m(request, other)) <
                    shortest_m + 1e-9)
                    leastWaiting = std::min(leastWaiting, waiting(request, ids));
            });
            COMPARE_NEAR(waiting(request, order), leastWaiting, 1e-9 * leastWaiting);
        }
    }

    /** The tour repeats the same sequence, from one solve. */
    void tourGoesRoundAndRound()
    {
        const std::unique_ptr<Policy> tour = policy(PolicyKind::Tour);
        const Ids cycle = tour->plan(five(), {}).uavs[0].order;
        Ids flown{cycle.front()};
        for (int leg = 0; leg < 12; ++leg) {
            const Plan answer = tour->plan(without(five(), {flown.back()}), {});
            flown.push_back(answer.uavs[0].order.front());
        }
        for (std::size_t i = 0; i < flown.size(); ++i)
            QCOMPARE(flown[i], cycle[i % cycle.size()]);
        QCOMPARE(m_script.problems.size(), std::size_t{1});
    }

    /** The outcome of the tour is that of the cycle, with the first iceberg in the UAV's place. */
    void tourReportsWhatWasSolved()
    {
        const PlanRequest request = five();
        const Plan answer = policy(PolicyKind::Tour)->plan(request, {});
        QCOMPARE(answer.problem.route, Route::Closed);
        QCOMPARE(answer.problem.icebergCount(), 4);
        QCOMPARE(answer.outcome.status, SolveStatus::Optimal);
        COMPARE_NEAR(answer.outcome.objective, cycleLength_m(request, answer.uavs[0].order), 1e-9);
    }
};

QTEST_APPLESS_MAIN(TestFixedRoutes)
#include "tst_fixed_routes.moc"
