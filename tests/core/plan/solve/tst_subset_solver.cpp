#include "core/plan/solve/subset_solver.h"
#include "tests/support/approx.h"
#include "tests/support/plan/brute_force.h"

#include <QtTest>

using namespace berg;

namespace {

/** Returns the order of the node numbers. */
/** All legs and all sigmas alike: every order costs the same. */
TvpProblem indifferent(int icebergs)
{
    return {.distance_m = Eigen::MatrixXd::Constant(icebergs + 1, icebergs + 1, 100.0),
            .sigma_m2 =
                [&] {
                    std::vector<double> sigma_m2(static_cast<std::size_t>(icebergs) + 1, 4.0);
                    sigma_m2[0] = 0;
                    return sigma_m2;
                }(),
            .mu = 0.25,
            .route = Route::Closed};
}

} // namespace

/** Properties of this back end; the conformance suite tests the common ones. */
class TestSubsetSolver : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    /** Every row length the table is compiled for up to 9 icebergs, even and odd sizes. */
    void agreesWithTryingAllOrders_data()
    {
        QTest::addColumn<int>("icebergs");
        for (int n = 1; n <= 9; ++n)
            QTest::addRow("%d icebergs", n) << n;
    }

    void agreesWithTryingAllOrders()
    {
        QFETCH(int, icebergs);
        const int instances = icebergs <= 7 ? 12 : 1;
        for (int k = 0; k < instances; ++k) {
            const TvpProblem problem =
                test::randomProblem(static_cast<std::uint64_t>(k), icebergs, 0.5 * (1 + k % 4),
                                    k % 2 == 0 ? Route::Closed : Route::Open, k % 3 == 0);
            const test::BruteForce best = test::bruteForce(problem);
            const SolveOutcome outcome = SubsetSolver().solve(problem, {});
            QVERIFY(outcome.status == SolveStatus::Optimal);
            QVERIFY(outcome.order() == best.order);
            QCOMPARE(outcome.work, std::int64_t{icebergs} << icebergs);
        }
    }

    /** 20 icebergs are too many to try out all orders, so the result is compared with itself. */
    void largestSizeIsConsistent()
    {
        TvpProblem problem = test::randomProblem(3, 20, 1, Route::Open);
        const SolveOutcome whole = SubsetSolver().solve(problem, {});
        QVERIFY(whole.status == SolveStatus::Optimal);

        // The end of an optimal order is optimal from where it starts (Bellman): the last ten
        // icebergs seen from the tenth.
        const VisitOrder rest(whole.order().begin() + 10, whole.order().end());
        TvpProblem tail = restrictedTo(problem, rest);
        for (int j = 1; j <= 10; ++j)
            tail.distance_m(0, j) = legBetween(problem.distance_m, whole.order()[9],
                                               rest[static_cast<std::size_t>(j) - 1]);
        const SolveOutcome part = SubsetSolver().solve(tail, {});
        QVERIFY(part.order() == ascendingOrder(10));
    }

    void refusesWhatDoesNotFit()
    {
        const TvpProblem problem = test::randomProblem(1, 21, 1, Route::Open);
        QVERIFY(SubsetSolver().unsupportedReason(problem).has_value());
        const SolveOutcome outcome = SubsetSolver().solve(problem, {});
        QVERIFY(outcome.status == SolveStatus::None);
        QVERIFY(outcome.reason == StopReason::Unable);
        QVERIFY(!outcome.detail.empty());
        QVERIFY(!SubsetSolver().unsupportedReason(test::randomProblem(1, 20, 1, Route::Open)));
    }

    void tiesGoToTheSmallestNumbers()
    {
        for (const int n : {1, 2, 3, 6, 11, 14})
            QVERIFY(SubsetSolver().solve(indifferent(n), {}).order() == ascendingOrder(n));
    }

    void reportsTheHintThenTheOptimum()
    {
        const TvpProblem problem = test::randomProblem(8, 9, 1, Route::Closed);
        std::vector<SolveProgress> reports;
        SolveOptions options;
        options.hint = {ascendingOrder(9)};
        options.onProgress = [&](const SolveProgress& progress) { reports.push_back(progress); };
        const SolveOutcome outcome = SubsetSolver().solve(problem, options);
        QCOMPARE(reports.size(), std::size_t{2});
        QVERIFY(reports[0].plan == options.hint);
        QVERIFY(!reports[0].bound);
        QVERIFY(reports[1].plan.front() == outcome.order());
        QCOMPARE(reports[1].bound.value(), outcome.objective);
        QCOMPARE(reports[1].objective, outcome.objective);
        QVERIFY(!outcome.hintUsed); // the optimum does not come from the hint
    }

    void limitsLeaveTheHint_data()
    {
        QTest::addColumn<int>("reason");
        QTest::addColumn<bool>("hinted");
        for (const bool hinted : {false, true}) {
            const char* with = hinted ? "hint" : "no hint";
            QTest::addRow("cancelled, %s", with)
                << static_cast<int>(StopReason::Cancelled) << hinted;
            QTest::addRow("time limit, %s", with)
                << static_cast<int>(StopReason::TimeLimit) << hinted;
            QTest::addRow("work limit, %s", with)
                << static_cast<int>(StopReason::WorkLimit) << hinted;
            QTest::addRow("memory limit, %s", with)
                << static_cast<int>(StopReason::MemoryLimit) << hinted;
        }
    }

    void limitsLeaveTheHint()
    {
        QFETCH(int, reason);
        QFETCH(bool, hinted);
        const TvpProblem problem = test::randomProblem(8, 13, 1, Route::Open);
        std::stop_source stop;
        SolveOptions options;
        options.stop = stop.get_token();
        if (hinted)
            options.hint = {ascendingOrder(13)};
        if (reason == static_cast<int>(StopReason::TimeLimit))
            options.timeLimit_s = 0;
        if (reason == static_cast<int>(StopReason::WorkLimit))
            options.workLimit = SubsetSolver::workFor(13) - 1;
        if (reason == static_cast<int>(StopReason::MemoryLimit))
            options.memoryLimit_bytes = SubsetSolver::bytesFor(13) - 1;
        if (reason == static_cast<int>(StopReason::Cancelled)) {
            if (!hinted)
                stop.request_stop();
            options.onProgress = [&](const SolveProgress&) { stop.request_stop(); };
        }
        const SolveOutcome outcome = SubsetSolver().solve(problem, options);
        QCOMPARE(static_cast<int>(outcome.reason), reason);
        QCOMPARE(outcome.hintUsed, hinted);
        QVERIFY(outcome.status == (hinted ? SolveStatus::Feasible : SolveStatus::None));
        QVERIFY(outcome.plan == options.hint);
        QVERIFY(!outcome.bound);
    }

    void enoughWorkIsNoLimit()
    {
        SolveOptions options;
        options.workLimit = SubsetSolver::workFor(8);
        options.memoryLimit_bytes = SubsetSolver::bytesFor(8);
        const SolveOutcome outcome =
            SubsetSolver().solve(test::randomProblem(8, 8, 1, Route::Open), options);
        QVERIFY(outcome.status == SolveStatus::Optimal);
        QVERIFY(outcome.reason == StopReason::Finished);
        QCOMPARE(outcome.work, *options.workLimit);
    }
};

QTEST_APPLESS_MAIN(TestSubsetSolver)
#include "tst_subset_solver.moc"
