#include "core/study/parallel.h"

#include <QtTest>

#include <atomic>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace berg;

namespace {

/** Exception of the job with this index. */
class JobFailure : public std::runtime_error
{
public:
    explicit JobFailure(std::size_t failedIndex)
        : std::runtime_error("job failed"), index(failedIndex)
    {
    }
    std::size_t index;
};

/** Most probably lets other threads go first. */
void giveWay()
{
    for (int k = 0; k < 200; ++k)
        std::this_thread::yield();
}

} // namespace

class TestParallel : public QObject
{
    Q_OBJECT

private:
    static void addThreads()
    {
        QTest::addColumn<std::optional<int>>("threads");
        for (int threads = 1; threads <= 8; ++threads)
            QTest::addRow("%d threads", threads) << std::optional<int>(threads);
        QTest::newRow("one per core") << std::optional<int>();
    }

private slots:
    void everyIndexOnce_data() { addThreads(); }

    void everyIndexOnce()
    {
        QFETCH(std::optional<int>, threads);
        for (const std::size_t count : {0U, 1U, 2U, 7U, 1000U}) {
            std::vector<std::atomic<int>> calls(count);
            const bool complete =
                forEachIndex(count, [&](std::size_t i) { ++calls.at(i); }, {.threads = threads});
            QVERIFY(complete);
            for (const std::atomic<int>& c : calls)
                QCOMPARE(c.load(), 1);
        }
    }

    /** Three jobs that wait for each other can only end if three threads run. */
    void jobsRunAtTheSameTime()
    {
        std::atomic<int> present{0};
        std::atomic<int> met{0};
        const auto waitForAll = [&](std::size_t) {
            ++present;
            for (int k = 0; present < 3 && k < 1000000; ++k) // or give up
                std::this_thread::yield();
            met += present == 3 ? 1 : 0;
        };
        QVERIFY(forEachIndex(3, waitForAll, {.threads = 3}));
        QCOMPARE(met.load(), 3);
    }

    void noMoreThreadsThanAskedFor_data() { addThreads(); }

    void noMoreThreadsThanAskedFor()
    {
        QFETCH(std::optional<int>, threads);
        if (!threads)
            return; // one per core of this machine
        std::mutex mutex;
        std::set<std::thread::id> seen;
        const auto note = [&](std::size_t) {
            const std::scoped_lock lock(mutex);
            seen.insert(std::this_thread::get_id());
        };
        QVERIFY(forEachIndex(200, note, {.threads = threads}));
        QVERIFY(!seen.empty());
        QVERIFY(seen.size() <= static_cast<std::size_t>(*threads));
        QVERIFY(!seen.contains(std::this_thread::get_id()));
    }

    void progressCountsUpOneAtATime_data() { addThreads(); }

    void progressCountsUpOneAtATime()
    {
        QFETCH(std::optional<int>, threads);
        std::vector<std::size_t> progress; // needs no lock: never called by two threads at once
        std::atomic<int> inside{0};
        bool overlapped = false;
        const auto onProgress = [&](std::size_t done) {
            overlapped = overlapped || ++inside != 1;
            progress.push_back(done);
            std::this_thread::yield();
            --inside;
        };
        QVERIFY(
            forEachIndex(500, [](std::size_t) {}, {.threads = threads, .onProgress = onProgress}));
        std::vector<std::size_t> expected(500);
        std::iota(expected.begin(), expected.end(), 1U);
        QVERIFY(progress == expected);
        QVERIFY(!overlapped);
    }

    void exceptionOfTheSmallestIndex_data() { addThreads(); }

    /** Every job from 5 on fails; the reported one must not depend on their order. */
    void exceptionOfTheSmallestIndex()
    {
        QFETCH(std::optional<int>, threads);
        for (int repeat = 0; repeat < 30; ++repeat) {
            std::atomic<int> begun{0};
            const bool smallestLast = repeat % 2 == 0;
            const auto job = [&](std::size_t i) {
                ++begun;
                if (i < 5)
                    return;
                if ((i == 5) == smallestLast)
                    giveWay();
                throw JobFailure(i);
            };
            try {
                (void)forEachIndex(10000, job, {.threads = threads});
                QFAIL("nothing thrown");
            } catch (const JobFailure& failure) {
                QCOMPARE(failure.index, std::size_t{5});
            }
            if (threads)
                QVERIFY(begun <= 5 + *threads);
        }
    }

    void restIsAbandonedAfterAFailure_data() { addThreads(); }

    void restIsAbandonedAfterAFailure()
    {
        QFETCH(std::optional<int>, threads);
        std::atomic<std::size_t> begun{0};
        constexpr std::size_t kCount = 100000;
        const auto job = [&](std::size_t i) {
            ++begun;
            if (i == 5)
                throw JobFailure(i);
            std::this_thread::yield(); // 100,000 chances to notice the failure
        };
        QVERIFY_THROWS_EXCEPTION(JobFailure, (void)forEachIndex(kCount, job, {.threads = threads}));
        QVERIFY(begun >= 6 && begun < kCount);
    }

    void oneThreadStopsAtTheFailure()
    {
        int begun = 0;
        const auto job = [&](std::size_t i) {
            ++begun;
            if (i == 5)
                throw JobFailure(i);
        };
        QVERIFY_THROWS_EXCEPTION(JobFailure, forEachIndex(100, job, {.threads = 1}));
        QCOMPARE(begun, 6);
    }

    void failureOfTheReportIsThrownHere_data() { addThreads(); }

    /** `onProgress` runs on the threads of the pool, where nothing would catch it. */
    void failureOfTheReportIsThrownHere()
    {
        QFETCH(std::optional<int>, threads);
        const auto onProgress = [](std::size_t done) {
            if (done == 3)
                throw JobFailure(done);
        };
        QVERIFY_THROWS_EXCEPTION(
            JobFailure, (void)forEachIndex(500, [](std::size_t) {},
                                           {.threads = threads, .onProgress = onProgress}));
    }

    void stopBeforeTheStart_data() { addThreads(); }

    void stopBeforeTheStart()
    {
        QFETCH(std::optional<int>, threads);
        std::stop_source source;
        source.request_stop();
        std::atomic<int> begun{0};
        QVERIFY(!forEachIndex(100, [&](std::size_t) { ++begun; },
                              {.threads = threads, .stop = source.get_token()}));
        QCOMPARE(begun.load(), 0);
    }

    void stopUnderWay_data() { addThreads(); }

    /** Jobs after number 10 end only after the stop request, so no thread starts a second one. */
    void stopUnderWay()
    {
        QFETCH(std::optional<int>, threads);
        std::stop_source source;
        std::atomic<int> begun{0};
        const auto job = [&](std::size_t i) {
            ++begun;
            if (i == 10)
                source.request_stop();
            while (i > 10 && !source.stop_requested())
                std::this_thread::yield();
        };
        QVERIFY(!forEachIndex(100000, job, {.threads = threads, .stop = source.get_token()}));
        QVERIFY(begun >= 11);
        if (threads)
            QVERIFY(begun <= 10 + *threads);
    }

    /** A stop during the last job comes after everything is done. */
    void stopAtTheEndIsComplete()
    {
        std::stop_source source;
        const auto job = [&](std::size_t i) {
            if (i == 9)
                source.request_stop();
        };
        QVERIFY(forEachIndex(10, job, {.threads = 1, .stop = source.get_token()}));
    }

    void resultDoesNotDependOnThreads()
    {
        std::vector<double> expected;
        for (int threads = 1; threads <= 8; ++threads) {
            std::vector<double> results(300);
            QVERIFY(
                forEachIndex(results.size(),
                             [&](std::size_t i) { results[i] = 1.0 / static_cast<double>(i + 1); },
                             {.threads = threads}));
            if (threads == 1)
                expected = results;
            QVERIFY(results == expected);
        }
        QCOMPARE(expected[299], 1.0 / 300);
    }
};

QTEST_APPLESS_MAIN(TestParallel)
#include "tst_parallel.moc"
