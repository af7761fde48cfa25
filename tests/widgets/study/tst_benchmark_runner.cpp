#include "tests/support/window/panel_test.h"
#include "tests/support/window/patience.h"
#include "widgets/study/benchmark_runner.h"

#include <QSignalSpy>

#include <memory>

using namespace berg;
using namespace Qt::StringLiterals;
using test::kPatience_ms;

namespace {

constexpr BenchmarkSolver kExact{.backend = Backend::Exact};
constexpr BenchmarkSolver kHeuristic{.backend = Backend::Heuristic};

/** Returns a benchmark of milliseconds. */
BenchmarkSpec brief()
{
    return {.sizes = {2, 4, 6}, .solvers = {kExact, kHeuristic}, .repeat = 3, .budget_s = 1000};
}

/** Returns a benchmark of hours. */
BenchmarkSpec endless()
{
    return {.sizes = {3, 5}, .solvers = {kExact}, .repeat = 1'000'000'000, .budget_s = 1e6};
}

} // namespace

class TestBenchmarkRunner : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void measuresAsTheCoreDoes()
    {
        BenchmarkRunner runner;
        QSignalSpy finished(&runner, &BenchmarkRunner::finished);
        QSignalSpy progress(&runner, &BenchmarkRunner::progress);
        runner.start(brief());
        QVERIFY(runner.isRunning());
        QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, kPatience_ms);
        QVERIFY(!runner.isRunning());
        QCOMPARE(finished.front().front().toString(), QString());
        QVERIFY(!progress.isEmpty());

        const std::vector<BenchmarkRow> expected = runBenchmark(brief(), {});
        QCOMPARE(runner.rows().size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            QCOMPARE(runner.rows()[i].icebergs, expected[i].icebergs);
            QVERIFY(runner.rows()[i].solver == expected[i].solver);
            QCOMPARE(runner.rows()[i].meanObjective, expected[i].meanObjective);
            QCOMPARE(runner.rows()[i].work, expected[i].work);
        }
    }

    void cancellingKeepsTheRows()
    {
        BenchmarkRunner runner;
        QSignalSpy finished(&runner, &BenchmarkRunner::finished);
        QSignalSpy progress(&runner, &BenchmarkRunner::progress);
        runner.start(endless());
        QTRY_VERIFY_WITH_TIMEOUT(progress.count() > 0, kPatience_ms);
        QVERIFY(progress.front()[0].toULongLong() > 0);
        QCOMPARE(progress.front()[1].toULongLong(), 2'000'000'000ULL);
        QCOMPARE(finished.count(), 0);
        runner.cancel();
        QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, kPatience_ms);
        QCOMPARE(runner.rows().size(), std::size_t{1});
        QVERIFY(runner.rows().front().instances > 0);
    }

    void newestStartWins()
    {
        BenchmarkRunner runner;
        QSignalSpy finished(&runner, &BenchmarkRunner::finished);
        runner.start(endless());
        runner.start(endless());
        runner.start(brief());
        QVERIFY(runner.rows().empty());
        QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, kPatience_ms);
        QCOMPARE(runner.rows().size(), std::size_t{6});
    }

    void startsAgainAfterCancelling()
    {
        BenchmarkRunner runner;
        QSignalSpy finished(&runner, &BenchmarkRunner::finished);
        runner.start(endless());
        runner.cancel();
        QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, kPatience_ms);
        runner.start(brief());
        QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 2, kPatience_ms);
        QCOMPARE(runner.rows().size(), std::size_t{6});
    }

    void knowsWhatIsUnsaved()
    {
        BenchmarkRunner runner;
        QCOMPARE(runner.unsaved_s(), 0.0);
        QSignalSpy finished(&runner, &BenchmarkRunner::finished);
        runner.start(brief());
        QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, kPatience_ms);
        QVERIFY(runner.unsaved_s() > 0);
        runner.noteSaved();
        QCOMPARE(runner.unsaved_s(), 0.0);
        runner.start(brief());
        QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 2, kPatience_ms);
        QVERIFY(runner.unsaved_s() > 0);
    }

    /** Closing does not wait for the current benchmark. */
    void closesWhileMeasuring()
    {
        auto runner = std::make_shared<BenchmarkRunner>();
        QSignalSpy progress(runner.get(), &BenchmarkRunner::progress);
        runner->start(endless());
        QTRY_VERIFY_WITH_TIMEOUT(progress.count() > 0, kPatience_ms);
        const std::weak_ptr<BenchmarkRunner> watched = runner;
        runner.reset();
        QVERIFY(watched.expired()); // the thread has ended: the destructor waits for it
    }
};

QTEST_MAIN(TestBenchmarkRunner)
#include "tst_benchmark_runner.moc"
