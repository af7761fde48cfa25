#include "tests/support/approx.h"
#include "tests/support/expect_error.h"
#include "tests/support/plan/solver_contestants.h"

#include <algorithm>
#include <thread>

using namespace berg;
using namespace berg::test;

namespace {

/** Small problems with something odd about them, by name. */
std::vector<std::pair<const char*, TvpProblem>> oddProblems()
{
    const auto problem = [](int icebergs, double tau, Route route = Route::Open) {
        return test::randomProblem(51, icebergs, tau, route, route == Route::Closed);
    };
    std::vector<std::pair<const char*, TvpProblem>> odd{
        {"no iceberg", problem(0, 1)},
        {"no iceberg, closed", problem(0, 1, Route::Closed)},
        {"one iceberg", problem(1, 1)},
        {"one iceberg, closed", problem(1, 1, Route::Closed)},
        {"two icebergs", problem(2, 1)},
        {"tau 0", problem(6, 0)},
        {"tau 0, closed", problem(6, 0, Route::Closed)},
        {"tau 100", problem(6, 100)},
        {"tau 100, closed", problem(6, 100, Route::Closed)},
        {"tiny mu", problem(6, 1e-9)},
    };
    TvpProblem ties = problem(6, 1);
    ties.distance_m.setConstant(1000);
    std::fill(ties.sigma_m2.begin() + 1, ties.sigma_m2.end(), 3.0);
    odd.emplace_back("all orders tie", ties);

    TvpProblem coincident = problem(6, 1);
    for (const int j : {3, 5}) {
        coincident.distance_m.row(j) = coincident.distance_m.row(1);
        coincident.distance_m.col(j) = coincident.distance_m.col(1);
    }
    for (const int i : {1, 3, 5})
        for (const int j : {1, 3, 5})
            coincident.distance_m(i, j) = 0;
    odd.emplace_back("three icebergs in one place", coincident);

    TvpProblem atUav = problem(5, 1, Route::Closed);
    atUav.distance_m.setZero();
    odd.emplace_back("all in one place, mu not 0", atUav);

    TvpProblem someZero = problem(6, 1);
    someZero.sigma_m2[2] = someZero.sigma_m2[5] = 0;
    odd.emplace_back("two sigmas zero", someZero);

    for (const Route route : {Route::Open, Route::Closed}) {
        TvpProblem zero = problem(6, 1, route);
        std::fill(zero.sigma_m2.begin(), zero.sigma_m2.end(), 0.0);
        zero.mu = tuningWeight(zero, 1).mu;
        odd.emplace_back(route == Route::Open ? "all sigmas zero" : "all sigmas zero, closed",
                         zero);
    }
    TvpProblem nothing = problem(4, 1);
    std::fill(nothing.sigma_m2.begin(), nothing.sigma_m2.end(), 0.0);
    nothing.distance_m.setZero();
    odd.emplace_back("nothing costs anything", nothing);
    return odd;
}

/** sum sigma_i t_i, t_i the distance flown until iceberg i. */
double waiting(const TvpProblem& problem, const VisitOrder& order)
{
    double sum = 0;
    double flown_m = 0;
    NodeIndex at;
    for (const NodeIndex next : order) {
        flown_m += legBetween(problem.distance_m, at, next);
        sum += problem.sigma_m2[toIndex(next)] * flown_m;
        at = next;
    }
    return sum;
}

} // namespace

/** Requirements on every back end, without limits. A new back end gets a row in `kAll`. */
class TestSolverConformance : public QObject
{
    Q_OBJECT

private slots:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    /** This build has the back ends it was configured with, so no row is missing silently. */
    void buildHasTheExpectedBackEnds()
    {
        for (const BenchmarkEntry& contestant : kAll)
            if (contestant.backend)
                QCOMPARE(made(contestant)->source(), sourceOf(*contestant.backend));
        const bool unsupported =
            test::codeOf([] { (void)makeSolver(Backend::Cbc); }) == "Unsupported";
        QCOMPARE(unsupported, BERG_EXPECT_CBC == 0);
    }

    // Optima ------------------------------------------------------------------------------------

    void findsTheOptimum_data()
    {
        QTest::addColumn<int>("contestant");
        QTest::addColumn<int>("icebergs");
        QTest::addColumn<bool>("closed");
        QTest::addColumn<bool>("asymmetric");
        forEach([](int index, const char* name) {
            for (int n = 1; n <= 8; ++n)
                for (const bool closed : {false, true})
                    for (const bool asymmetric : {false, true})
                        QTest::addRow("%s, %d icebergs, %s, %s", name, n,
                                      closed ? "closed" : "open",
                                      asymmetric ? "asymmetric" : "symmetric")
                            << index << n << closed << asymmetric;
        });
    }

    void findsTheOptimum()
    {
        QFETCH(int, icebergs);
        QFETCH(bool, closed);
        QFETCH(bool, asymmetric);
        for (const double tau : {0.5, 1.0, 3.0}) {
            const TvpProblem problem =
                test::randomProblem(static_cast<std::uint64_t>(60 + icebergs), icebergs, tau,
                                    closed ? Route::Closed : Route::Open, asymmetric);
            const SolveOutcome outcome = solver()->solve(problem, {});
            const double optimum = test::bruteForce(problem).objective;
            QCOMPARE(faultOf(contestant(), problem, outcome, optimum), QString());
            QVERIFY(outcome.status == SolveStatus::Optimal || !contestant().proves);
            QVERIFY(outcome.reason == StopReason::Finished);
        }
    }

    /** Tests latency against every order; only CBC does not support it, and reports so. */
    void findsTheOptimumByLatency_data() { solvers_data(); }
    void findsTheOptimumByLatency()
    {
        for (int icebergs = 1; icebergs <= 7; ++icebergs) {
            TvpProblem problem = test::randomProblem(static_cast<std::uint64_t>(80 + icebergs),
                                                     icebergs, 0, Route::Open, icebergs % 2 == 0);
            problem.criterion = Criterion::Latency;
            problem.mu = 1;
            QCOMPARE(solver()->unsupportedReason(problem).has_value(),
                     contestant().backend == Backend::Cbc);
            if (contestant().backend == Backend::Cbc)
                continue;
            VisitOrder order = ascendingOrder(icebergs);
            double least = waiting(problem, order);
            while (std::next_permutation(order.begin(), order.end()))
                least = std::min(least, waiting(problem, order));
            const SolveOutcome outcome = solver()->solve(problem, {});
            QVERIFY(outcome.status == SolveStatus::Optimal);
            COMPARE_NEAR(outcome.objective, least, 1e-9 * (1 + least));
            QVERIFY(outcome.bound == outcome.objective);
            COMPARE_NEAR(waiting(problem, outcome.order()), least, 1e-9 * (1 + least));
        }
    }

    void copesWithOddProblems_data()
    {
        QTest::addColumn<int>("contestant");
        QTest::addColumn<TvpProblem>("problem");
        forEach([](int index, const char* name) {
            for (const auto& [what, problem] : oddProblems())
                QTest::addRow("%s, %s", name, what) << index << problem;
        });
    }

    void copesWithOddProblems()
    {
        QFETCH(TvpProblem, problem);
        const SolveOutcome outcome = solver()->solve(problem, {});
        const double optimum = test::bruteForce(problem).objective;
        QCOMPARE(faultOf(contestant(), problem, outcome, optimum), QString());
        QVERIFY(outcome.status == SolveStatus::Optimal || !contestant().proves);
    }

    /** At sizes too large to try out all orders, the back ends check each other. */
    void agreesWithTheDynamicProgramme_data()
    {
        QTest::addColumn<int>("contestant");
        QTest::addColumn<int>("icebergs");
        forEach([](int index, const char* name) {
            const bool cbc = kAll[static_cast<std::size_t>(index)].backend == Backend::Cbc;
            for (int n = 9; n <= (cbc ? 11 : 14); ++n)
                QTest::addRow("%s, %d icebergs", name, n) << index << n;
        });
    }

    void agreesWithTheDynamicProgramme()
    {
        QFETCH(int, icebergs);
        for (const Route route : {Route::Open, Route::Closed}) {
            const TvpProblem problem =
                test::randomProblem(static_cast<std::uint64_t>(80 + icebergs), icebergs, 1.0, route,
                                    route == Route::Closed);
            const SolveOutcome exact = makeSolver(Backend::Exact)->solve(problem, {});
            const SolveOutcome outcome = solver()->solve(problem, {});
            QCOMPARE(faultOf(contestant(), problem, outcome, exact.objective), QString());
            QVERIFY(outcome.status == SolveStatus::Optimal || !contestant().proves);
        }
    }

    // Hints -------------------------------------------------------------------------------------

    void takesGoodAndBadHints_data() { solvers_data(); }
    void takesGoodAndBadHints()
    {
        const TvpProblem problem = test::randomProblem(90, 7, 1, Route::Closed, true);
        const test::BruteForce best = test::bruteForce(problem);
        VisitOrder worst = ascendingOrder(7);
        for (VisitOrder order = worst; std::next_permutation(order.begin(), order.end());)
            if (objective(problem, order) > objective(problem, worst))
                worst = order;
        for (const VisitOrder& hint : {best.order, worst}) {
            const SolveOutcome outcome = solver()->solve(problem, hinted(hint));
            QCOMPARE(faultOf(contestant(), problem, outcome, best.objective), QString());
            QVERIFY(outcome.status == SolveStatus::Optimal || !contestant().proves);
        }
        const SolveOutcome outcome = solver()->solve(problem, hinted(best.order));
        QCOMPARE(outcome.objective, objective(problem, best.order));
    }

    void ignoresInvalidHints_data()
    {
        QTest::addColumn<int>("contestant");
        QTest::addColumn<VisitOrder>("hint");
        forEach([](int index, const char* name) {
            QTest::addRow("%s, too short", name) << index << VisitOrder{1, 2};
            QTest::addRow("%s, twice the same", name) << index << VisitOrder{1, 2, 3, 3, 5};
            QTest::addRow("%s, the UAV in it", name) << index << VisitOrder{0, 1, 2, 3, 4};
            QTest::addRow("%s, of another problem", name) << index << VisitOrder{9, 8, 7, 6, 5};
        });
    }

    void ignoresInvalidHints()
    {
        QFETCH(VisitOrder, hint);
        const TvpProblem problem = test::randomProblem(91, 5, 1, Route::Open);
        const SolveOutcome outcome = solver()->solve(problem, hinted(hint));
        QVERIFY(!outcome.hintUsed);
        QVERIFY(same(outcome, solver()->solve(problem, {})));
    }

    // Conduct -----------------------------------------------------------------------------------

    void reportsOnlyWhatIsTrue_data() { solvers_data(); }
    void reportsOnlyWhatIsTrue()
    {
        const TvpProblem problem = test::randomProblem(96, 8, 1, Route::Open);
        const double optimum = test::bruteForce(problem).objective;
        const double margin = contestant().tolerance * (optimum + objectiveShift(problem));
        std::vector<SolveProgress> reports;
        SolveOptions options;
        options.onProgress = [&](const SolveProgress& report) { reports.push_back(report); };
        const SolveOutcome outcome = solver()->solve(problem, options);
        QVERIFY(!reports.empty());
        double last = std::numeric_limits<double>::infinity();
        for (const SolveProgress& report : reports) {
            QVERIFY(!report.bound || *report.bound <= optimum + margin);
            if (report.plan.front().empty())
                continue;
            QVERIFY(isVisitOrder(problem, report.plan.front()));
            COMPARE_NEAR(report.objective, objective(problem, report.plan.front()), 1e-9);
            QVERIFY(report.objective <= last + 1e-9);
            last = report.objective;
        }
        QVERIFY(outcome.objective <= last + 1e-9);
    }

    void sameProblemSameAnswer_data() { solvers_data(); }
    void sameProblemSameAnswer()
    {
        for (std::uint64_t seed = 100; seed < 104; ++seed) {
            const TvpProblem problem = test::randomProblem(seed, 7, 1, Route::Closed, true);
            const SolveOutcome first = solver()->solve(problem, {});
            QVERIFY(same(first, solver()->solve(problem, {})));
        }
    }

    /**
     * One object on four threads with different problems gives the same results as one after the
     * other.
     */
    void solvesConcurrently_data() { solvers_data(); }
    void solvesConcurrently()
    {
        constexpr std::size_t kThreads = 4;
        const std::unique_ptr<TvpSolver> shared = solver();
        std::vector<TvpProblem> problems;
        for (std::size_t k = 0; k < kThreads; ++k)
            problems.push_back(test::randomProblem(110 + k, 6 + static_cast<int>(k % 3), 1,
                                                   k % 2 ? Route::Open : Route::Closed));
        std::array<SolveOutcome, kThreads> together;
        {
            std::vector<std::jthread> threads;
            for (std::size_t k = 0; k < kThreads; ++k)
                threads.emplace_back([&, k] { together[k] = shared->solve(problems[k], {}); });
        }
        for (std::size_t k = 0; k < kThreads; ++k)
            QVERIFY(same(together[k], shared->solve(problems[k], {})));
    }

    void refusesInvalidProblems_data()
    {
        QTest::addColumn<int>("contestant");
        QTest::addColumn<QString>("field");
        QTest::addColumn<TvpProblem>("problem");
        forEach([](int index, const char* name) {
            const auto row = [&](const char* field, auto&& change) {
                TvpProblem problem = test::randomProblem(120, 4, 1, Route::Open);
                change(problem);
                QTest::addRow("%s, %s", name, field)
                    << index << QString::fromLatin1(field) << problem;
            };
            const double nan = std::numeric_limits<double>::quiet_NaN();
            row("sigma", [](TvpProblem& p) { p.sigma_m2.clear(); });
            row("sigma[0]", [](TvpProblem& p) { p.sigma_m2[0] = 2; });
            row("sigma[2]", [](TvpProblem& p) { p.sigma_m2[2] = -1; });
            row("distance_m", [](TvpProblem& p) { p.distance_m.resize(2, 2); });
            row("distance_m[1][3]", [&](TvpProblem& p) { p.distance_m(1, 3) = nan; });
            row("mu", [](TvpProblem& p) { p.mu = -0.5; });
        });
    }

    void refusesInvalidProblems()
    {
        QFETCH(QString, field);
        QFETCH(TvpProblem, problem);
        const std::optional<Error> error =
            test::errorOf([&] { (void)solver()->solve(problem, {}); });
        QVERIFY(error.has_value());
        QVERIFY(error->code() == ErrorCode::InvalidInput);
        QVERIFY(test::names(error->issues(), field.toStdString()));
    }
};

QTEST_APPLESS_MAIN(TestSolverConformance)
#include "tst_solver_conformance.moc"
