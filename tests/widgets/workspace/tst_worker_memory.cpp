// Lack of memory on the threads that plan, fly and read. A program of its own, because it replaces
// `new` by one that fails where the test requires.

#include "core/io/files/scenario_json.h"
#include "core/presets/presets.h"
#include "tests/support/window/patience.h"
#include "tests/support/window/study_builder.h"
#include "widgets/flight/flight_record.h"
#include "widgets/flight/mission_runner.h"
#include "widgets/forecast/curve_runner.h"
#include "widgets/forecast/policy_forecasts.h"
#include "widgets/sightings/import_runner.h"
#include "widgets/study/benchmark_runner.h"
#include "widgets/study/run_list.h"
#include "widgets/study/study_files.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

/** Smaller allocations succeed as long as a program can continue at all. */
constexpr std::size_t kLarge_bytes = 200;

std::atomic<long> untilFailure{-1}; ///< number of large allocations that still succeed; −1 for all
std::atomic<int> failures{0};
thread_local bool isSpared = false; ///< true on the GUI thread

} // namespace

void* operator new(std::size_t size)
{
    if (size >= kLarge_bytes && !isSpared && untilFailure.load() >= 0 &&
        untilFailure.fetch_sub(1) == 0) {
        ++failures;
        throw std::bad_alloc();
    }
    if (void* piece = std::malloc(size == 0 ? 1 : size))
        return piece;
    throw std::bad_alloc();
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
    return std::malloc(size == 0 ? 1 : size); // temporary buffers manage without it
}

// Not inlined: GCC 14 would see a piece of `new` freed by `free`, and warn of it.
[[gnu::noinline]] void operator delete(void* piece) noexcept
{
    std::free(piece);
}

[[gnu::noinline]] void operator delete(void* piece, std::size_t) noexcept
{
    std::free(piece);
}

using namespace berg;
using namespace Qt::StringLiterals;
using test::kPatience_ms;

namespace {

/** Lets the allocations of other threads fail one after the other, each in a run of `act`. */
template <class Act>
bool survives(const Act& act)
{
    if (!act()) // starts the threads, which need their memory
        return false;
    failures = 0;
    for (const long n : {0L, 1L, 2L, 3L, 4L, 5L, 7L, 10L, 15L, 20L, 30L, 50L, 100L, 200L}) {
        untilFailure = n;
        const bool ended = act();
        untilFailure = -1;
        if (!ended)
            return false;
    }
    return failures > 0; // otherwise nothing was tried
}

Scenario quick()
{
    return test::quickScenario();
}

} // namespace

class TestWorkerMemory : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { isSpared = true; }

    void missionsSurviveLackOfMemory()
    {
        MissionRunner runner;
        FlightRecord record;
        const auto flies = [&] {
            runner.setScenario(quick());
            runner.stepBy(60);
            return QTest::qWaitFor(
                [&] {
                    if (std::optional<MissionSnapshot> snapshot = runner.acceptSnapshot())
                        record.accept(std::move(*snapshot));
                    return record.now.generation == runner.generation() &&
                           (record.now.phase == RunPhase::Failed || record.now.time_s >= 60);
                },
                kPatience_ms);
        };
        QVERIFY(survives(flies));
        QVERIFY(flies()); // and still works
        QVERIFY(record.now.phase != RunPhase::Failed);
    }

    void exportsSurviveLackOfMemory()
    {
        MissionRunner runner;
        runner.setScenario(quick());
        QSignalSpy ready(&runner, &MissionRunner::exportReady);
        QSignalSpy refused(&runner, &MissionRunner::commandRefused);
        QSignalSpy previewed(&runner, &MissionRunner::exportPreviewReady);
        QVERIFY(survives([&] {
            for (QSignalSpy* spy : {&ready, &refused, &previewed})
                spy->clear();
            runner.requestExport({.formatId = "geojson"});
            runner.requestExportPreview({.formatId = "kml"});
            return QTest::qWaitFor(
                [&] { return ready.count() + refused.count() == 1 && previewed.count() == 1; },
                kPatience_ms);
        }));
    }

    void studiesSurviveLackOfMemory()
    {
        StudyRunner runner;
        QSignalSpy finished(&runner, &StudyRunner::finished);
        QVERIFY(survives([&] {
            finished.clear();
            runner.start(test::quickStudy());
            return QTest::qWaitFor([&] { return finished.count() == 1; }, kPatience_ms);
        }));
    }

    void studyFilesSurviveLackOfMemory()
    {
        const QTemporaryDir folder;
        StudyFiles files;
        const StudyPointer study = test::fourCases();
        QSignalSpy saved(&files, &StudyFiles::saved);
        QSignalSpy failed(&files, &StudyFiles::failed);
        QVERIFY(survives([&] {
            saved.clear();
            failed.clear();
            files.save(study, {}, folder.filePath(u"a.bergstudy"_s));
            return QTest::qWaitFor([&] { return saved.count() + failed.count() == 1; },
                                   kPatience_ms);
        }));
    }

    void benchmarksSurviveLackOfMemory()
    {
        BenchmarkRunner runner;
        QSignalSpy finished(&runner, &BenchmarkRunner::finished);
        BenchmarkSpec spec;
        spec.sizes = {4, 6};
        spec.repeat = 1;
        spec.solvers = {{.backend = Backend::Exact}};
        QVERIFY(survives([&] {
            finished.clear();
            runner.start(spec);
            return QTest::qWaitFor([&] { return finished.count() == 1; }, kPatience_ms);
        }));
    }

    void comparedRunsSurviveLackOfMemory()
    {
        RunList runs;
        QSignalSpy finished(&runs, &RunList::finished);
        QVERIFY(survives([&] {
            finished.clear();
            runs.addFlown(quick(), quick().planner);
            return QTest::qWaitFor([&] { return finished.count() == 1; }, kPatience_ms);
        }));
    }

    void importsSurviveLackOfMemory()
    {
        const QTemporaryDir folder;
        ImportRunner runner;
        QSignalSpy ready(&runner, &ImportRunner::ready);
        QVERIFY(survives([&] {
            ready.clear();
            const QString path = folder.filePath(u"%1.csv"_s.arg(untilFailure.load()));
            QFile file(path);
            if (!file.open(QIODevice::WriteOnly))
                return false;
            file.write("id,lat,lon\n");
            for (int i = 0; i < 200; ++i)
                file.write(qPrintable(u"b%1,60.%1,-50\n"_s.arg(i)));
            file.close();
            runner.start({.path = path, .base = std::make_shared<const Scenario>(quick())}, true);
            return QTest::qWaitFor([&] { return ready.count() == 1; }, kPatience_ms);
        }));
    }
};

QTEST_GUILESS_MAIN(TestWorkerMemory)
#include "tst_worker_memory.moc"
