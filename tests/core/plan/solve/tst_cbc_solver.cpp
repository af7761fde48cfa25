#include "core/plan/solve/cbc_solver.h"
#include "core/plan/solve/engine.h"
#include "tests/support/approx.h"
#include "tests/support/plan/brute_force.h"
#include "tests/support/plan/cbc_checks.h"

#include <QRegularExpression>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <stdexcept>
#include <thread>
#include <unistd.h>
#include <vector>

using namespace berg;
using namespace berg::test;

namespace {

void addFormulations()
{
    QTest::addColumn<Formulation>("formulation");
    QTest::newRow("printed") << Formulation::Printed;
    QTest::newRow("position") << Formulation::Position;
}

void addAllFormulations()
{
    addFormulations();
    QTest::newRow("reduced") << Formulation::Reduced;
}

/** Far from solved in any test's time, with thousands of nodes and a relaxation in milliseconds. */
TvpProblem endless()
{
    return randomProblem(3, 12, 0.5, Route::Open);
}
const Formulation kEndlessFormulation = Formulation::Printed;

/** Collects the output to a file descriptor during its lifetime. */
class Capture
{
public:
    explicit Capture(int descriptor)
        : m_descriptor(descriptor), m_file(std::tmpfile()), m_saved(dup(descriptor))
    {
        std::fflush(nullptr);
        dup2(fileno(m_file), m_descriptor);
    }
    Capture(const Capture&) = delete;
    Capture& operator=(const Capture&) = delete;
    ~Capture()
    {
        dup2(m_saved, m_descriptor);
        close(m_saved);
        std::fclose(m_file);
    }
    [[nodiscard]] long written() const
    {
        std::fflush(nullptr);
        return static_cast<long>(lseek(fileno(m_file), 0, SEEK_END));
    }

private:
    int m_descriptor;
    std::FILE* m_file;
    int m_saved;
};

} // namespace

class TestCbcSolver : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void optimumEqualsBruteForce_data()
    {
        QTest::addColumn<Formulation>("formulation");
        QTest::addColumn<int>("icebergs");
        QTest::addColumn<Route>("route");
        QTest::addColumn<bool>("asymmetric");
        for (int icebergs = 1; icebergs <= 8; ++icebergs)
            for (const Route route : {Route::Open, Route::Closed})
                for (const bool asymmetric : {false, true}) {
                    const char* path = route == Route::Open ? "open" : "closed";
                    const char* wind = asymmetric ? ", asymmetric" : "";
                    QTest::addRow("position, %d, %s%s", icebergs, path, wind)
                        << Formulation::Position << icebergs << route << asymmetric;
                    QTest::addRow("reduced, %d, %s%s", icebergs, path, wind)
                        << Formulation::Reduced << icebergs << route << asymmetric;
                    if (icebergs <= 6)
                        QTest::addRow("printed, %d, %s%s", icebergs, path, wind)
                            << Formulation::Printed << icebergs << route << asymmetric;
                }
    }

    void optimumEqualsBruteForce()
    {
        QFETCH(Formulation, formulation);
        QFETCH(int, icebergs);
        QFETCH(Route, route);
        QFETCH(bool, asymmetric);
        const int seeds = formulation != Formulation::Printed || icebergs <= 4 ? 4 : 1;
        for (int seed = 1; seed <= seeds; ++seed) {
            const TvpProblem problem = randomProblem(static_cast<std::uint64_t>(seed), icebergs,
                                                     0.5 * seed, route, asymmetric);
            const SolveOutcome outcome = CbcSolver(formulation).solve(problem, {});
            QCOMPARE(outcome.status, SolveStatus::Optimal);
            QCOMPARE(outcome.reason, StopReason::Finished);
            QVERIFY(!outcome.hintUsed);
            const double best = bruteForce(problem).objective;
            COMPARE_NEAR(outcome.objective, best, toleranceOf(problem, best));
        }
    }

    void specialCasesAreSolved_data()
    {
        QTest::addColumn<TvpProblem>("problem");
        const TvpProblem plain = randomProblem(5, 5, 1, Route::Open);

        TvpProblem problem = plain;
        std::fill(problem.sigma_m2.begin(), problem.sigma_m2.end(), 0.0);
        QTest::newRow("sigmas zero") << problem;
        problem.mu = 0;
        QTest::newRow("no cost at all") << problem;
        QTest::newRow("tau 0") << randomProblem(5, 5, 0, Route::Open);
        QTest::newRow("tau 100") << randomProblem(5, 5, 100, Route::Open);
        QTest::newRow("tau 100, closed") << randomProblem(5, 5, 100, Route::Closed);

        problem = plain;
        problem.distance_m.setZero();
        QTest::newRow("all in one place") << problem;
        problem = plain;
        problem.distance_m.row(2) = problem.distance_m.row(1);
        problem.distance_m.col(2) = problem.distance_m.col(1);
        problem.sigma_m2[2] = problem.sigma_m2[1];
        QTest::newRow("two icebergs alike") << problem;

        problem = plain;
        for (double& sigma : problem.sigma_m2)
            sigma *= 1e-6;
        QTest::newRow("sigmas of a millionth") << problem;
        problem.mu *= 1e-6;
        QTest::newRow("all costs of a millionth") << problem;
        problem = plain;
        problem.mu *= 1e6;
        QTest::newRow("huge mu") << problem;
        problem = plain;
        problem.distance_m(1, 2) = 1e8;
        problem.distance_m(0, 3) = 1e8;
        QTest::newRow("two arcs all but barred") << problem;
    }

    void specialCasesAreSolved()
    {
        QFETCH(TvpProblem, problem);
        const double best = bruteForce(problem).objective;
        for (const Formulation formulation :
             {Formulation::Position, Formulation::Printed, Formulation::Reduced}) {
            const SolveOutcome outcome = CbcSolver(formulation).solve(problem, {});
            QCOMPARE(outcome.status, SolveStatus::Optimal);
            COMPARE_NEAR(outcome.objective, best, toleranceOf(problem, best));
        }
    }

    void largerOnesAgreeWithDynamicProgramming()
    {
        for (const int icebergs : {10, 12}) {
            const TvpProblem problem = randomProblem(7, icebergs, 1, Route::Open, true);
            const double best = ExactSolver().solve(problem, {}).objective;
            const SolveOutcome outcome = CbcSolver(Formulation::Position).solve(problem, {});
            QCOMPARE(outcome.status, SolveStatus::Optimal);
            COMPARE_NEAR(outcome.objective, best, toleranceOf(problem, best));
        }
    }

    void startsFromTheHint_data() { addFormulations(); }

    void startsFromTheHint()
    {
        QFETCH(Formulation, formulation);
        const TvpProblem problem = randomProblem(4, 5, 1, Route::Open);
        const BruteForce best = bruteForce(problem);
        for (const VisitOrder& hint : {best.order, inNodeOrder(problem)}) {
            VisitOrder first;
            SolveOptions options;
            options.hint = {hint};
            options.onProgress = [&first](const SolveProgress& progress) {
                if (first.empty())
                    first = progress.plan.front();
            };
            const SolveOutcome outcome = CbcSolver(formulation).solve(problem, options);
            QVERIFY(outcome.hintUsed);
            QVERIFY(first == hint);
            QCOMPARE(outcome.status, SolveStatus::Optimal);
            COMPARE_NEAR(outcome.objective, best.objective, toleranceOf(problem, best.objective));
        }
    }

    void withoutWorkTheHintComesBack_data() { addAllFormulations(); }

    void withoutWorkTheHintComesBack()
    {
        QFETCH(Formulation, formulation);
        const TvpProblem problem = randomProblem(4, 7, 1, Route::Open);
        SolveOptions options;
        options.workLimit = 0;
        const SolveOutcome without = CbcSolver(formulation).solve(problem, options);
        QCOMPARE(without.status, SolveStatus::None);
        QCOMPARE(without.reason, StopReason::WorkLimit);
        QVERIFY(!without.hintUsed);

        options.hint = {{7, 6, 5, 4, 3, 2, 1}};
        const SolveOutcome hinted = CbcSolver(formulation).solve(problem, options);
        QCOMPARE(hinted.status, SolveStatus::Feasible);
        QCOMPARE(hinted.reason, StopReason::WorkLimit);
        QVERIFY(hinted.hintUsed);
        QVERIFY(hinted.plan == options.hint);
        QCOMPARE(hinted.work, std::int64_t{0});
    }

    void aHintThatIsNoOrderIsIgnored()
    {
        const TvpProblem problem = randomProblem(4, 4, 1, Route::Open);
        SolveOptions options;
        options.hint = {{1, 2, 2, 4}};
        const SolveOutcome outcome = CbcSolver(Formulation::Position).solve(problem, options);
        QVERIFY(!outcome.hintUsed);
        QCOMPARE(outcome.status, SolveStatus::Optimal);
    }

    void theBoundHoldsWhenNodesRunOut_data()
    {
        QTest::addColumn<Formulation>("formulation");
        QTest::addColumn<int>("icebergs");
        QTest::addColumn<int>("nodes");
        QTest::newRow("printed, 1 node") << Formulation::Printed << 8 << 1;
        QTest::newRow("printed, 30 nodes") << Formulation::Printed << 8 << 30;
        QTest::newRow("printed, 300 nodes") << Formulation::Printed << 8 << 300;
        QTest::newRow("position, 1 node") << Formulation::Position << 14 << 1;
        QTest::newRow("position, 3 nodes") << Formulation::Position << 14 << 3;
    }

    void theBoundHoldsWhenNodesRunOut()
    {
        QFETCH(Formulation, formulation);
        QFETCH(int, icebergs);
        QFETCH(int, nodes);
        for (const std::uint64_t seed : {1U, 2U, 3U}) {
            const TvpProblem problem = randomProblem(seed, icebergs, 3, Route::Open);
            const double best = ExactSolver().solve(problem, {}).objective;
            SolveOptions options;
            options.workLimit = nodes;
            const CbcSolver solver(formulation);
            const SolveOutcome outcome = solver.solve(problem, options);
            QVERIFY(outcome.bound.has_value());
            QVERIFY(*outcome.bound <= best + toleranceOf(problem, best));
            QVERIFY(outcome.objective >= best - toleranceOf(problem, best));
            if (formulation == Formulation::Printed) { // the position model may be solved by then
                QCOMPARE(outcome.status, SolveStatus::Feasible);
                QCOMPARE(outcome.reason, StopReason::WorkLimit);
            }
            // Limits counted in nodes repeat.
            const SolveOutcome again = solver.solve(problem, options);
            QVERIFY(again.plan == outcome.plan);
            QCOMPARE(again.bound, outcome.bound);
            QCOMPARE(again.work, outcome.work);
        }
    }

    void stopsAtTheGap()
    {
        const TvpProblem problem = randomProblem(2, 7, 0.5, Route::Open);
        SolveOptions options;
        options.gap = 0.5;
        const SolveOutcome outcome = CbcSolver(Formulation::Printed).solve(problem, options);
        QCOMPARE(outcome.status, SolveStatus::Feasible);
        QCOMPARE(outcome.reason, StopReason::GapReached);
        QVERIFY(relativeGap(problem, outcome.objective, *outcome.bound) <= options.gap);
        QVERIFY(*outcome.bound <= bruteForce(problem).objective);
    }

    void stopsAtTheTimeLimit()
    {
        const TvpProblem problem = endless();
        SolveOptions options;
        options.timeLimit_s = 0.1;
        options.hint = {inNodeOrder(problem)};
        const SolveOutcome outcome = CbcSolver(kEndlessFormulation).solve(problem, options);
        QCOMPARE(outcome.status, SolveStatus::Feasible);
        QCOMPARE(outcome.reason, StopReason::TimeLimit);
        QVERIFY(outcome.objective <= objective(problem, options.hint.front()));
    }

    void cancelledBefore()
    {
        std::stop_source source;
        source.request_stop();
        SolveOptions options;
        options.stop = source.get_token();
        const SolveOutcome outcome = CbcSolver(kEndlessFormulation).solve(endless(), options);
        QCOMPARE(outcome.status, SolveStatus::None);
        QCOMPARE(outcome.reason, StopReason::Cancelled);
    }

    void cancelledInTheSearchByAnotherThread()
    {
        const TvpProblem problem = endless();
        std::stop_source source;
        std::atomic<bool> searching = false;
        SolveOptions options;
        options.stop = source.get_token();
        options.onProgress = [&searching](const SolveProgress&) {
            searching = true;
            searching.notify_all();
        };
        const std::jthread other([&source, &searching] {
            searching.wait(false);
            source.request_stop();
        });
        const SolveOutcome outcome = CbcSolver(kEndlessFormulation).solve(problem, options);
        QCOMPARE(outcome.reason, StopReason::Cancelled);
        QCOMPARE(outcome.status, SolveStatus::Feasible);
        const double best = ExactSolver().solve(problem, {}).objective;
        QVERIFY(*outcome.bound <= best + toleranceOf(problem, best));
        QVERIFY(outcome.objective >= best - toleranceOf(problem, best));
    }

    /** The first relaxation of 40 icebergs takes seconds; the stop comes before or within it. */
    void cancelledInTheFirstRelaxation()
    {
        std::stop_source source;
        SolveOptions options;
        options.stop = source.get_token();
        const std::jthread other([&source] { source.request_stop(); });
        const SolveOutcome outcome =
            CbcSolver(Formulation::Position).solve(randomProblem(1, 40, 1, Route::Open), options);
        QCOMPARE(outcome.reason, StopReason::Cancelled);
        QCOMPARE(outcome.status, SolveStatus::None);
    }

    void progressOnlyImproves_data() { addAllFormulations(); }

    void progressOnlyImproves()
    {
        QFETCH(Formulation, formulation);
        const TvpProblem problem = randomProblem(9, 6, 2, Route::Closed);
        const double best = bruteForce(problem).objective;
        std::vector<SolveProgress> seen;
        SolveOptions options;
        options.hint = {inNodeOrder(problem)};
        options.onProgress = [&seen](const SolveProgress& progress) { seen.push_back(progress); };
        const SolveOutcome outcome = CbcSolver(formulation).solve(problem, options);
        QVERIFY(!seen.empty());
        double last = objective(problem, options.hint.front());
        for (const SolveProgress& progress : seen) {
            QVERIFY(isVisitOrder(problem, progress.plan.front()));
            QCOMPARE(progress.objective, objective(problem, progress.plan.front()));
            QVERIFY(progress.objective <= last);
            QVERIFY(!progress.bound || *progress.bound <= best + toleranceOf(problem, best));
            last = progress.objective;
        }
        QCOMPARE(last, outcome.objective);
    }

    void whatACallbackThrowsReachesTheCaller()
    {
        SolveOptions options;
        options.onProgress = [](const SolveProgress&) { throw std::runtime_error("no more"); };
        QVERIFY_THROWS_EXCEPTION(
            std::runtime_error,
            static_cast<void>(CbcSolver(kEndlessFormulation).solve(endless(), options)));
    }

    void fourThreadsSolveAtOnce()
    {
        const CbcSolver position(Formulation::Position);
        const CbcSolver printed(Formulation::Printed);
        for (std::uint64_t round = 0; round < 5; ++round) {
            std::vector<TvpProblem> problems;
            std::vector<SolveOutcome> outcomes(4);
            for (std::uint64_t i = 0; i < 4; ++i)
                problems.push_back(randomProblem(10 * round + i, i == 3 ? 5 : 8, 1, Route::Open));
            {
                std::vector<std::jthread> threads;
                for (std::size_t i = 0; i < 4; ++i)
                    threads.emplace_back([&, i] {
                        outcomes[i] = (i == 3 ? printed : position).solve(problems[i], {});
                    });
            }
            for (std::size_t i = 0; i < 4; ++i) {
                QCOMPARE(outcomes[i].status, SolveStatus::Optimal);
                const double best = bruteForce(problems[i]).objective;
                COMPARE_NEAR(outcomes[i].objective, best, toleranceOf(problems[i], best));
            }
        }
    }

    void writesNothing()
    {
        const TvpProblem problem = randomProblem(6, 9, 3, Route::Open);
        long written = 0;
        {
            const Capture out(STDOUT_FILENO);
            const Capture err(STDERR_FILENO);
            SolveOptions options;
            options.hint = {inNodeOrder(problem)};
            static_cast<void>(CbcSolver(Formulation::Position).solve(problem, options));
            options.workLimit = 200;
            static_cast<void>(CbcSolver(Formulation::Printed).solve(problem, options));
            options.workLimit.reset();
            options.timeLimit_s = 0.05;
            static_cast<void>(CbcSolver(kEndlessFormulation).solve(endless(), options));
            written = out.written() + err.written();
        }
        QCOMPARE(written, 0L);
    }

    void unsupportedProblemsAreNamed_data()
    {
        QTest::addColumn<Formulation>("formulation");
        QTest::addColumn<int>("icebergs");
        QTest::addColumn<QString>("reason");
        QTest::newRow("position, 40") << Formulation::Position << 40 << QString();
        QTest::newRow("position, 41")
            << Formulation::Position << 41
            << QStringLiteral(
                   "the MILP formulation position is offered for at most 40 icebergs, not for 41");
        QTest::newRow("printed, 60") << Formulation::Printed << 60 << QString();
        QTest::newRow("printed, 61")
            << Formulation::Printed << 61
            << QStringLiteral(
                   "the MILP formulation printed is offered for at most 60 icebergs, not for 61");
        QTest::newRow("reduced, 60") << Formulation::Reduced << 60 << QString();
        QTest::newRow("reduced, 61")
            << Formulation::Reduced << 61
            << QStringLiteral(
                   "the MILP formulation reduced is offered for at most 60 icebergs, not for 61");
    }

    void unsupportedProblemsAreNamed()
    {
        QFETCH(Formulation, formulation);
        QFETCH(int, icebergs);
        QFETCH(QString, reason);
        const TvpProblem problem = randomProblem(1, icebergs, 1, Route::Open);
        const CbcSolver solver(formulation);
        const std::optional<IssueReason> why = solver.unsupportedReason(problem);
        QCOMPARE(why.has_value(), !reason.isEmpty());
        if (!why)
            return;
        QCOMPARE(QString::fromStdString(englishText(*why)), reason);
        const SolveOutcome outcome = solver.solve(problem, {});
        QCOMPARE(outcome.status, SolveStatus::None);
        QCOMPARE(outcome.reason, StopReason::Unable);
        QCOMPARE(QString::fromStdString(outcome.detail), reason);
    }
};

QTEST_APPLESS_MAIN(TestCbcSolver)
#include "tst_cbc_solver.moc"
