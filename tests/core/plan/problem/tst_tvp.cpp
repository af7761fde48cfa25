#include "core/plan/problem/tvp.h"
#include "tests/support/approx.h"
#include "tests/support/expect_error.h"
#include "tests/support/plan/brute_force.h"

#include <QtTest>

#include <limits>
#include <stdexcept>

using namespace berg;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/** Three icebergs, asymmetric; all expected values below are worked out by hand. */
TvpProblem handProblem(Route route)
{
    TvpProblem problem{
        .distance_m = Eigen::MatrixXd(4, 4), .sigma_m2 = {0, 2, 5, 3}, .mu = 0.5, .route = route};
    problem.distance_m << 0, 10, 20, 30, //
        11, 0, 12, 13,                   //
        21, 22, 0, 23,                   //
        31, 32, 33, 0;
    return problem;
}

const VisitOrder kOrder{2, 3, 1};

} // namespace

class TestTvp : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void nodesAndTheirNumbers()
    {
        QVERIFY(nodesOf(std::vector{2, 3, 1}) == kOrder);
        QVERIFY(numbersOf(kOrder) == (std::vector{2, 3, 1}));
        QVERIFY(ascendingOrder(3) == (VisitOrder{1, 2, 3}));
        QVERIFY(ascendingOrder(0).empty());
        for (const int icebergs : {0, -1}) // a problem without nodes has -1 icebergs
            for (const NodeIndex node : icebergNodes(icebergs))
                QFAIL(qPrintable(QString::number(node.number())));
    }

    void recognisesOrders_data()
    {
        QTest::addColumn<VisitOrder>("order");
        QTest::addColumn<bool>("valid");
        QTest::newRow("ascending") << VisitOrder{1, 2, 3} << true;
        QTest::newRow("any permutation") << kOrder << true;
        QTest::newRow("empty") << VisitOrder{} << false;
        QTest::newRow("too short") << VisitOrder{1, 2} << false;
        QTest::newRow("too long") << VisitOrder{1, 2, 3, 1} << false;
        QTest::newRow("twice") << VisitOrder{1, 2, 2} << false;
        QTest::newRow("the UAV") << VisitOrder{0, 1, 2} << false;
        QTest::newRow("out of range") << VisitOrder{1, 2, 4} << false;
        QTest::newRow("negative") << VisitOrder{1, 2, -3} << false;
    }

    void recognisesOrders()
    {
        QFETCH(VisitOrder, order);
        QFETCH(bool, valid);
        const TvpProblem problem = handProblem(Route::Open);
        QCOMPARE(isVisitOrder(problem, order), valid);
        if (!valid)
            QVERIFY_THROWS_EXCEPTION(std::logic_error, (void)objective(problem, order));
    }

    void scoresByHand_data()
    {
        QTest::addColumn<bool>("closed");
        QTest::addColumn<double>("distance_m");
        QTest::addColumn<double>("F");
        // 20 + 23 + 32; back 11. t = 2, 3, 4 of N = 4: reward 5 * 2 + 3 * 1 + 2 * 0 = 13.
        QTest::newRow("open") << false << 75.0 << 0.5 * 75 - 13;
        QTest::newRow("closed") << true << 86.0 << 0.5 * 86 - 13;
    }

    void scoresByHand()
    {
        QFETCH(bool, closed);
        QFETCH(double, distance_m);
        QFETCH(double, F);
        const TvpProblem problem = handProblem(closed ? Route::Closed : Route::Open);
        // Small integers and halves: exact in floating point.
        QCOMPARE(flownDistance(problem, kOrder), distance_m);
        QCOMPARE(uncertaintyReward(problem, kOrder), 13.0);
        QCOMPARE(objective(problem, kOrder), F);
        // sum sigma t = 5 * 2 + 3 * 3 + 2 * 4 = 27.
        QCOMPARE(objectiveShift(problem), 40.0);
        QCOMPARE(objective(problem, kOrder) + objectiveShift(problem), 27 + 0.5 * distance_m);
    }

    void withoutIcebergsAllIsZero()
    {
        const TvpProblem problem{.distance_m = Eigen::MatrixXd::Zero(1, 1),
                                 .sigma_m2 = {0},
                                 .mu = 1,
                                 .route = Route::Closed};
        QCOMPARE(problem.icebergCount(), 0);
        QVERIFY(isVisitOrder(problem, VisitOrder{}));
        QCOMPARE(flownDistance(problem, VisitOrder{}), 0.0);
        QCOMPARE(objective(problem, VisitOrder{}), 0.0);
        QCOMPARE(relativeGap(problem, 0, -1), 0.0);
    }

    /** Compares the objective with an independently written formula, over all orders. */
    void objectiveAgreesWithVisitingNumbers_data()
    {
        QTest::addColumn<bool>("closed");
        QTest::addColumn<bool>("asymmetric");
        for (const bool closed : {false, true})
            for (const bool asymmetric : {false, true})
                QTest::addRow("%s, %s", closed ? "closed" : "open",
                              asymmetric ? "asymmetric" : "symmetric")
                    << closed << asymmetric;
    }

    void objectiveAgreesWithVisitingNumbers()
    {
        QFETCH(bool, closed);
        QFETCH(bool, asymmetric);
        const TvpProblem problem =
            test::randomProblem(4, 5, 0.7, closed ? Route::Closed : Route::Open, asymmetric);
        VisitOrder order{1, 2, 3, 4, 5};
        int orders = 0;
        do {
            ++orders;
            // Values of a few hundred: rounding is below 1e-12.
            COMPARE_NEAR(objective(problem, order), test::costByVisitingNumbers(problem, order),
                         1e-10);
        } while (std::next_permutation(order.begin(), order.end()));
        QCOMPARE(orders, 120);
    }

    void gapIsRelative_data()
    {
        QTest::addColumn<double>("bound");
        QTest::addColumn<double>("gap");
        // F = 24.5, F + N sum(sigma) = 64.5.
        QTest::newRow("closed gap") << 24.5 << 0.0;
        QTest::newRow("a tenth") << 24.5 - 6.45 << 0.1;
        QTest::newRow("trivial bound") << -40.0 << 1.0;
        QTest::newRow("bound above by rounding") << 24.6 << 0.0;
    }

    void gapIsRelative()
    {
        QFETCH(double, bound);
        QFETCH(double, gap);
        const TvpProblem problem = handProblem(Route::Open);
        COMPARE_NEAR(relativeGap(problem, objective(problem, kOrder), bound), gap, 1e-14);
    }

    void restrictsToSomeNodes()
    {
        const TvpProblem problem = handProblem(Route::Closed);
        const TvpProblem part = restrictedTo(problem, VisitOrder{3, 1});
        Eigen::MatrixXd expected_m(3, 3);
        expected_m << 0, 30, 10, //
            31, 0, 32,           //
            11, 13, 0;
        QVERIFY(part.distance_m == expected_m);
        QVERIFY((part.sigma_m2 == std::vector<double>{0, 3, 2}));
        QCOMPARE(part.mu, problem.mu);
        QVERIFY(part.route == Route::Closed);
        QCOMPARE(restrictedTo(problem, VisitOrder{}).icebergCount(), 0);
    }

    void measuresBetweenPoints()
    {
        Eigen::MatrixX2d points_m(3, 2);
        points_m << 0, 0, 3, 4, 3, -8;
        Eigen::MatrixXd expected_m(3, 3);
        expected_m << 0, 5, std::sqrt(73.0), 5, 0, 12, std::sqrt(73.0), 12, 0;
        QVERIFY(euclideanDistances(points_m).isApprox(expected_m, 1e-15));
    }

    void acceptsSoundProblems()
    {
        TvpProblem problem = handProblem(Route::Open);
        problem.distance_m.diagonal().setConstant(kNan); // ignored
        QVERIFY(validate(problem).empty());
        QVERIFY(validate(test::randomProblem(1, 0, 1, Route::Open)).empty());
        problem.mu = 1e-320; // then legs cost nothing beside sigma
        QVERIFY(validate(problem).empty());
        problem.mu = 1e300; // factors are free as long as the product is in range
        problem.distance_m *= 1e-300;
        QVERIFY(validate(problem).empty());
    }

    void namesTheFaultyField_data()
    {
        QTest::addColumn<QString>("field");
        QTest::addColumn<TvpProblem>("problem");
        const auto row = [](const char* name, const char* field, auto&& change) {
            TvpProblem problem = handProblem(Route::Open);
            change(problem);
            QTest::newRow(name) << QString::fromLatin1(field) << problem;
        };
        row("no node", "sigma", [](TvpProblem& p) { p = {}; });
        row("sigma negative", "sigma[2]", [](TvpProblem& p) { p.sigma_m2[2] = -1; });
        row("sigma NaN", "sigma[3]", [](TvpProblem& p) { p.sigma_m2[3] = kNan; });
        row("sigma infinite", "sigma[1]", [](TvpProblem& p) { p.sigma_m2[1] = kInfinity; });
        row("sigma of the UAV", "sigma[0]", [](TvpProblem& p) { p.sigma_m2[0] = 1; });
        row("matrix too small", "distance_m",
            [](TvpProblem& p) { p.distance_m = Eigen::MatrixXd::Zero(3, 3); });
        row("matrix not square", "distance_m",
            [](TvpProblem& p) { p.distance_m = Eigen::MatrixXd::Zero(4, 3); });
        row("distance negative", "distance_m[1][2]",
            [](TvpProblem& p) { p.distance_m(1, 2) = -1e-9; });
        row("distance NaN", "distance_m[3][0]", [](TvpProblem& p) { p.distance_m(3, 0) = kNan; });
        row("distance infinite", "distance_m[0][1]",
            [](TvpProblem& p) { p.distance_m(0, 1) = kInfinity; });
        row("mu negative", "mu", [](TvpProblem& p) { p.mu = -1; });
        row("mu NaN", "mu", [](TvpProblem& p) { p.mu = kNan; });
        row("mu infinite", "mu", [](TvpProblem& p) { p.mu = kInfinity; });
        row("mu times distance infinite", "mu", [](TvpProblem& p) {
            p.mu = 1e300;
            p.distance_m *= 1e10;
        });
        row("mu times latency too large", "mu", [](TvpProblem& p) {
            p.criterion = Criterion::Latency;
            p.mu = 1e60;
            p.sigma_m2[1] = 1e60;
        });
        row("sum of distances infinite", "distance_m", [](TvpProblem& p) {
            p.distance_m.setConstant(1e308);
            p.mu = 0;
        });
        row("sigma without digits", "sigma", [](TvpProblem& p) { p.sigma_m2[1] = 1e-310; });
        row("mu times distance without digits", "mu", [](TvpProblem& p) {
            p.sigma_m2.assign(p.sigma_m2.size(), 0.0);
            p.mu = 1e-310;
        });
        row("mu times latency without digits", "mu", [](TvpProblem& p) {
            p.criterion = Criterion::Latency;
            p.mu = 1e-200;
            p.sigma_m2[1] = 1e-200;
        });
        row("sum of sigmas infinite", "sigma", [](TvpProblem& p) {
            p.sigma_m2[1] = p.sigma_m2[2] = 1.7e308;
            p.mu = 0;
        });
    }

    void namesTheFaultyField()
    {
        QFETCH(QString, field);
        QFETCH(TvpProblem, problem);
        const std::vector<Issue> issues = validate(problem);
        QCOMPARE(issues.size(), std::size_t{1});
        QCOMPARE(QString::fromStdString(issues[0].field), field);
        QVERIFY(issues[0].severity == Severity::Error);
        QVERIFY(!issues[0].message().empty());
    }

    void reportsAllFaultsAtOnce()
    {
        TvpProblem problem = handProblem(Route::Open);
        problem.mu = -1;
        problem.sigma_m2[1] = kNan;
        problem.distance_m(1, 2) = -1;
        problem.distance_m(2, 1) = kInfinity;
        const std::vector<Issue> issues = validate(problem);
        QCOMPARE(issues.size(), std::size_t{4});
        for (const char* field : {"mu", "sigma[1]", "distance_m[1][2]", "distance_m[2][1]"})
            QVERIFY2(test::names(issues, field), field);
    }
};

QTEST_APPLESS_MAIN(TestTvp)
#include "tst_tvp.moc"
