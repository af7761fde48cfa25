#include "core/plan/fleet/fleet_solver.h"
#include "core/plan/policy/policy.h"
#include "core/plan/problem/assignment.h"
#include "tests/support/approx.h"
#include "tests/support/plan/fleet_requests.h"

#include <array>
#include <memory>
#include <numeric>

using namespace berg;
using namespace berg::test;

using Ids = IcebergList;
using Orders = std::vector<Ids>;

namespace {

constexpr std::array kFlown{PolicyKind::Visitation, PolicyKind::Path,        PolicyKind::Tour,
                            PolicyKind::Nearest,    PolicyKind::Uncertainty, PolicyKind::Latency};

/** A policy with a solver of its own. */
class Flown
{
public:
    explicit Flown(const PlannerSettings& settings)
        : m_solver(makeSolver(settings.backend)), m_policy(makePolicy(settings, *m_solver))
    {
    }
    explicit Flown(PolicyKind kind) : Flown(PlannerSettings{.policy = kind}) {}

    Plan plan(const PlanRequest& request, const SolveOptions& options = {})
    {
        return m_policy->plan(request, options);
    }

private:
    std::unique_ptr<TvpSolver> m_solver;
    std::unique_ptr<Policy> m_policy;
};

Orders ordersOf(const Plan& answer)
{
    Orders orders;
    for (const UavPlan& uav : answer.uavs)
        orders.push_back(uav.order);
    return orders;
}

double lengthOf(const PlanRequest& request, const Orders& orders)
{
    double length_m = 0;
    for (std::size_t k = 0; k < orders.size(); ++k)
        length_m += pathLength_m(aloneOf(request, k), orders[k]);
    return length_m;
}

/**
 * Returns the fault of an answer of any policy; empty if there is none. With `round`, orders may
 * share icebergs, but not their first ones.
 */
QString faultOf(const PlanRequest& request, const Plan& answer, bool round)
{
    if (answer.uavs.size() != request.uavs.size())
        return QStringLiteral("not one answer for each UAV");
    std::set<IcebergIndex> firsts;
    std::set<IcebergIndex> visited;
    std::set<IcebergIndex> all;
    for (std::size_t k = 0; k < answer.uavs.size(); ++k) {
        const Ids& order = answer.uavs[k].order;
        if (!order.empty() && !firsts.insert(order.front()).second)
            return QStringLiteral("two to one iceberg");
        std::set<IcebergIndex> own;
        for (const IcebergIndex id : order) {
            const std::size_t node = toIndex(nodeOf(request.ids, id));
            if (!request.uavs[k].available.at(node - 1))
                return QStringLiteral("not available");
            if (!own.insert(id).second || (!round && !visited.insert(id).second))
                return QStringLiteral("one twice");
        }
        all.insert(own.begin(), own.end());
    }
    for (std::size_t k = 0; k < request.ids.size(); ++k) {
        const bool some = std::ranges::any_of(
            request.uavs, [k](const UavRequest& uav) { return uav.available[k]; });
        if (some != all.contains(request.ids[k]) && !(round && !some))
            return QStringLiteral("one left out");
    }
    if (!round && std::abs(answer.distance_m - lengthOf(request, ordersOf(answer))) > 1e-6)
        return QStringLiteral("wrong distance");
    return {};
}

void addPolicyRows()
{
    QTest::addColumn<PolicyKind>("kind");
    for (const PolicyKind kind : kFlown)
        QTest::newRow(nameOf(kPolicyNames, kind).c_str()) << kind;
}

} // namespace

/** Properties of every policy for fleets, and of each one. */
class TestFleetPolicies : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void assignmentsAreTheCheapest()
    {
        Random random(5);
        for (const int rows : {1, 3, 5}) {
            for (int k = 0; k < 20; ++k) {
                const int columns = std::min(3, rows);
                Eigen::MatrixXd cost(rows, columns);
                for (double& entry : cost.reshaped())
                    entry = random.uniform(-5, 5);
                const auto costOf = [&](const std::vector<int>& places) {
                    double sum = 0;
                    for (int column = 0; column < columns; ++column)
                        sum += cost(places[static_cast<std::size_t>(column)], column);
                    return sum;
                };
                const std::vector<int> found = cheapestAssignment(cost);
                QCOMPARE(std::set<int>(found.begin(), found.end()).size(),
                         static_cast<std::size_t>(columns));
                QVERIFY(cheapestAssignment(cost, [] { return true; }).empty());
                std::vector<int> places(static_cast<std::size_t>(rows));
                std::iota(places.begin(), places.end(), 0);
                do {
                    QVERIFY(costOf(found) <= costOf(places) + 1e-12);
                } while (std::next_permutation(places.begin(), places.end()));
            }
        }
    }

    void everyAnswerIsAPlan_data() { addPolicyRows(); }
    void everyAnswerIsAPlan()
    {
        QFETCH(PolicyKind, kind);
        struct Size
        {
            int uavs;
            int icebergs;
        };
        Random random(3);
        for (const Size size : {Size{2, 0}, Size{2, 1}, Size{4, 2}, Size{2, 7}, Size{3, 12}})
            for (const double share : {1.0, 0.6, 0.2, 0.0}) {
                const PlanRequest all = randomFleetRequest(7, size.uavs, size.icebergs, true);
                const PlanRequest request = thinnedOut(all, random, share);
                QCOMPARE(faultOf(request, Flown(kind).plan(request), kind == PolicyKind::Tour),
                         QString());
            }
    }

    /** Tests policies that keep their routes over a random walk of requests. */
    void everyAnswerIsAPlanInFlight_data() { addPolicyRows(); }
    void everyAnswerIsAPlanInFlight()
    {
        QFETCH(PolicyKind, kind);
        const PlanRequest all = randomFleetRequest(8, 3, 8);
        Flown flown(kind);
        Random random(4);
        PlanRequest request = all;
        for (int k = 0; k < 40; ++k) {
            const Plan answer = flown.plan(request);
            const bool part = kind == PolicyKind::Path || kind == PolicyKind::Tour;
            const QString fault = faultOf(request, answer, part);
            QVERIFY2(fault.isEmpty() || (part && fault == QStringLiteral("one left out")),
                     qPrintable(fault));
            // In the next request one target is in view, and sometimes a UAV is out of service.
            const Ids& order =
                answer.uavs[static_cast<std::size_t>(random.below(answer.uavs.size()))].order;
            request = order.empty() ? all : withoutIceberg(all, order.front());
            if (random.below(4) == 0)
                request = withoutUav(request, static_cast<std::size_t>(random.below(3)));
        }
    }

    void answersRepeat_data() { addPolicyRows(); }
    void answersRepeat()
    {
        QFETCH(PolicyKind, kind);
        const PlanRequest request = randomFleetRequest(9, 3, 16, true);
        const Plan first = Flown(kind).plan(request);
        const Plan second = Flown(kind).plan(request);
        QVERIFY(ordersOf(first) == ordersOf(second));
        QCOMPARE(first.outcome.objective, second.outcome.objective);
        QCOMPARE(first.outcome.work, second.outcome.work);
    }

    void oneUavOfTwoFliesAsIfAlone_data() { addPolicyRows(); }
    void oneUavOfTwoFliesAsIfAlone()
    {
        QFETCH(PolicyKind, kind);
        for (const std::size_t out : {0U, 1U}) {
            const PlanRequest two = withoutUav(randomFleetRequest(10, 2, 7), out);
            const Plan answer = Flown(kind).plan(two);
            QVERIFY(answer.uavs[out].order.empty());
            const Plan alone = Flown(kind).plan(aloneOf(two, 1 - out));
            QVERIFY(answer.uavs[1 - out].order == alone.uavs[0].order);
            COMPARE_NEAR(answer.outcome.objective, alone.outcome.objective,
                         1e-9 * std::abs(alone.outcome.objective));
            QVERIFY(answer.outcome.status == alone.outcome.status);
        }
    }

    void cancelledAnswersAreEmpty_data() { addPolicyRows(); }
    void cancelledAnswersAreEmpty()
    {
        QFETCH(PolicyKind, kind);
        std::stop_source stop;
        stop.request_stop();
        const PlanRequest request = randomFleetRequest(11, 2, 6);
        Flown flown(kind);
        const Plan answer = flown.plan(request, {.stop = stop.get_token()});
        QCOMPARE(answer.uavs.size(), std::size_t{2});
        if (kind == PolicyKind::Nearest || kind == PolicyKind::Uncertainty)
            return; // the solve ended before the stop
        QVERIFY(answer.outcome.reason == StopReason::Cancelled);
        QVERIFY(answer.outcome.status == SolveStatus::None);
        QVERIFY(answer.uavs[0].order.empty() && answer.uavs[1].order.empty());
        QVERIFY(ordersOf(flown.plan(request)) == ordersOf(Flown(kind).plan(request)));
    }

    void limitsAreKept_data()
    {
        QTest::addColumn<PolicyKind>("kind");
        for (const PolicyKind kind :
             {PolicyKind::Visitation, PolicyKind::Path, PolicyKind::Latency})
            QTest::newRow(nameOf(kPolicyNames, kind).c_str()) << kind;
    }
    void limitsAreKept()
    {
        QFETCH(PolicyKind, kind);
        const PlanRequest request = randomFleetRequest(12, 3, 25);
        const Plan answer = Flown(kind).plan(request, {.workLimit = 1000});
        QCOMPARE(faultOf(request, answer, false), QString());
        QVERIFY(answer.outcome.status == SolveStatus::Feasible);
        QVERIFY(answer.outcome.reason == StopReason::WorkLimit);
    }

    void visitationIsWhatTheSolverSays()
    {
        const PlanRequest request = randomFleetRequest(13, 2, 6);
        for (const Route route : {Route::Open, Route::Closed}) {
            const Plan answer = Flown(PlannerSettings{.tau = 0.7, .route = route}).plan(request);
            FleetProblem problem{
                .distance_m = {request.uavs[0].distance_m, request.uavs[1].distance_m},
                .sigma_m2 = request.sigma_m2,
                .route = route};
            problem.mu = fleetTuningWeight(problem, request.betweenUavs_m, 0.7).mu;
            const SolveOutcome best = solveFleet(problem, Backend::Exact, {});
            QCOMPARE(answer.outcome.objective, best.objective);
            QCOMPARE(answer.gap.value(), 0.0);
            QVERIFY(answer.outcome.status == SolveStatus::Optimal);
            QCOMPARE(answer.outcome.source, AnswerSource::Exact);
        }
    }

    /** mu depends only on the UAVs and icebergs of the plan. */
    void outsidersDoNotChangeThePlan()
    {
        const PlanRequest three = withoutUav(randomFleetRequest(14, 3, 6), 1);
        PlanRequest two = three;
        two.uavs.erase(two.uavs.begin() + 1);
        two.betweenUavs_m = Eigen::MatrixXd(three.betweenUavs_m(Eigen::seq(0, 2, 2), //
                                                                Eigen::seq(0, 2, 2)));
        const Plan answer = Flown(PolicyKind::Visitation).plan(three);
        const Plan expected = Flown(PolicyKind::Visitation).plan(two);
        QCOMPARE(answer.outcome.objective, expected.outcome.objective);
        QVERIFY(answer.uavs[2].order == expected.uavs[1].order);
    }

    /** Sum of sigma times arrival, which no single iceberg elsewhere lowers. */
    void latencyIsInSquareMetreSeconds()
    {
        const PlanRequest request = randomFleetRequest(15, 2, 7);
        const Plan answer = Flown(PolicyKind::Latency).plan(request);
        double sum = 0;
        for (std::size_t k = 0; k < 2; ++k)
            for (std::size_t i = 0; i < answer.uavs[k].order.size(); ++i) {
                const Ids& order = answer.uavs[k].order;
                const Ids until(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(i) + 1);
                sum += pathLength_m(aloneOf(request, k), until) / request.speed_mps *
                       request.sigma_m2[toIndex(nodeOf(request.ids, order[i]))];
            }
        COMPARE_NEAR(answer.outcome.objective, sum, 1e-9 * sum);
        QVERIFY(answer.outcome.status == SolveStatus::Optimal);
        QVERIFY(!answer.uavs[0].order.empty() && !answer.uavs[1].order.empty());
    }

    /** UAVs at 0 and 10 km on a line, icebergs at 1, 2, 4 and 9 km. */
    void greedyByHand()
    {
        const PlanRequest request = fleetRequestOf(
            {{0, 0}, {10000, 0}},
            {{1, {1000, 0}, 2}, {2, {2000, 0}, 5}, {4, {4000, 0}, 5}, {9, {9000, 0}, 1}});
        QVERIFY((ordersOf(Flown(PolicyKind::Nearest).plan(request)) == Orders{{1, 2, 4}, {9}}));
        // Iceberg 2 goes to the first UAV (2 km), 4 to the second, which has none yet, 1 to the
        // first, 9 (from 4: 5 km).
        QVERIFY((ordersOf(Flown(PolicyKind::Uncertainty).plan(request)) == Orders{{2, 1}, {4, 9}}));
        QVERIFY((ordersOf(Flown(PolicyKind::Path).plan(request)) == Orders{{1, 2, 4}, {9}}));
    }

    void pathIsKeptUntilItsEnd()
    {
        const PlanRequest all = fleetRequestOf(
            {{0, 0}, {10000, 0}},
            {{1, {1000, 0}, 2}, {2, {2000, 0}, 5}, {8, {8000, 0}, 5}, {9, {9000, 0}, 1}});
        Flown path(PolicyKind::Path);
        QVERIFY((ordersOf(path.plan(all)) == Orders{{1, 2}, {9, 8}}));
        // A UAV that has flown its part waits for the others.
        QVERIFY((ordersOf(path.plan(withoutIceberg(all, 1))) == Orders{{2}, {9, 8}}));
        QVERIFY((ordersOf(path.plan(withoutIceberg(all, 2))) == Orders{{}, {9, 8}}));
        QVERIFY((ordersOf(path.plan(withoutIceberg(all, 9))) == Orders{{}, {8}}));
        const Plan again = path.plan(withoutIceberg(all, 8));
        QVERIFY((ordersOf(again) == Orders{{1, 2}, {9}}));
        QVERIFY(again.outcome.status == SolveStatus::Optimal);
    }

    /** A square of 8 icebergs, one UAV before each of two opposite sides' first corner. */
    void tourSpreadsTheUavs()
    {
        const std::vector<Place> square{
            {0, {0, 0}, 1},       {1, {1000, 0}, 1},    {2, {2000, 0}, 1}, {3, {2000, 1000}, 1},
            {4, {2000, 2000}, 1}, {5, {1000, 2000}, 1}, {6, {0, 2000}, 1}, {7, {0, 1000}, 1}};
        const PlanRequest all = fleetRequestOf({{2300, 2000}, {-300, 0}}, square);
        Flown tour(PolicyKind::Tour);
        const Orders orders = ordersOf(tour.plan(all));
        QCOMPARE(orders[0].size(), std::size_t{8});
        QCOMPARE(orders[0].front(), IcebergIndex(4));
        QCOMPARE(orders[1].front(), IcebergIndex(0));
        QCOMPARE(std::abs(orders[0][1].number() - 4), 1);
        // Both fly the same direction: from 4 the other one comes to 0 after four.
        QCOMPARE(orders[0][4], IcebergIndex(0));
        QCOMPARE(orders[1][4], IcebergIndex(4));
        COMPARE_NEAR(tour.plan(all).outcome.objective, 8000.0, 1e-6);

        // The first UAV's target is seen, so it continues to the next. The second one keeps its
        // own.
        const Orders next = ordersOf(tour.plan(withoutIceberg(all, 4)));
        QCOMPARE(next[0].front(), orders[0][1]);
        QCOMPARE(next[1].front(), IcebergIndex(0));
        // Icebergs that only the other UAV may visit are passed over.
        PlanRequest barred = all;
        barred.uavs[0].available[toIndex(orders[0][1])] = false;
        QCOMPARE(ordersOf(tour.plan(barred))[0].front(), orders[0][2]);
    }

    /** The solve starts from the rest of the last plan, repaired where it no longer holds. */
    void hintsAreRepaired()
    {
        PlanRequest request = randomFleetRequest(16, 3, 30);
        Flown flown(PolicyKind::Visitation);
        const Plan best = flown.plan(request);
        QVERIFY(!best.outcome.hintUsed);
        const Orders orders = ordersOf(best);
        for (std::size_t k = 0; k < 3; ++k)
            request.uavs[k].lastRest = orders[k];
        const Plan same = flown.plan(request, {.workLimit = 1});
        QVERIFY(same.outcome.hintUsed);
        QVERIFY(ordersOf(same) == orders);

        const IcebergIndex handed = orders[0].back();
        request.uavs[0].available[toIndex(nodeOf(request.ids, handed)) - 1] = false;
        request.uavs[1].lastRest.insert(request.uavs[1].lastRest.begin(), IcebergIndex(4711));
        const Plan repaired = flown.plan(request, {.workLimit = 1});
        QVERIFY(repaired.outcome.hintUsed);
        QCOMPARE(faultOf(request, repaired, false), QString());
        Orders rest = ordersOf(repaired);
        for (Ids& order : rest)
            std::erase(order, handed);
        Orders expected = orders;
        expected[0].pop_back();
        QVERIFY(rest == expected);
    }

    void progressIsInIds()
    {
        const PlanRequest request = withoutUav(randomFleetRequest(17, 3, 20), 1);
        for (const bool alone : {false, true}) {
            const PlanRequest asked = alone ? withoutUav(request, 2) : request;
            std::vector<SolveProgress> reports;
            SolveOptions options;
            options.onProgress = [&](const SolveProgress& report) { reports.push_back(report); };
            const Plan answer = Flown(PolicyKind::Visitation).plan(asked, options);
            QVERIFY(!reports.empty());
            for (const SolveProgress& report : reports) {
                Plan told = answer;
                for (std::size_t k = 0; k < 3; ++k)
                    told.uavs[k].order = report.orders.at(k);
                told.distance_m = lengthOf(asked, report.orders);
                QCOMPARE(faultOf(asked, told, false), QString());
            }
            QVERIFY(reports.back().orders == ordersOf(answer));
        }
    }

    void nothingUncertainMeansShortestPaths()
    {
        PlanRequest request = randomFleetRequest(18, 2, 6);
        std::ranges::fill(request.sigma_m2, 0.0);
        const double length_m = Flown(PolicyKind::Path).plan(request).distance_m;
        for (const PolicyKind kind : {PolicyKind::Visitation, PolicyKind::Latency})
            COMPARE_NEAR(Flown(kind).plan(request).distance_m, length_m, 1e-6);
    }
};

QTEST_APPLESS_MAIN(TestFleetPolicies)
#include "tst_fleet_policies.moc"
