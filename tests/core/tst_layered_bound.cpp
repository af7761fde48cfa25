#include "core/plan/exact_solver.h"
#include "core/plan/layered_bound.h"
#include "tests/support/approx.h"
#include "tests/support/brute_force.h"

#include <QtTest>

using namespace berg;

namespace {

constexpr std::int64_t kPlenty = 500'000'000;

VisitOrder ascending(int icebergs)
{
    VisitOrder order(static_cast<std::size_t>(icebergs));
    std::iota(order.begin(), order.end(), 1);
    return order;
}

/** Sigmas and distances made of thirds: nothing that an integer hides. */
void makeReal(TvpProblem& problem)
{
    Random random(9);
    for (std::size_t i = 1; i < problem.sigma_m2.size(); ++i)
        problem.sigma_m2[i] *= random.uniform(0.1, 1);
}

} // namespace

class TestLayeredBound : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    /**
     * The proof on its own: no local search, the worst of starting orders. Every bound must be
     * below the optimum of the dynamic programme, every claim of optimality true.
     */
    void provesTheOptimumFromABadStart_data()
    {
        QTest::addColumn<int>("icebergs");
        QTest::addColumn<bool>("closed");
        QTest::addColumn<bool>("asymmetric");
        QTest::addColumn<bool>("real");
        for (int n = 1; n <= 14; ++n)
            for (int kind = 0; kind < 8; ++kind)
                QTest::addRow("%d icebergs, %s, %s, %s", n, kind & 1 ? "closed" : "open",
                              kind & 2 ? "asymmetric" : "symmetric", kind & 4 ? "real" : "integer")
                    << n << (kind % 2 == 1) << (kind / 2 % 2 == 1) << (kind / 4 == 1);
    }

    void provesTheOptimumFromABadStart()
    {
        QFETCH(int, icebergs);
        QFETCH(bool, closed);
        QFETCH(bool, asymmetric);
        QFETCH(bool, real);
        for (const double tau : {0.2, 1.0, 5.0})
            for (std::uint64_t seed = 1; seed <= 3; ++seed) {
                TvpProblem problem = test::randomProblem(
                    seed, icebergs, tau, closed ? Route::Closed : Route::Open, asymmetric);
                if (real)
                    makeReal(problem);
                const VisitCosts costs(problem);
                const double optimum = costs.total(ExactSolver().solve(problem, {}).order);
                const BoundResult result =
                    improveBound(costs, ascending(icebergs), {.workLimit = kPlenty});
                QVERIFY(isVisitOrder(problem, result.order));
                // 1e-12: rounding of sums in another order.
                QVERIFY(result.bound <= optimum * (1 + 1e-12));
                QVERIFY(result.reached);
                COMPARE_NEAR(costs.total(result.order), optimum, 2e-9 * optimum);
                COMPARE_NEAR(result.bound, optimum, 3e-9 * optimum);
            }
    }

    void equalCostsAreProvenToo()
    {
        TvpProblem problem = test::randomProblem(1, 9, 1, Route::Closed);
        problem.distance_m.setConstant(1000);
        std::fill(problem.sigma_m2.begin() + 1, problem.sigma_m2.end(), 3.0);
        const VisitCosts costs(problem);
        const BoundResult result = improveBound(costs, ascending(9), {.workLimit = kPlenty});
        QVERIFY(result.reached);
        COMPARE_NEAR(result.bound, costs.total(ascending(9)), 1e-8 * result.bound);
    }

    void stopsAtTheGapAskedFor()
    {
        const TvpProblem problem = test::randomProblem(2, 14, 1, Route::Open);
        const VisitCosts costs(problem);
        const double optimum = costs.total(ExactSolver().solve(problem, {}).order);
        for (const double gap : {0.3, 0.05, 0.01}) {
            const BoundResult result =
                improveBound(costs, ascending(14), {.gap = gap, .workLimit = kPlenty});
            const double cost = costs.total(result.order);
            QVERIFY(result.reached);
            QVERIFY(result.bound >= cost * (1 - gap) * (1 - 1e-12));
            QVERIFY(result.bound <= optimum * (1 + 1e-12));
        }
    }

    /** Whenever it is stopped, what it holds is valid, and more work gives no worse bound. */
    void anyWorkLimitLeavesABound()
    {
        const TvpProblem problem = test::randomProblem(3, 14, 3, Route::Closed);
        const VisitCosts costs(problem);
        const double optimum = costs.total(ExactSolver().solve(problem, {}).order);
        double last = 0;
        for (const std::int64_t limit : {0, 1, 10'000, 100'000, 200'000, 1'000'000, 50'000'000}) {
            const BoundResult result = improveBound(costs, ascending(14), {.workLimit = limit});
            QVERIFY(isVisitOrder(problem, result.order));
            QVERIFY(result.bound >= last);
            QVERIFY(result.bound <= optimum * (1 + 1e-12));
            QVERIFY(result.work >= std::min<std::int64_t>(limit, 1) || result.reached);
            last = result.bound;
        }
        COMPARE_NEAR(last, optimum, 3e-9 * optimum);
    }

    void anyCutLeavesABound()
    {
        const TvpProblem problem = test::randomProblem(3, 14, 3, Route::Closed);
        const VisitCosts costs(problem);
        const double optimum = costs.total(ExactSolver().solve(problem, {}).order);
        int allowed = 0;
        for (bool reached = false; !reached; allowed = 2 * allowed + 1) {
            int asked = 0;
            const BoundResult result =
                improveBound(costs, ascending(14),
                             {.workLimit = kPlenty, .cut = [&] { return asked++ >= allowed; }});
            QVERIFY(isVisitOrder(problem, result.order));
            QVERIFY(result.bound <= optimum * (1 + 1e-12));
            reached = result.reached;
            QVERIFY(reached || asked > allowed);
        }
        QVERIFY(allowed > 100); // it is asked often
    }

    void reportsGetBetter()
    {
        const TvpProblem problem = test::randomProblem(4, 16, 1, Route::Open);
        const VisitCosts costs(problem);
        double cost = costs.total(ascending(16));
        double bound = 0;
        int reports = 0;
        BoundOptions options{.workLimit = kPlenty};
        options.onImproved = [&](const VisitOrder& order, double newBound) {
            ++reports;
            if (costs.total(order) > cost || newBound < bound)
                reports = -1000;
            cost = costs.total(order);
            bound = newBound;
        };
        const BoundResult result = improveBound(costs, ascending(16), options);
        QVERIFY(reports > 0);
        QVERIFY(costs.total(result.order) <= cost);
        QVERIFY(result.bound >= bound);
    }

    /** Too many icebergs for the memory sets: the relaxation without memory only. */
    void boundsLargeProblems()
    {
        const TvpProblem problem = test::randomProblem(5, 140, 1, Route::Open);
        const VisitCosts costs(problem);
        const BoundResult result = improveBound(costs, ascending(140), {.workLimit = 100'000'000});
        QVERIFY(!result.reached);
        // The largest cost that an order cannot avoid: each iceberg's shortest leg.
        double shortestLegs = 0;
        for (int j = 1; j <= 140; ++j) {
            double shortest = costs.leg(0, j);
            for (int i = 1; i <= 140; ++i)
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
