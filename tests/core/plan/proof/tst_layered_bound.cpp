#include "core/plan/proof/layered_bound.h"
#include "core/plan/solve/order_moves.h"
#include "core/plan/solve/subset_solver.h"
#include "tests/support/approx.h"
#include "tests/support/plan/hard_problems.h"

#include <QtTest>

#include <tuple>

using namespace berg;

namespace {

constexpr std::int64_t kPlenty = 500'000'000;

VisitOrder shuffled(int icebergs, std::uint64_t seed)
{
    VisitOrder order = ascendingOrder(icebergs);
    Random random(seed, 5);
    for (std::size_t k = order.size(); k > 1; --k)
        std::swap(order[k - 1], order[static_cast<std::size_t>(random.below(k))]);
    return order;
}

/** Returns the fault of a proof from a random order; empty if there is none. */
QString faultOfProof(const TvpProblem& problem, double optimum, int number)
{
    const VisitCosts costs(problem);
    const VisitOrder start = shuffled(problem.icebergCount(), static_cast<std::uint64_t>(number));
    BoundOptions options{.workLimit = kPlenty};
    LayeredBoundOptions layered;
    if (number % 2 == 1)
        layered.manyArcs = 0; // so that intermediate gaps are certified first
    double last = 0;
    bool monotone = true;
    options.onImproved = [&](const FleetPlan&, double bound) {
        monotone = monotone && bound >= last && bound <= optimum * (1 + 1e-12);
        last = bound;
    };
    const BoundResult result = improveBound(costs, start, options, layered);
    if (!isVisitOrder(problem, result.plan.front()))
        return QStringLiteral("no order");
    if (!result.reached)
        return QStringLiteral("not proven");
    if (!monotone || result.bound < last)
        return QStringLiteral("a bound that gets worse or is none");
    if (result.bound > optimum * (1 + 1e-12)) // rounding of sums in another order
        return QStringLiteral("bound above the optimum");
    if (std::abs(costs.total(result.plan.front()) - optimum) > 2e-9 * optimum)
        return QStringLiteral("not the optimum");
    if (result.bound < optimum * (1 - 3e-9))
        return QStringLiteral("reached, but the bound is not there");
    return {};
}

/** Returns whether all arcs of the order are there. */
bool runsOn(const std::vector<MilpArc>& arcs, const VisitOrder& order)
{
    const auto less = [](const MilpArc& a, const MilpArc& b) {
        return std::tie(a.position, a.from, a.to) < std::tie(b.position, b.from, b.to);
    };
    NodeIndex from;
    int position = 0;
    for (const NodeIndex to : order) {
        if (!std::binary_search(arcs.begin(), arcs.end(), MilpArc{from, to, ++position}, less))
            return false;
        from = to;
    }
    return true;
}

} // namespace

class TestLayeredBound : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    /** Tests the proof alone: no local search, a random order to start from; 1,080 problems. */
    void agreesWithTryingAllOrders_data()
    {
        QTest::addColumn<int>("icebergs");
        QTest::addColumn<int>("instances");
        for (int n = 1; n <= 8; ++n)
            QTest::addRow("%d icebergs", n) << n << (n == 8 ? 72 : 144);
    }

    void agreesWithTryingAllOrders()
    {
        QFETCH(int, icebergs);
        QFETCH(int, instances);
        for (int k = 0; k < instances; ++k) {
            const int number = k * 144 / instances;
            const TvpProblem problem = test::variedProblem(icebergs, number);
            const double optimum = test::bruteForce(problem).objective + objectiveShift(problem);
            QCOMPARE(faultOfProof(problem, optimum, number), QString());
        }
    }

    /** Tests sizes too large to try out all orders; 504 problems. */
    void agreesWithDynamicProgramming_data()
    {
        QTest::addColumn<int>("icebergs");
        for (int n = 9; n <= 15; ++n)
            QTest::addRow("%d icebergs", n) << n;
    }

    void agreesWithDynamicProgramming()
    {
        QFETCH(int, icebergs);
        for (int number = 0; number < 144; number += 2) {
            const int varied = number + number / 6 % 2; // all tau values, both kinds of proof
            const TvpProblem problem = test::variedProblem(icebergs, varied);
            const double optimum =
                VisitCosts(problem).total(SubsetSolver().solve(problem, {}).order());
            QCOMPARE(faultOfProof(problem, optimum, varied), QString());
        }
    }

    /**
     * Any multipliers give valid bounds and a proof; the final ones of an earlier call give a
     * quicker one.
     */
    void startsFromMultipliers()
    {
        const TvpProblem problem = test::randomProblem(6, 15, 1, Route::Open);
        const VisitCosts costs(problem);
        const BoundResult cold = improveBound(costs, ascendingOrder(15), {.workLimit = kPlenty});
        QVERIFY(cold.reached);
        QCOMPARE(cold.step.lambda.size(), Eigen::Index{16});
        QCOMPARE(cold.step.lambda(0), 0.0);
        LayeredBoundOptions layered{.lambda = cold.step.lambda};
        const BoundResult warm =
            improveBound(costs, cold.plan.front(), {.workLimit = kPlenty}, layered);
        QVERIFY(warm.reached);
        QVERIFY(warm.plan.front() == cold.plan.front());
        QVERIFY(warm.work < cold.work);

        Random random(7);
        for (double& value : *layered.lambda)
            value = random.uniform(-1, 1) * 1e4;
        const BoundResult rough =
            improveBound(costs, ascendingOrder(15), {.workLimit = kPlenty}, layered);
        QVERIFY(rough.reached);
        COMPARE_NEAR(rough.bound, cold.bound, 3e-9 * cold.bound);
    }

    /**
     * Suggestions are accepted if better, their work is counted, and they end with the work limit.
     */
    void takesSuggestions()
    {
        const TvpProblem problem = test::randomProblem(6, 13, 1, Route::Open);
        const VisitCosts costs(problem);
        const VisitOrder best = SubsetSolver().solve(problem, {}).order();
        int asked = 0;
        BoundOptions options{.gap = 1, .workLimit = kPlenty};
        options.suggest = [&](std::int64_t work, std::int64_t most) {
            ++asked;
            return Suggestion{{work + most == kPlenty ? best : ascendingOrder(13)}, 1000};
        };
        const BoundResult result = improveBound(costs, ascendingOrder(13), options);
        QCOMPARE(asked, 1); // before the gap is checked
        QVERIFY(result.plan.front() == best);
        QVERIFY(result.work > 1000);
    }

    /** Every order that costs no more than the given one stays, wherever deletion ends. */
    void survivingArcsKeepAllGoodOrders_data()
    {
        QTest::addColumn<int>("number");
        for (int number = 0; number < 144; number += 6)
            QTest::addRow("variant %d", number + number / 24) << number + number / 24;
    }

    void survivingArcsKeepAllGoodOrders()
    {
        QFETCH(int, number);
        const TvpProblem problem = test::variedProblem(6, number);
        const VisitCosts costs(problem);
        const VisitOrder optimal = test::bruteForce(problem).order;
        for (const VisitOrder& given : {optimal, shuffled(6, 1), ascendingOrder(6)})
            for (const std::int64_t limit : {std::int64_t{0}, std::int64_t{20'000}, kPlenty}) {
                const std::vector<MilpArc> arcs = survivingArcs(costs, given, {.workLimit = limit});
                VisitOrder order = ascendingOrder(6);
                do
                    QVERIFY(costs.total(order) > costs.total(given) || runsOn(arcs, order));
                while (std::next_permutation(order.begin(), order.end()));
            }
    }

    /** The purpose: few arcs remain when the order is optimal. */
    void fewArcsSurvive()
    {
        const TvpProblem problem = test::randomProblem(8, 15, 1, Route::Open);
        const VisitCosts costs(problem);
        const VisitOrder best = SubsetSolver().solve(problem, {}).order();
        const std::vector<MilpArc> arcs = survivingArcs(costs, best, {.workLimit = kPlenty});
        QVERIFY(runsOn(arcs, best));
        QVERIFY(arcs.size() <= 100); // of 2955
        const std::vector<MilpArc> stoppedArcs =
            survivingArcs(costs, best, {.workLimit = kPlenty, .isStopped = [] { return true; }});
        QVERIFY(runsOn(stoppedArcs, best));
    }

    void equalCostsAreProvenToo()
    {
        TvpProblem problem = test::randomProblem(1, 9, 1, Route::Closed);
        problem.distance_m.setConstant(1000);
        std::fill(problem.sigma_m2.begin() + 1, problem.sigma_m2.end(), 3.0);
        const VisitCosts costs(problem);
        const BoundResult result = improveBound(costs, ascendingOrder(9), {.workLimit = kPlenty});
        QVERIFY(result.reached);
        COMPARE_NEAR(result.bound, costs.total(ascendingOrder(9)), 1e-8 * result.bound);
    }

    void stopsAtTheRequestedGap()
    {
        const TvpProblem problem = test::randomProblem(2, 14, 1, Route::Open);
        const VisitCosts costs(problem);
        const double optimum = costs.total(SubsetSolver().solve(problem, {}).order());
        for (const double gap : {0.3, 0.05, 0.01}) {
            const BoundResult result =
                improveBound(costs, ascendingOrder(14), {.gap = gap, .workLimit = kPlenty});
            const double cost = costs.total(result.plan.front());
            QVERIFY(result.reached);
            QVERIFY(result.bound >= cost * (1 - gap) * (1 - 1e-12));
            QVERIFY(result.bound <= optimum * (1 + 1e-12));
        }
    }

    /** Whenever the work ends, the result is valid, and more work gives no worse bound. */
    void anyWorkLimitLeavesABound()
    {
        const TvpProblem problem = test::randomProblem(3, 14, 3, Route::Closed);
        const VisitCosts costs(problem);
        const double optimum = costs.total(SubsetSolver().solve(problem, {}).order());
        double last = 0;
        for (const std::int64_t limit : {0, 1, 10'000, 100'000, 200'000, 1'000'000, 50'000'000}) {
            const BoundResult result =
                improveBound(costs, ascendingOrder(14), {.workLimit = limit});
            QVERIFY(isVisitOrder(problem, result.plan.front()));
            QVERIFY(result.bound >= last);
            QVERIFY(result.bound <= optimum * (1 + 1e-12));
            QVERIFY(result.work >= std::min<std::int64_t>(limit, 1) || result.reached);
            last = result.bound;
        }
        COMPARE_NEAR(last, optimum, 3e-9 * optimum);
    }

    void anyStopLeavesABound()
    {
        const TvpProblem problem = test::randomProblem(3, 14, 3, Route::Closed);
        const VisitCosts costs(problem);
        const double optimum = costs.total(SubsetSolver().solve(problem, {}).order());
        int allowed = 0;
        for (bool reached = false; !reached; allowed = 2 * allowed + 1) {
            int asked = 0;
            const BoundResult result = improveBound(
                costs, ascendingOrder(14),
                {.workLimit = kPlenty, .isStopped = [&] { return asked++ >= allowed; }});
            QVERIFY(isVisitOrder(problem, result.plan.front()));
            QVERIFY(result.bound <= optimum * (1 + 1e-12));
            reached = result.reached;
            QVERIFY(reached || asked > allowed);
        }
        QVERIFY(allowed > 100); // the check is called often
    }

    void reportsGetBetter()
    {
        const TvpProblem problem = test::randomProblem(4, 16, 1, Route::Open);
        const VisitCosts costs(problem);
        double cost = costs.total(ascendingOrder(16));
        double bound = 0;
        int reports = 0;
        BoundOptions options{.workLimit = kPlenty};
        options.onImproved = [&](const FleetPlan& plan, double newBound) {
            const VisitOrder& order = plan.front();
            ++reports;
            if (costs.total(order) > cost || newBound < bound)
                reports = -1000;
            cost = costs.total(order);
            bound = newBound;
        };
        const BoundResult result = improveBound(costs, ascendingOrder(16), options);
        QVERIFY(reports > 0);
        QVERIFY(costs.total(result.plan.front()) <= cost);
        QVERIFY(result.bound >= bound);
    }

    /**
     * With too many icebergs for the memory sets only the relaxation without memory is computed.
     */
    void boundsLargeProblems()
    {
        const TvpProblem problem = test::randomProblem(5, 140, 1, Route::Open);
        const VisitCosts costs(problem);
        const BoundResult result =
            improveBound(costs, ascendingOrder(140), {.workLimit = 100'000'000});
        QVERIFY(!result.reached);
        // No order can avoid each iceberg's shortest leg.
        double shortestLegs = 0;
        for (const NodeIndex j : icebergNodes(140)) {
            double shortest = costs.leg(0, j);
            for (const NodeIndex i : icebergNodes(140))
                if (i != j)
                    shortest = std::min(shortest, costs.leg(i, j));
            shortestLegs += shortest;
        }
        double waiting = 0;
        std::vector<double> sorted(problem.sigma_m2.begin() + 1, problem.sigma_m2.end());
        std::sort(sorted.begin(), sorted.end(), std::greater<>());
        for (std::size_t k = 0; k < sorted.size(); ++k)
            waiting += sorted[k] * static_cast<double>(k + 2);
        QVERIFY(result.bound > shortestLegs + waiting);
        QVERIFY(result.bound < costs.total(sigmaOrder(problem)));
    }
};

QTEST_APPLESS_MAIN(TestLayeredBound)
#include "tst_layered_bound.moc"
