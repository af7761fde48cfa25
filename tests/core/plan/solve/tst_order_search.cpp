#include "core/plan/solve/order_search.h"
#include "core/plan/solve/subset_solver.h"
#include "tests/support/plan/brute_force.h"
#include "tests/support/plan/problem_rows.h"

#include <QtTest>

using namespace berg;

class TestOrderSearch : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    /** Without any restart, the first orders are within a tenth of the optimum; then better. */
    void findsGoodOrders_data() { test::addProblemRows(); }
    void findsGoodOrders()
    {
        const TvpProblem problem = test::fetchedProblem(33, 16);
        const VisitCosts costs(problem);
        const double optimum = costs.total(SubsetSolver().solve(problem, {}).order());
        SearchEffort effort;
        OrderSearch search(costs, effort);
        std::vector<double> improvements;
        search.onImproved = [&](const VisitOrder& order) {
            improvements.push_back(costs.total(order));
        };
        search.startGreedily();
        search.descend();
        search.descendFromGreedyOrders();
        QVERIFY(isVisitOrder(problem, search.best()));
        QVERIFY(costs.total(search.best()) <= 1.1 * optimum);
        search.disturb(400); // ten times the usual number
        QVERIFY(costs.total(search.best()) <= optimum * (1 + 1e-9));
        QCOMPARE(improvements.back(), costs.total(search.best()));
        QVERIFY(std::is_sorted(improvements.rbegin(), improvements.rend()));
    }

    /** A descent ends where no move helps. */
    void ordersAreLocallyOptimal()
    {
        const VisitCosts costs(test::randomProblem(34, 60, 1, Route::Closed, true));
        SearchEffort effort;
        OrderSearch search(costs, effort);
        search.startGreedily();
        search.descend();
        const OrderMoves moves(costs, search.best());
        int improving = 0;
        for (int position = 1; position <= 60; ++position)
            improving += moves.bestMoveAt(position).delta < -1e-9 * costs.total(search.best());
        // Icebergs are not examined again while their neighbours stay: a few moves may be missed.
        QVERIFY2(improving <= 6, QByteArray::number(improving).constData());
    }

    void takesOnlyBetterOrders()
    {
        const VisitCosts costs(test::randomProblem(35, 12, 1, Route::Open));
        SearchEffort effort;
        OrderSearch search(costs, effort);
        QVERIFY(search.best().empty());
        VisitOrder order = ascendingOrder(12);
        search.accept(order);
        QVERIFY(search.best() == order);
        search.descend();
        const VisitOrder best = search.best();
        QVERIFY(costs.total(best) < costs.total(order));
        search.accept(order);
        search.startGreedily();
        QVERIFY(costs.total(search.best()) <= costs.total(best));
    }

    /** If its limit or a stop ends the search it keeps its result, and the limit repeats. */
    void keepsToTheEffort()
    {
        const TvpProblem problem = test::randomProblem(36, 40, 1, Route::Open);
        const VisitCosts costs(problem);
        double last = std::numeric_limits<double>::infinity();
        for (std::int64_t limit = 1; limit < 10'000'000; limit *= 3) {
            VisitOrder first;
            for (int repeat = 0; repeat < 2; ++repeat) {
                SearchEffort effort{.isStopped = {}, .limit = limit};
                OrderSearch search(costs, effort);
                search.startGreedily();
                search.descend();
                search.descendFromGreedyOrders();
                search.disturb(100'000);
                QVERIFY(isVisitOrder(problem, search.best()));
                QVERIFY(effort.spent());
                QVERIFY(effort.work < limit + 20'000); // one iceberg examined, and one greedy order
                QVERIFY(repeat == 0 || search.best() == first);
                first = search.best();
            }
            QVERIFY(costs.total(first) <= last * (1 + 1e-12));
            last = costs.total(first);
        }
        int asked = 0;
        SearchEffort effort{.isStopped = [&asked] { return ++asked > 20; }};
        OrderSearch search(costs, effort);
        search.startGreedily();
        search.disturb(100'000);
        QVERIFY(isVisitOrder(problem, search.best()));
        QVERIFY(asked < 30);
    }
};

QTEST_APPLESS_MAIN(TestOrderSearch)
#include "tst_order_search.moc"
