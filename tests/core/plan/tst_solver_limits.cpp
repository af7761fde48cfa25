#include "tests/support/plan/solver_contestants.h"

using namespace berg;
using namespace berg::test;

/** Limits are outcomes of every back end, with the result so far. */
class TestSolverLimits : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void cancelledBeforeTheStart_data() { solvers_data(); }
    void cancelledBeforeTheStart()
    {
        std::stop_source stop;
        stop.request_stop();
        SolveOptions options = hinted(ascendingOrder(6));
        options.stop = stop.get_token();
        const TvpProblem problem = test::randomProblem(92, 6, 1, Route::Open);
        const SolveOutcome outcome = solver()->solve(problem, options);
        QVERIFY(outcome.status == SolveStatus::None);
        QVERIFY(outcome.reason == StopReason::Cancelled);
        QVERIFY(outcome.order().empty());
        QVERIFY(!outcome.bound);
    }

    void limitsAreOutcomes_data()
    {
        QTest::addColumn<int>("contestant");
        QTest::addColumn<int>("workLimit"); // −1 means a time limit of 0 instead
        QTest::addColumn<bool>("withHint");
        forEach([](int index, const char* name) {
            for (const bool withHint : {false, true}) {
                const char* with = withHint ? "hint" : "no hint";
                QTest::addRow("%s, work 0, %s", name, with) << index << 0 << withHint;
                QTest::addRow("%s, work 1, %s", name, with) << index << 1 << withHint;
                QTest::addRow("%s, no time, %s", name, with) << index << -1 << withHint;
            }
        });
    }

    void limitsAreOutcomes()
    {
        QFETCH(int, workLimit);
        QFETCH(bool, withHint);
        const TvpProblem problem = test::randomProblem(93, 8, 1, Route::Open);
        const double optimum = test::bruteForce(problem).objective;
        SolveOptions options;
        if (withHint)
            options.hint = {ascendingOrder(8)};
        if (workLimit >= 0)
            options.workLimit = workLimit;
        else
            options.timeLimit_s = 0;
        const SolveOutcome outcome = solver()->solve(problem, options);
        QCOMPARE(faultOf(contestant(), problem, outcome, optimum), QString());
        const StopReason limit = workLimit >= 0 ? StopReason::WorkLimit : StopReason::TimeLimit;
        // A back end may end before its first check of the limit.
        QVERIFY(outcome.reason == limit || outcome.status == SolveStatus::Optimal);
        if (withHint) {
            QVERIFY(outcome.status != SolveStatus::None);
            QVERIFY(outcome.objective <= objective(problem, options.hint.front()));
        }
        if (workLimit >= 0) {
            QVERIFY(same(outcome, solver()->solve(problem, options)));
        }
    }

    /** A solve cancelled by its own first report keeps its result. */
    void cancelledOnTheWay_data() { solvers_data(); }
    void cancelledOnTheWay()
    {
        const TvpProblem problem = test::randomProblem(94, 8, 1, Route::Open);
        std::stop_source stop;
        SolveOptions options = hinted(ascendingOrder(8));
        options.stop = stop.get_token();
        options.onProgress = [&stop](const SolveProgress&) { stop.request_stop(); };
        const SolveOutcome outcome = solver()->solve(problem, options);
        QCOMPARE(faultOf(contestant(), problem, outcome, test::bruteForce(problem).objective),
                 QString());
        QVERIFY(outcome.reason == StopReason::Cancelled || outcome.status == SolveStatus::Optimal);
        QVERIFY(outcome.status != SolveStatus::None);
        QVERIFY(outcome.objective <= objective(problem, options.hint.front()));
    }

    void keepsToTheGap_data() { solvers_data(); }
    void keepsToTheGap()
    {
        const TvpProblem problem = test::randomProblem(95, 8, 1, Route::Closed);
        SolveOptions options;
        options.gap = 0.2;
        const SolveOutcome outcome = solver()->solve(problem, options);
        QCOMPARE(faultOf(contestant(), problem, outcome, test::bruteForce(problem).objective),
                 QString());
        QVERIFY(outcome.bound.has_value());
        QVERIFY(relativeGap(problem, outcome.objective, *outcome.bound) <= 0.2 + 1e-9);
        QVERIFY(outcome.status == SolveStatus::Optimal || outcome.reason == StopReason::GapReached);
    }
};

QTEST_APPLESS_MAIN(TestSolverLimits)
#include "tst_solver_limits.moc"
