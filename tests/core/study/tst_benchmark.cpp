#include "core/study/benchmark.h"
#include "tests/support/approx.h"
#include "tests/support/plan/brute_force.h"

#include <algorithm>
#include <array>
#include <vector>

using namespace berg;

namespace {

constexpr BenchmarkSolver kExact{.backend = Backend::Exact};
constexpr BenchmarkSolver kHeuristic{.backend = Backend::Heuristic};

/** Mean and its standard error. */
struct Mean
{
    double sum = 0;
    double squares = 0;
    int n = 0;

    void add(double x)
    {
        sum += x;
        squares += x * x;
        ++n;
    }
    [[nodiscard]] double value() const { return sum / n; }
    [[nodiscard]] double error() const { return std::sqrt((squares / n - value() * value()) / n); }
};

} // namespace

class TestBenchmark : public QObject
{
    Q_OBJECT

private slots:
    void tableOneRanges_data()
    {
        QTest::addColumn<int>("icebergs");
        for (const int icebergs : {0, 1, 2, 12, 20})
            QTest::addRow("%d icebergs", icebergs) << icebergs;
    }

    void tableOneRanges()
    {
        QFETCH(int, icebergs);
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            const TvpProblem problem = tableOneProblem(seed, icebergs);
            QVERIFY(validate(problem).empty());
            QCOMPARE(problem.icebergCount(), icebergs);
            QCOMPARE(problem.route, Route::Open);
            QCOMPARE(problem.sigma_m2[0], 0.0);
            QVERIFY(problem.distance_m == problem.distance_m.transpose());
            for (int i = 1; i <= icebergs; ++i) {
                const double sigma_m2 = problem.sigma_m2[static_cast<std::size_t>(i)];
                QVERIFY(sigma_m2 >= 1 && sigma_m2 <= 10 && sigma_m2 == std::round(sigma_m2));
                // From (-500, -500) to the near and the far corner of the area.
                const double fromUav_m = problem.distance_m(0, i);
                QVERIFY(fromUav_m >= std::hypot(500, 500) && fromUav_m <= std::hypot(5500, 5500));
                for (int j = 1; j <= icebergs; ++j)
                    QVERIFY(problem.distance_m(i, j) <= std::hypot(5000, 5000));
            }
        }
    }

    /**
     * Positions are uniform in 5000 m x 5000 m, tested through distances with 5 standard errors.
     */
    void tableOneIsUniform()
    {
        Mean between_m2;
        Mean fromUav_m2;
        std::array<int, 11> sigmas{};
        constexpr int kProblems = 10000;
        for (std::uint64_t seed = 1; seed <= kProblems; ++seed) {
            const TvpProblem problem = tableOneProblem(seed, 2);
            between_m2.add(std::pow(problem.distance_m(1, 2), 2));
            fromUav_m2.add(std::pow(problem.distance_m(0, 2), 2));
            ++sigmas.at(static_cast<std::size_t>(problem.sigma_m2[1]));
        }
        // E|p - q|^2 = 2 L^2/6; E|p - u|^2 = 2 (5500^3 - 500^3)/(3 x 5000).
        COMPARE_NEAR(between_m2.value(), 5000.0 * 5000 / 3, 5 * between_m2.error());
        COMPARE_NEAR(fromUav_m2.value(), 2 * (1.66375e11 - 1.25e8) / 15000, 5 * fromUav_m2.error());
        QCOMPARE(sigmas[0], 0);
        for (std::size_t s = 1; s <= 10; ++s) // binomial with p = 1/10
            COMPARE_NEAR(1.0 * sigmas[s], kProblems / 10.0, 5 * std::sqrt(kProblems * 0.09));
    }

    /** Two icebergs: F1max = s1 + 2 s2 (s1 <= s2), D_est = mean distance x 2, tau = 0.5. */
    void tableOneTuning()
    {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            const TvpProblem problem = tableOneProblem(seed, 2);
            const double small = std::min(problem.sigma_m2[1], problem.sigma_m2[2]);
            const double large = std::max(problem.sigma_m2[1], problem.sigma_m2[2]);
            const double perimeter_m =
                problem.distance_m(0, 1) + problem.distance_m(1, 2) + problem.distance_m(2, 0);
            const double mu = 0.5 * (small + 2 * large) / (perimeter_m / 3 * 2);
            COMPARE_NEAR(problem.mu, mu, 1e-15);
            COMPARE_NEAR(tableOneProblem(seed, 2, 2).mu, 4 * mu, 1e-15);
        }
    }

    void sameSeedSameProblem()
    {
        const TvpProblem a = tableOneProblem(7, 12);
        const TvpProblem b = tableOneProblem(7, 12);
        QVERIFY(a.distance_m == b.distance_m && a.sigma_m2 == b.sigma_m2 && a.mu == b.mu);
        QVERIFY(a.distance_m != tableOneProblem(8, 12).distance_m);
    }

    void paperTableIsAsPrinted()
    {
        const std::vector<std::array<double, 3>> table2{
            {2, 0.02, 0.03},  {6, 0.18, 0.42},     {10, 0.64, 1.50},
            {12, 1.71, 4.24}, {16, 31.20, 145.16}, {20, 2969.69, 17269.17}};
        QCOMPARE(paperTable2().size(), table2.size());
        for (std::size_t i = 0; i < table2.size(); ++i) {
            QCOMPARE(paperTable2()[i].icebergs, static_cast<int>(table2[i][0]));
            QCOMPARE(paperTable2()[i].average_s, table2[i][1]);
            QCOMPARE(paperTable2()[i].worst_s, table2[i][2]);
        }
    }

    /** Rows have ascending sizes, each once, whatever the order given. */
    void rowsBySizeThenSolver()
    {
        std::vector<std::size_t> done;
        std::vector<std::size_t> finished;
        const BenchmarkSpec spec{
            .sizes = {5, 3, 5}, .solvers = {kExact, kHeuristic}, .repeat = 4, .budget_s = 1000};
        const std::vector<BenchmarkRow> rows =
            runBenchmark(spec, {}, [&](const BenchmarkProgress& progress) {
                done.push_back(progress.done);
                finished.push_back(progress.rows.size());
                QCOMPARE(progress.count, std::size_t{16});
            });
        QCOMPARE(rows.size(), std::size_t{4});
        QCOMPARE(done.size(), std::size_t{16});
        for (std::size_t i = 0; i < done.size(); ++i) {
            QCOMPARE(done[i], i + 1);
            QCOMPARE(finished[i], (i + 1) / 4);
        }
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const BenchmarkRow& row = rows[i];
            QCOMPARE(row.icebergs, i < 2 ? 3 : 5);
            QVERIFY(row.solver == (i % 2 == 0 ? kExact : kHeuristic));
            QCOMPARE(row.instances, 4);
            QCOMPARE(row.cut, 0);
            QCOMPARE(row.seconds.n, 4);
            QVERIFY(row.worst_s >= row.seconds.mean && row.seconds.mean >= 0);
            QVERIFY(row.note.empty());
        }
        for (const std::size_t exact : {0U, 2U}) {
            QCOMPARE(rows[exact].proven, 4);
            QVERIFY(rows[exact].worstGap == 0.0);
        }
    }

    /** Everything but the seconds repeats, and the objective is that of the optima. */
    void resultsRepeat()
    {
        const BenchmarkSpec spec{
            .sizes = {5, 7}, .solvers = {kExact, kHeuristic}, .repeat = 3, .budget_s = 1000};
        const std::vector<BenchmarkRow> first = runBenchmark(spec, {});
        const std::vector<BenchmarkRow> again = runBenchmark(spec, {});
        for (std::size_t i = 0; i < first.size(); ++i) {
            QCOMPARE(first[i].meanObjective, again[i].meanObjective);
            QCOMPARE(first[i].work, again[i].work);
            QCOMPARE(first[i].proven, again[i].proven);
            QCOMPARE(first[i].worstGap, again[i].worstGap);
            double sum = 0;
            for (std::uint64_t seed = 1; seed <= 3; ++seed)
                sum += test::bruteForce(tableOneProblem(seed, first[i].icebergs)).objective;
            COMPARE_NEAR(first[i].meanObjective, sum / 3, 1e-9);
            QVERIFY(first[i].work > 0);
        }
    }

    /** A solver that cannot finish a size gets no larger one; the others do. */
    void noLargerSizeAfterAnUnfinishedOne()
    {
        const BenchmarkSpec spec{.sizes = {3, 21, 22},
                                 .solvers = {kExact, kHeuristic},
                                 .repeat = 1000000,
                                 .budget_s = 0.2};
        const std::vector<BenchmarkRow> rows = runBenchmark(spec, {});
        QCOMPARE(rows.size(), std::size_t{6});
        QVERIFY(rows[0].note.empty() && rows[0].instances > 0);
        for (const std::size_t larger : {2U, 3U, 4U, 5U}) {
            QVERIFY(rows[larger].note.starts_with("not tried: 3 icebergs"));
            QCOMPARE(rows[larger].instances, 0);
        }
    }

    void everySolverHasAName()
    {
        for (const BenchmarkSolver& solver : benchmarkSolvers()) {
            const std::string name = nameOf(kBenchmarkSolverNames, solver);
            QVERIFY(!name.empty() && name != "auto");
            QVERIFY(valueOf(kBenchmarkSolverNames, name) == solver);
        }
        QVERIFY(benchmarkSolvers().front() == kExact);
    }

    /** Without any time nothing is solved and nothing waits. */
    void withoutBudgetNothingIsSolved()
    {
        const BenchmarkSpec spec{
            .sizes = {4, 12}, .solvers = {kExact, kHeuristic}, .repeat = 100000000, .budget_s = 0};
        const std::vector<BenchmarkRow> rows = runBenchmark(spec, {});
        QCOMPARE(rows.size(), std::size_t{4});
        for (const BenchmarkRow& row : rows) {
            QCOMPARE(row.instances, 0);
            QCOMPARE(row.proven, 0);
            QCOMPARE(row.cut, 0);
            QCOMPARE(row.seconds.n, 0);
            QVERIFY(!row.worstGap);
            QVERIFY(row.note.starts_with("not tried"));
        }
    }

    /** A small budget ends a benchmark that would take years. */
    void smallBudgetEnds()
    {
        const BenchmarkSpec spec{.sizes = {6, 30},
                                 .solvers = {kExact, kHeuristic},
                                 .repeat = 100000000,
                                 .budget_s = 0.2};
        const std::vector<BenchmarkRow> rows = runBenchmark(spec, {});
        QCOMPARE(rows.size(), std::size_t{4});
        for (const BenchmarkRow& row : rows) {
            QVERIFY(row.cut <= row.instances && row.proven <= row.instances);
            QVERIFY(row.seconds.n + row.cut == row.instances);
        }
    }

    void sizeBeyondABackEndIsNoted()
    {
        const BenchmarkSpec spec{
            .sizes = {500}, .solvers = {kExact}, .repeat = 3, .budget_s = 1000};
        const std::vector<BenchmarkRow> rows = runBenchmark(spec, {});
        QCOMPARE(rows.size(), std::size_t{1});
        QVERIFY(!rows[0].note.empty());
        QCOMPARE(rows[0].instances, 0);
        QVERIFY(!rows[0].worstGap);
    }

    void stopEndsEarly()
    {
        const BenchmarkSpec spec{.sizes = {3, 4, 5}, .solvers = {kExact}, .repeat = 2};
        std::stop_source before;
        before.request_stop();
        QVERIFY(runBenchmark(spec, before.get_token()).empty());
        std::stop_source under;
        const auto stopAfterThree = [&](const BenchmarkProgress& progress) {
            if (progress.done == 3)
                under.request_stop();
        };
        const std::vector<BenchmarkRow> rows =
            runBenchmark(spec, under.get_token(), stopAfterThree);
        QCOMPARE(rows.size(), std::size_t{2}); // rows so far are returned
        QCOMPARE(rows[0].instances, 2);
        QCOMPARE(rows[1].instances, 1);
        QCOMPARE(rows[1].seconds.n, 1);
    }

    /** The instances are those of seeds 1 to `repeat`: brute force finds the same optimum. */
    void instancesAreSolvable()
    {
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            const TvpProblem problem = tableOneProblem(seed, 5);
            const SolveOutcome outcome = makeSolver(Backend::Exact)->solve(problem, {});
            COMPARE_NEAR(outcome.objective, test::bruteForce(problem).objective, 1e-9);
        }
    }
};

QTEST_APPLESS_MAIN(TestBenchmark)
#include "tst_benchmark.moc"
