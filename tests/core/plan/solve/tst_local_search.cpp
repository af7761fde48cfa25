#include "core/plan/solve/engine.h"
#include "core/plan/solve/order_moves.h"
#include "tests/support/approx.h"
#include "tests/support/plan/brute_force.h"
#include "tests/support/plan/problem_rows.h"

#include <QtTest>

using namespace berg;

namespace {

double gapOf(const TvpProblem& problem, const SolveOutcome& outcome)
{
    return outcome.bound ? relativeGap(problem, outcome.objective, *outcome.bound) : 1.0;
}

} // namespace

/** Properties of this back end; the conformance suite tests the common ones. */
class TestLocalSearch : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    /** With 18 icebergs it proves the optimum of the dynamic programme. */
    void provesMiddlingProblems_data() { test::addProblemRows(); }
    void provesMiddlingProblems()
    {
        const TvpProblem problem = test::fetchedProblem(31, 18);
        const SolveOutcome exact = ExactSolver().solve(problem, {});
        const SolveOutcome outcome = LocalSearch().solve(problem, {});
        QVERIFY(outcome.status == SolveStatus::Optimal);
        QVERIFY(outcome.reason == StopReason::Finished);
        const double scale = exact.objective + objectiveShift(problem);
        COMPARE_NEAR(outcome.objective, exact.objective, 2e-9 * scale); // the proof's margin
    }

    /** Planning must be good at this size. */
    void certifiesFortyIcebergs_data() { test::addProblemRows(); }
    void certifiesFortyIcebergs()
    {
        const TvpProblem problem = test::fetchedProblem(32, 40);
        const SolveOutcome outcome = LocalSearch().solve(problem, {});
        QVERIFY(gapOf(problem, outcome) <= 0.02);
        QVERIFY(outcome.status == SolveStatus::Optimal || gapOf(problem, outcome) > 0);
    }

    /** The work limit ends it after about a second, but always at the same result. */
    void endsByItself()
    {
        const TvpProblem problem = test::randomProblem(35, 100, 3, Route::Open);
        SolveOptions options;
        const SolveOutcome outcome = LocalSearch().solve(problem, options);
        QVERIFY(outcome.status == SolveStatus::Feasible);
        QVERIFY(outcome.reason == StopReason::Finished);
        QVERIFY(gapOf(problem, outcome) <= 0.05);
        // Limits are checked between sweeps and rounds.
        QVERIFY(outcome.work <= 1'000'000'000);

        options.workLimit = 10 * outcome.work; // a limit, not a target
        const SolveOutcome again = LocalSearch().solve(problem, options);
        QCOMPARE(again.work, outcome.work);
        QVERIFY(again.plan == outcome.plan);
        QVERIFY(again.bound == outcome.bound);
        QVERIFY(again.reason == StopReason::Finished);

        options.workLimit = outcome.work / 10;
        const SolveOutcome less = LocalSearch().solve(problem, options);
        QVERIFY(less.reason == StopReason::WorkLimit);
        QVERIFY(less.work < outcome.work / 5);
        QVERIFY(less.bound.value() <= outcome.bound.value());
    }

    /** A re-plan does a small part of the work, repeats, and has a gap. */
    void endsSoonInFlight_data()
    {
        QTest::addColumn<int>("icebergs");
        QTest::newRow("100") << 100;
        QTest::newRow("300: no memory") << 300;
    }

    void endsSoonInFlight()
    {
        QFETCH(int, icebergs);
        const TvpProblem problem = test::randomProblem(45, icebergs, 1, Route::Open);
        const SolveOutcome first = LocalSearch().solve(problem, {});
        SolveOptions options;
        options.inFlight = true;
        options.hint = first.plan;
        options.multipliers = first.multipliers;
        const SolveOutcome next = LocalSearch().solve(problem, options);
        QVERIFY(next.status == SolveStatus::Feasible);
        QVERIFY(next.reason == StopReason::Finished);
        QVERIFY(next.work <= first.work / 10);
        QVERIFY(next.objective <= first.objective);
        QVERIFY(gapOf(problem, next) <= 0.1);

        const SolveOutcome again = LocalSearch().solve(problem, options);
        QCOMPARE(again.work, next.work);
        QVERIFY(again.plan == next.plan);
        QVERIFY(again.bound == next.bound);
        QVERIFY(again.multipliers == next.multipliers);
    }

    /** With any multipliers, a proof finds the optimum. */
    void provesWithAnyMultipliers_data()
    {
        QTest::addColumn<double>("multiplier");
        for (const double multiplier : {0.0, -30.0, 1e4, 1e12})
            QTest::addRow("%g", multiplier) << multiplier;
    }

    void provesWithAnyMultipliers()
    {
        QFETCH(double, multiplier);
        const TvpProblem problem = test::randomProblem(46, 18, 1, Route::Open);
        const SolveOutcome exact = ExactSolver().solve(problem, {});
        SolveOptions options;
        options.inFlight = true;
        options.hint = {ascendingOrder(18)};
        options.multipliers.assign(19, 0);
        for (std::size_t node = 1; node < 19; node += 2)
            options.multipliers[node] = multiplier;
        const SolveOutcome outcome = LocalSearch().solve(problem, options);
        QVERIFY(outcome.status == SolveStatus::Optimal);
        const double scale = exact.objective + objectiveShift(problem);
        COMPARE_NEAR(outcome.objective, exact.objective, 2e-9 * scale); // the proof's margin
    }

    void stopsAtTheGap()
    {
        const TvpProblem problem = test::randomProblem(36, 30, 3, Route::Open);
        SolveOptions options;
        options.gap = 0.05;
        const SolveOutcome outcome = LocalSearch().solve(problem, options);
        QVERIFY(outcome.status == SolveStatus::Feasible);
        QVERIFY(outcome.reason == StopReason::GapReached);
        const double gap = gapOf(problem, outcome);
        QVERIFY(gap > 0);
        QVERIFY(gap <= 0.05 + 1e-12);
    }

    /**
     * The first report has an order without bound, then better ones and bounds follow; the last is
     * the answer.
     */
    void reportsGetBetter()
    {
        const TvpProblem problem = test::randomProblem(37, 30, 1, Route::Closed);
        std::vector<SolveProgress> reports;
        SolveOptions options;
        options.onProgress = [&](const SolveProgress& progress) { reports.push_back(progress); };
        const SolveOutcome outcome = LocalSearch().solve(problem, options);
        QVERIFY(reports.size() >= 2);
        QVERIFY(!reports.front().bound);
        for (std::size_t k = 0; k < reports.size(); ++k) {
            QVERIFY(isVisitOrder(problem, reports[k].plan.front()));
            QCOMPARE(reports[k].objective, objective(problem, reports[k].plan.front()));
            if (k == 0)
                continue;
            QVERIFY(reports[k].objective <= reports[k - 1].objective);
            QVERIFY(reports[k].elapsed_s >= reports[k - 1].elapsed_s);
            QVERIFY(!reports[k - 1].bound || reports[k].bound.value() >= *reports[k - 1].bound);
        }
        QVERIFY(reports.back().plan.front() == outcome.order());
        QVERIFY(reports.back().bound.has_value());
    }

    /** A solve cancelled at any of its reports returns the order reported last. */
    void keepsTheOrderInHandWhenCancelled_data()
    {
        QTest::addColumn<int>("atReport");
        for (const int report : {1, 2, 3, 4})
            QTest::addRow("report %d", report) << report;
    }

    void keepsTheOrderInHandWhenCancelled()
    {
        QFETCH(int, atReport);
        const TvpProblem problem = test::randomProblem(38, 45, 1, Route::Open);
        std::stop_source stop;
        int reports = 0;
        double reported = 0;
        SolveOptions options;
        options.stop = stop.get_token();
        options.onProgress = [&](const SolveProgress& progress) {
            reported = progress.objective;
            if (++reports == atReport)
                stop.request_stop();
        };
        const SolveOutcome outcome = LocalSearch().solve(problem, options);
        QVERIFY(outcome.status == SolveStatus::Feasible);
        QVERIFY(outcome.reason == StopReason::Cancelled);
        QCOMPARE(outcome.objective, reported);
        QVERIFY(reports <= atReport + 1); // the result at the time of the stop
    }

    void noTimeStillGivesAnOrder()
    {
        const TvpProblem problem = test::randomProblem(39, 45, 1, Route::Open);
        SolveOptions options;
        options.timeLimit_s = 0;
        const SolveOutcome outcome = LocalSearch().solve(problem, options);
        QVERIFY(outcome.status == SolveStatus::Feasible);
        QVERIFY(outcome.reason == StopReason::TimeLimit);
        QVERIFY(isVisitOrder(problem, outcome.order()));
        QVERIFY(!outcome.bound);
    }

    void startsFromTheHint()
    {
        const TvpProblem problem = test::randomProblem(40, 16, 1, Route::Open);
        const VisitOrder best = ExactSolver().solve(problem, {}).order();
        SolveOptions options;
        options.timeLimit_s = 0; // only the hint is used
        options.hint = {best};
        const SolveOutcome outcome = LocalSearch().solve(problem, options);
        QVERIFY(outcome.order() == best);
        QVERIFY(outcome.hintUsed);
        QVERIFY(!LocalSearch().solve(problem, {}).hintUsed);
    }

    void sortsWithoutDistances()
    {
        const TvpProblem problem = test::randomProblem(41, 70, 0, Route::Closed);
        const SolveOutcome outcome = LocalSearch().solve(problem, {});
        QVERIFY(outcome.status == SolveStatus::Optimal);
        QVERIFY(outcome.order() == sigmaOrder(problem));
    }

    /** Tests sizes around those where the method changes, and the largest supported ones. */
    void worksForManyIcebergs_data()
    {
        QTest::addColumn<int>("icebergs");
        QTest::addColumn<double>("gap");
        // The allowed gaps are two to four times the measured ones.
        QTest::newRow("127: the last size with memory") << 127 << 0.1;
        QTest::newRow("128: the first without") << 128 << 0.2;
        QTest::newRow("500") << 500 << 0.5;
    }

    void worksForManyIcebergs()
    {
        QFETCH(int, icebergs);
        QFETCH(double, gap);
        const TvpProblem problem = test::randomProblem(42, icebergs, 1, Route::Open);
        SolveOptions options;
        options.gap = gap;
        const SolveOutcome outcome = LocalSearch().solve(problem, options);
        QVERIFY(isVisitOrder(problem, outcome.order()));
        QVERIFY(gapOf(problem, outcome) <= gap + 1e-12);
        const double sorted = objective(problem, sigmaOrder(problem));
        QVERIFY(outcome.objective < sorted);
        QVERIFY(outcome.objective < objective(problem, ascendingOrder(icebergs)));
    }
};

QTEST_APPLESS_MAIN(TestLocalSearch)
#include "tst_local_search.moc"
