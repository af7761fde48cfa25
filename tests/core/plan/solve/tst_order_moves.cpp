#include "core/plan/solve/order_moves.h"
#include "tests/support/approx.h"
#include "tests/support/plan/brute_force.h"

#include <QtTest>

using namespace berg;

namespace {

/** Costs are some hundreds, so that rounding of sums and prefix sums stays far below this. */
constexpr double kRounding = 1e-9;

VisitOrder shuffled(Random& random, int icebergs)
{
    VisitOrder order = ascendingOrder(icebergs);
    for (std::size_t k = order.size(); k > 1; --k)
        std::swap(order[k - 1], order[random.below(k)]);
    return order;
}

/** All moves that exist for n icebergs, pieces of any length. */
std::vector<OrderMove> allMoves(const OrderMoves<VisitCosts>& moves)
{
    using Kind = OrderMove::Kind;
    const int n = moves.icebergs();
    std::vector<OrderMove> all;
    const auto add = [&all](OrderMove move, double delta) {
        move.delta = delta;
        all.push_back(move);
    };
    for (int a = 1; a <= n; ++a)
        for (int b = a; b <= n; ++b) {
            if (b > a) {
                add({.kind = Kind::Reverse, .first = a, .last = b}, moves.reversal(a, b));
                add({.kind = Kind::Exchange, .first = a, .last = b}, moves.exchange(a, b));
            }
            for (int after = 0; after <= n; ++after)
                for (const bool turned : {false, true})
                    if (after < a - 1 || after > b)
                        add({.kind = Kind::Relocate,
                             .first = a,
                             .last = b,
                             .after = after,
                             .turned = turned},
                            moves.relocation(a, b, after, turned));
        }
    return all;
}

} // namespace

class TestOrderMoves : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void problems_data()
    {
        QTest::addColumn<bool>("closed");
        QTest::addColumn<bool>("asymmetric");
        for (const bool closed : {false, true})
            for (const bool asymmetric : {false, true})
                QTest::addRow("%s, %s", closed ? "closed" : "open",
                              asymmetric ? "asymmetric" : "symmetric")
                    << closed << asymmetric;
    }

    void totalIsTheShiftedObjective_data() { problems_data(); }
    void totalIsTheShiftedObjective()
    {
        const TvpProblem problem = fetched(9);
        const VisitCosts costs(problem);
        Random random(5);
        for (int k = 0; k < 20; ++k) {
            const VisitOrder order = shuffled(random, 9);
            const double expected = objective(problem, order) + objectiveShift(problem);
            COMPARE_NEAR(costs.total(order), expected, kRounding);
            COMPARE_NEAR(OrderMoves(costs, order).cost(), expected, kRounding);
        }
    }

    /** Every delta is the difference of the costs before and after, computed independently. */
    void deltasAreDifferencesOfCost_data() { problems_data(); }
    void deltasAreDifferencesOfCost()
    {
        const TvpProblem problem = fetched(7);
        const VisitCosts costs(problem);
        Random random(6);
        const VisitOrder order = shuffled(random, 7);
        const OrderMoves start(costs, order);
        const std::vector<OrderMove> all = allMoves(start);
        QVERIFY(all.size() > 200);
        for (const OrderMove& move : all) {
            OrderMoves changed(costs, order);
            changed.apply(move);
            QVERIFY(isVisitOrder(problem, changed.order()));
            QVERIFY(changed.order() != order || move.kind == OrderMove::Kind::Relocate);
            COMPARE_NEAR(costs.total(changed.order()) - costs.total(order), move.delta, kRounding);
            COMPARE_NEAR(changed.cost(), costs.total(changed.order()), kRounding);
            for (int p = 1; p <= 7; ++p)
                QCOMPARE(changed.positionOf(changed.at(p)), p);
        }
    }

    /** Finds the best move among those with an end of the piece, or a partner, at the position. */
    void findsTheBestMove_data() { problems_data(); }
    void findsTheBestMove()
    {
        const TvpProblem problem = fetched(8);
        const VisitCosts costs(problem);
        Random random(7);
        for (int k = 0; k < 10; ++k) {
            const OrderMoves moves(costs, shuffled(random, 8));
            for (int position = 1; position <= 8; ++position) {
                double least = 0;
                for (const OrderMove& move : allMoves(moves)) {
                    const bool relocate = move.kind == OrderMove::Kind::Relocate;
                    const bool mine = relocate ? move.first == position && move.last < position + 3
                                               : move.first == position || move.last == position;
                    const bool turnedSingle = relocate && move.turned && move.first == move.last;
                    if (mine && !turnedSingle)
                        least = std::min(least, move.delta);
                }
                COMPARE_NEAR(moves.bestMoveAt(position).delta, least, kRounding);
            }
        }
    }

    void knowsWhatEachMoveDoes_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<std::vector<int>>("numbers"); // first, last, after, turned
        QTest::addColumn<VisitOrder>("result");
        using Kind = OrderMove::Kind;
        const auto row = [](const char* name, Kind kind, std::vector<int> numbers,
                            VisitOrder result) {
            QTest::newRow(name) << static_cast<int>(kind) << numbers << result;
        };
        row("none", Kind::None, {0, 0, 0, 0}, {1, 2, 3, 4, 5});
        row("reverse", Kind::Reverse, {2, 4, 0, 0}, {1, 4, 3, 2, 5});
        row("exchange", Kind::Exchange, {1, 4, 0, 0}, {4, 2, 3, 1, 5});
        row("back", Kind::Relocate, {1, 2, 4, 0}, {3, 4, 1, 2, 5});
        row("back, turned", Kind::Relocate, {1, 2, 4, 1}, {3, 4, 2, 1, 5});
        row("front", Kind::Relocate, {4, 5, 0, 0}, {4, 5, 1, 2, 3});
        row("front, turned", Kind::Relocate, {4, 5, 1, 1}, {1, 5, 4, 2, 3});
    }

    void knowsWhatEachMoveDoes()
    {
        QFETCH(int, kind);
        QFETCH(std::vector<int>, numbers);
        QFETCH(VisitOrder, result);
        const VisitCosts costs(test::randomProblem(1, 5, 1, Route::Open));
        OrderMoves moves(costs, VisitOrder{1, 2, 3, 4, 5});
        moves.apply({.kind = static_cast<OrderMove::Kind>(kind),
                     .first = numbers[0],
                     .last = numbers[1],
                     .after = numbers[2],
                     .turned = numbers[3] != 0});
        QVERIFY(moves.order() == result);
    }

    /** The diagonal of a problem may hold anything; the return leg is free on open routes. */
    void legsHoldWhatIsFlown()
    {
        TvpProblem problem = test::randomProblem(2, 4, 1, Route::Open);
        problem.distance_m.diagonal().setConstant(std::numeric_limits<double>::quiet_NaN());
        const VisitCosts open(problem);
        QVERIFY(open.legs.allFinite());
        QCOMPARE(open.leg(3, 0), 0.0);
        QCOMPARE(open.leg(1, 3), problem.mu * problem.distance_m(1, 3));
        problem.route = Route::Closed;
        QCOMPARE(VisitCosts(problem).leg(3, 0), problem.mu * problem.distance_m(3, 0));
        QCOMPARE(open.visit(2, 3), problem.sigma_m2[2] * 4);
    }

    void sortsBySigmaThenDistanceThenNumber()
    {
        TvpProblem problem{.distance_m = Eigen::MatrixXd::Zero(6, 6),
                           .sigma_m2 = {0, 2, 7, 2, 2, 0},
                           .mu = 0,
                           .route = Route::Open};
        problem.distance_m.row(0) << 0, 50, 90, 40, 50, 1;
        QVERIFY((sigmaOrder(problem) == VisitOrder{2, 3, 1, 4, 5}));
    }

private:
    static TvpProblem fetched(int icebergs)
    {
        QFETCH(bool, closed);
        QFETCH(bool, asymmetric);
        return test::randomProblem(11, icebergs, 1, closed ? Route::Closed : Route::Open,
                                   asymmetric);
    }
};

QTEST_APPLESS_MAIN(TestOrderMoves)
#include "tst_order_moves.moc"
