#include "core/plan/solve/reduced_model.h"
#include "tests/support/approx.h"
#include "tests/support/plan/brute_force.h"
#include "tests/support/plan/milp_checks.h"

#include <QRegularExpression>
#include <QtTest>

#include <algorithm>

using namespace berg;
using namespace berg::test;

namespace {

/** Returns whether every arc of the order has its column. */
bool holds(const MilpModel& milp, const VisitOrder& order)
{
    return decode(milp, encode(milp, order)) == order;
}

/** Returns the rounding of the cost that is never negative, sum(sigma t) + mu D. */
double roundingOf(const TvpProblem& problem, double objective)
{
    return 1e-12 * (std::abs(objective) + objectiveShift(problem));
}

} // namespace

class TestReducedModel : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    /** No order that is as good as the incumbent may lose an arc, ties included. */
    void keepsEveryOptimalOrder_data()
    {
        QTest::addColumn<TvpProblem>("problem");
        for (const double tau : {0.0, 0.25, 0.5, 1.0, 3.0, 10.0})
            for (const Route route : {Route::Open, Route::Closed})
                for (const bool asymmetric : {false, true})
                    QTest::addRow("tau %g, %s%s", tau, route == Route::Open ? "open" : "closed",
                                  asymmetric ? ", asymmetric" : "")
                        << randomProblem(21, 7, tau, route, asymmetric);
        TvpProblem problem = randomProblem(22, 6, 1, Route::Open);
        problem.distance_m.row(2) = problem.distance_m.row(1);
        problem.distance_m.col(2) = problem.distance_m.col(1);
        problem.sigma_m2[2] = problem.sigma_m2[1];
        QTest::newRow("two icebergs alike") << problem;
        problem.distance_m.setZero();
        QTest::newRow("all in one place") << problem;
        std::fill(problem.sigma_m2.begin() + 1, problem.sigma_m2.end(), 4.0);
        QTest::newRow("all alike") << problem;
        QTest::newRow("one iceberg") << randomProblem(23, 1, 1, Route::Open);
        QTest::newRow("two icebergs") << randomProblem(23, 2, 1, Route::Closed);
    }

    void keepsEveryOptimalOrder()
    {
        QFETCH(TvpProblem, problem);
        const ReducedModel reduced = reducedModel(problem, {});
        QVERIFY(isVisitOrder(problem, reduced.incumbent));
        const double best = bruteForce(problem).objective;
        VisitOrder order = ascendingOrder(problem.icebergCount());
        int optimal = 0;
        do {
            const double value = objective(problem, order);
            if (value > best + roundingOf(problem, best))
                continue;
            ++optimal;
            QVERIFY(holds(reduced.milp, order));
            COMPARE_NEAR(objectiveValue(reduced.milp, encode(reduced.milp, order)), value,
                         roundingOf(problem, value));
        } while (std::next_permutation(order.begin(), order.end()));
        QVERIFY(optimal >= 1);
    }

    void keepsTheIncumbent()
    {
        for (const int icebergs : {5, 12, 25, 40}) {
            const TvpProblem problem = randomProblem(31, icebergs, 0.5, Route::Open);
            const ReducedModel reduced = reducedModel(problem, {});
            QVERIFY(holds(reduced.milp, reduced.incumbent));
            QCOMPARE(violation(reduced.milp, encode(reduced.milp, reduced.incumbent)), 0.0);
        }
    }

    /**
     * All orders cost 0, so a relative margin has no effect: the remaining model must still be
     * solvable.
     */
    void withoutAnyCostTheIncumbentIsKept()
    {
        TvpProblem problem = randomProblem(32, 6, 0, Route::Open);
        std::fill(problem.sigma_m2.begin(), problem.sigma_m2.end(), 0.0);
        const ReducedModel reduced = reducedModel(problem, {});
        QVERIFY(holds(reduced.milp, reduced.incumbent));
    }

    /** CBC has more than one order to choose from, unless all are equally good. */
    void keepsMoreThanTheIncumbent()
    {
        for (const int icebergs : {2, 5, 12, 25, 40}) {
            const TvpProblem problem = randomProblem(33, icebergs, 0.5, Route::Open, true);
            const ReducedModel reduced = reducedModel(problem, {});
            QVERIFY(reduced.milp.columns.size() > static_cast<std::size_t>(icebergs));
        }
    }

    /** The purpose: a small part of the columns remains. */
    void keepsFewColumns()
    {
        for (const std::uint64_t seed : {1U, 2U, 3U}) {
            const TvpProblem problem = randomProblem(seed, 20, 0.5, Route::Open);
            const std::size_t all = positionModel(problem).columns.size();
            QVERIFY(reducedModel(problem, {}).milp.columns.size() < all / 30);
        }
    }

    void sameProblemSameModel()
    {
        const TvpProblem problem = randomProblem(41, 25, 1, Route::Closed, true);
        const ReducedModel first = reducedModel(problem, {});
        const ReducedModel again = reducedModel(problem, {});
        QVERIFY(first.incumbent == again.incumbent);
        QVERIFY(first.milp.arcs == again.milp.arcs);
    }

    void withoutTimeThereIsNoModel()
    {
        const TvpProblem problem = randomProblem(42, 12, 1, Route::Open);
        std::stop_source stop;
        stop.request_stop();
        SolveOptions options;
        options.stop = stop.get_token();
        QVERIFY(reducedModel(problem, options).milp.columns.empty());
    }
};

QTEST_APPLESS_MAIN(TestReducedModel)

#include "tst_reduced_model.moc"
