#include "core/plan/solve/cbc_solver.h"
#include "core/plan/solve/engine.h"
#include "tests/support/approx.h"
#include "tests/support/plan/brute_force.h"
#include "tests/support/plan/cbc_checks.h"

#include <QRegularExpression>

using namespace berg;
using namespace berg::test;

/** The MILP on the columns that the engine's bound leaves. */
class TestCbcReduced : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void reducedAgreesWithDynamicProgramming_data()
    {
        QTest::addColumn<int>("icebergs");
        QTest::addColumn<double>("tau");
        for (const int icebergs : {9, 10, 11, 12})
            for (const double tau : {0.0, 0.25, 0.5, 1.0, 3.0, 10.0})
                QTest::addRow("%d icebergs, tau %g", icebergs, tau) << icebergs << tau;
    }

    void reducedAgreesWithDynamicProgramming()
    {
        QFETCH(int, icebergs);
        QFETCH(double, tau);
        for (const Route route : {Route::Open, Route::Closed})
            for (const bool asymmetric : {false, true})
                for (const std::uint64_t seed : {1U, 2U, 3U}) {
                    const TvpProblem problem =
                        randomProblem(seed, icebergs, tau, route, asymmetric);
                    const double best = ExactSolver().solve(problem, {}).objective;
                    const SolveOutcome outcome = CbcSolver(Formulation::Reduced).solve(problem, {});
                    QCOMPARE(outcome.status, SolveStatus::Optimal);
                    COMPARE_NEAR(outcome.objective, best, toleranceOf(problem, best));
                }
    }

    /** These sizes are far beyond the other formulations, so the engine's own proof is compared. */
    void reducedAgreesWithTheEngine_data()
    {
        QTest::addColumn<int>("icebergs");
        QTest::addColumn<Route>("route");
        QTest::addColumn<bool>("asymmetric");
        for (const int icebergs : {20, 30, 40}) {
            QTest::addRow("%d, open", icebergs) << icebergs << Route::Open << false;
            QTest::addRow("%d, closed, asymmetric", icebergs) << icebergs << Route::Closed << true;
        }
    }

    void reducedAgreesWithTheEngine()
    {
        QFETCH(int, icebergs);
        QFETCH(Route, route);
        QFETCH(bool, asymmetric);
        for (const double tau : {0.0, 0.5, 3.0}) {
            const TvpProblem problem = randomProblem(11, icebergs, tau, route, asymmetric);
            const SolveOutcome engine = LocalSearch().solve(problem, {});
            QCOMPARE(engine.status, SolveStatus::Optimal);
            const SolveOutcome outcome = CbcSolver(Formulation::Reduced).solve(problem, {});
            QCOMPARE(outcome.status, SolveStatus::Optimal);
            COMPARE_NEAR(outcome.objective, engine.objective,
                         toleranceOf(problem, engine.objective));
        }
    }

    void reducedTakesAnyHint()
    {
        const TvpProblem problem = randomProblem(4, 11, 1, Route::Open);
        const SolveOutcome best = ExactSolver().solve(problem, {});
        for (const VisitOrder& hint : {best.order(), inNodeOrder(problem)}) {
            SolveOptions options;
            options.hint = {hint};
            const SolveOutcome outcome = CbcSolver(Formulation::Reduced).solve(problem, options);
            QVERIFY(outcome.hintUsed);
            QCOMPARE(outcome.status, SolveStatus::Optimal);
            COMPARE_NEAR(outcome.objective, best.objective, toleranceOf(problem, best.objective));
        }
    }

    /** A stop at any time leaves a valid answer: an order no worse than the hint, a valid bound. */
    void reducedCanBeStopped()
    {
        const TvpProblem problem = randomProblem(8, 30, 1, Route::Open);
        const SolveOutcome engine = LocalSearch().solve(problem, {});
        for (const double limit_s : {1e-9, 1e-3, 4e-3, 8e-3}) {
            SolveOptions options;
            options.timeLimit_s = limit_s;
            options.hint = {inNodeOrder(problem)};
            const SolveOutcome outcome = CbcSolver(Formulation::Reduced).solve(problem, options);
            QVERIFY(outcome.status == SolveStatus::Optimal ||
                    outcome.reason == StopReason::TimeLimit);
            QVERIFY(isVisitOrder(problem, outcome.order()));
            QVERIFY(outcome.objective <= objective(problem, options.hint.front()));
            if (outcome.bound)
                QVERIFY(*outcome.bound <=
                        engine.objective + toleranceOf(problem, engine.objective));
        }
    }
};

QTEST_APPLESS_MAIN(TestCbcReduced)
#include "tst_cbc_reduced.moc"
