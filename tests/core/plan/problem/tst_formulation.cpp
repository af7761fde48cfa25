#include "core/plan/problem/formulation.h"
#include "tests/support/approx.h"
#include "tests/support/plan/brute_force.h"
#include "tests/support/plan/milp_checks.h"

#include <QRegularExpression>

#include <algorithm>
#include <set>
#include <stdexcept>

using namespace berg;
using namespace berg::test;

namespace {

/** Sums of at most a hundred products of the size of a cost: rounding only. */
double roundingOf(const TvpProblem& problem, double objective)
{
    return 1e-12 * (std::abs(objective) + objectiveShift(problem) + 1);
}

MilpModel modelOf(bool printed, const TvpProblem& problem)
{
    return printed ? printedModel(problem) : positionModel(problem);
}

VisitOrder randomOrder(Random& random, int icebergs)
{
    VisitOrder order = ascendingOrder(icebergs);
    for (std::size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[random.below(i)]);
    return order;
}

/** Calls `visit` with every point whose columns take integers between their bounds. */
template <typename Visit>
void forEachIntegerPoint(const MilpModel& model, const Visit& visit)
{
    std::vector<double> point;
    for (const MilpColumn& column : model.columns)
        point.push_back(column.lower);
    for (;;) {
        visit(point);
        std::size_t c = 0;
        while (c < point.size() && point[c] == model.columns[c].upper) {
            point[c] = model.columns[c].lower;
            ++c;
        }
        if (c == point.size())
            return;
        point[c] += 1;
    }
}

void addModels()
{
    QTest::addColumn<bool>("printed");
    QTest::addColumn<Route>("route");
    QTest::newRow("printed, open") << true << Route::Open;
    QTest::newRow("printed, closed") << true << Route::Closed;
    QTest::newRow("position, open") << false << Route::Open;
    QTest::newRow("position, closed") << false << Route::Closed;
}

} // namespace

class TestFormulation : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void ordersAreFeasibleAndCostTheirObjective_data() { addModels(); }

    void ordersAreFeasibleAndCostTheirObjective()
    {
        QFETCH(bool, printed);
        QFETCH(Route, route);
        Random random(4);
        for (const int icebergs : {1, 2, 3, 5, 9}) {
            const TvpProblem problem = randomProblem(random.bits(), icebergs, 1.3, route, true);
            const MilpModel model = modelOf(printed, problem);
            for (int repeat = 0; repeat < 20; ++repeat) {
                const VisitOrder order = randomOrder(random, icebergs);
                const std::vector<double> solution = encode(model, order);
                QCOMPARE(violation(model, solution), 0.0); // whole numbers: exact
                const double expected = costByVisitingNumbers(problem, order);
                COMPARE_NEAR(objectiveValue(model, solution), expected,
                             roundingOf(problem, expected));
                QVERIFY(decode(model, solution) == order);
            }
        }
    }

    /** There is no self-loop, no subtour, no repeated position: only the n! orders are feasible. */
    void onlyOrdersAreFeasible_data()
    {
        QTest::addColumn<bool>("printed");
        QTest::addColumn<Route>("route");
        QTest::addColumn<int>("icebergs");
        for (const int icebergs : {1, 2, 3})
            for (const bool printed : {true, false})
                for (const Route route : {Route::Open, Route::Closed})
                    QTest::addRow("%s, %s, %d icebergs", printed ? "printed" : "position",
                                  route == Route::Open ? "open" : "closed", icebergs)
                        << printed << route << icebergs;
    }

    void onlyOrdersAreFeasible()
    {
        QFETCH(bool, printed);
        QFETCH(Route, route);
        QFETCH(int, icebergs);
        const TvpProblem problem = randomProblem(12, icebergs, 0.8, route, true);
        const MilpModel model = modelOf(printed, problem);
        std::set<VisitOrder> found;
        int feasiblePoints = 0;
        double best = kMilpInfinity;
        bool costsAgree = true;
        forEachIntegerPoint(model, [&](const std::vector<double>& point) {
            if (violation(model, point) > 0)
                return;
            ++feasiblePoints;
            const VisitOrder order = decode(model, point);
            found.insert(order);
            const double value = objectiveValue(model, point);
            best = std::min(best, value);
            costsAgree = costsAgree && isVisitOrder(problem, order) &&
                         std::abs(value - objective(problem, order)) <= roundingOf(problem, value);
        });
        const int orders = icebergs == 3 ? 6 : icebergs;
        QCOMPARE(feasiblePoints, orders);
        QCOMPARE(static_cast<int>(found.size()), orders);
        QVERIFY(costsAgree);
        COMPARE_NEAR(best, bruteForce(problem).objective, roundingOf(problem, best));
    }

    void modelsHaveTheirSizes()
    {
        const TvpProblem problem = randomProblem(1, 20, 1, Route::Open);
        QCOMPARE(printedModel(problem).columns.size(), std::size_t{21 * 21 + 21});
        QCOMPARE(positionModel(problem).columns.size(), std::size_t{20 + 19 * 20 * 19});
    }

    /** With the arcs of two orders, only those two are feasible. */
    void fewerArcsFewerOrders()
    {
        const TvpProblem problem = randomProblem(2, 4, 1, Route::Closed);
        const std::vector<MilpArc> arcs{{0, 1, 1}, {1, 2, 2}, {2, 3, 3}, {3, 4, 4},
                                        {1, 3, 2}, {3, 2, 3}, {2, 4, 4}};
        const MilpModel model = positionModel(problem, arcs);
        QCOMPARE(model.columns.size(), arcs.size());
        std::set<VisitOrder> found;
        forEachIntegerPoint(model, [&](const std::vector<double>& point) {
            if (violation(model, point) == 0)
                found.insert(decode(model, point));
        });
        QVERIFY((found == std::set<VisitOrder>{{1, 2, 3, 4}, {1, 3, 2, 4}}));
        for (const VisitOrder& order : found)
            COMPARE_NEAR(objectiveValue(model, encode(model, order)), objective(problem, order),
                         roundingOf(problem, 0));
        // An order that flies another arc loses it.
        QVERIFY(decode(model, encode(model, VisitOrder{4, 3, 2, 1})).empty());
    }

    void printedRowsFollowThePaper()
    {
        const TvpProblem problem = randomProblem(1, 4, 1, Route::Open);
        const MilpModel open = printedModel(problem);
        // N rows each of (3) and (4), one of (5), (9) for N (N - 1) arcs.
        QCOMPARE(open.rows.size(), std::size_t{5 + 5 + 1 + 5 * 4});
        TvpProblem closedProblem = problem;
        closedProblem.route = Route::Closed;
        const MilpModel closed = printedModel(closedProblem);
        // (5) dropped, and (9) without the N - 1 arcs to the UAV.
        QCOMPARE(closed.rows.size(), std::size_t{5 + 5 + 4 * 4});
        QCOMPARE(open.rows.front().lower, -kMilpInfinity);
        QCOMPARE(closed.rows.front().lower, 1.0);
        const MilpColumn& uav = open.columns[open.arcs.size()];
        QCOMPARE(uav.lower, 1.0); // Eq. (6)
        QCOMPARE(uav.upper, 1.0);
    }

    void wrongSolutionsDecodeToNothing_data() { addModels(); }

    void wrongSolutionsDecodeToNothing()
    {
        QFETCH(bool, printed);
        QFETCH(Route, route);
        const TvpProblem problem = randomProblem(3, 4, 1, route);
        const MilpModel model = modelOf(printed, problem);
        const std::vector<double> nothing(model.columns.size(), 0.0);
        QVERIFY(decode(model, nothing).empty());

        // The arcs are 0 -> 1 -> 2 and, separately, 3 -> 4 -> 3.
        std::vector<double> subtour = nothing;
        for (std::size_t c = 0; c < model.arcs.size(); ++c) {
            const int arc = 10 * model.arcs[c].from.number() + model.arcs[c].to.number();
            if (arc == 1 || arc == 12 || arc == 34 || arc == 43)
                subtour[c] = 1;
        }
        QVERIFY(decode(model, subtour).empty());
        QVERIFY(violation(model, subtour) >= 1);
    }

    void misuseIsABug()
    {
        const TvpProblem alone{
            .distance_m = Eigen::MatrixXd::Zero(1, 1), .sigma_m2 = {0.0}, .mu = 1};
        QVERIFY_THROWS_EXCEPTION(std::logic_error, static_cast<void>(positionModel(alone)));
        QVERIFY_THROWS_EXCEPTION(std::logic_error, static_cast<void>(printedModel(alone)));
        const MilpModel model = positionModel(randomProblem(1, 3, 1, Route::Open));
        const std::vector<double> tooShort(3, 0.0);
        QVERIFY_THROWS_EXCEPTION(std::logic_error, static_cast<void>(decode(model, tooShort)));
        QVERIFY_THROWS_EXCEPTION(std::logic_error,
                                 static_cast<void>(encode(model, ascendingOrder(2))));
    }
};

QTEST_APPLESS_MAIN(TestFormulation)

#include "tst_formulation.moc"
