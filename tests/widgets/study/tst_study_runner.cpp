#include "core/base/solving_guard.h"
#include "core/io/study/study_json.h"
#include "core/io/text/atomic_file.h"
#include "tests/support/window/panel_test.h"
#include "tests/support/window/patience.h"
#include "tests/support/window/study_builder.h"
#include "widgets/study/study_estimate.h"
#include "widgets/study/study_files.h"

#include <QSignalSpy>
#include <QTemporaryDir>

#include <future>

using namespace berg;
using namespace Qt::StringLiterals;
using test::kPatience_ms;

namespace {

/** Returns the study flown by the core on another thread. */
Study flownByCore(const StudySpec& spec)
{
    return std::async(std::launch::async,
                      [&spec] {
                          Study study{.spec = spec, .outcomes = {}};
                          fly(study, {.threads = 1});
                          return study;
                      })
        .get();
}

struct StudyRunnerFixture
{
    StudyRunner runner;
    QSignalSpy finished{&runner, &StudyRunner::finished};
    QSignalSpy updated{&runner, &StudyRunner::updated};
    NoBlockingScope onThisThread;

    [[nodiscard]] bool ends(int times = 1)
    {
        return QTest::qWaitFor([&] { return finished.count() >= times; }, kPatience_ms);
    }
    [[nodiscard]] bool someAreFlown()
    {
        return QTest::qWaitFor([&] { return runner.flown() > 0; }, kPatience_ms);
    }
};

} // namespace

class TestStudyRunner : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void fliesAsTheCoreDoes()
    {
        const StudySpec spec = test::quickStudy();
        const Study expected = flownByCore(spec);
        StudyRunnerFixture f;
        f.runner.start(spec);
        QVERIFY(f.runner.isRunning());
        QCOMPARE(f.runner.count(), std::size_t{16});
        QVERIFY(f.ends());
        QVERIFY(!f.runner.isRunning() && f.runner.isComplete());
        QCOMPARE(f.finished.front().front().toString(), QString());
        QVERIFY(f.runner.result()->study == expected);
        QCOMPARE(f.runner.result()->summary.cases.size(), std::size_t{4});
        QCOMPARE(f.runner.result()->summary.reference, std::size_t{1}); // tau 1
        QVERIFY(f.runner.elapsed_s().has_value());
    }

    void resultsComeWhileItFlies()
    {
        StudyRunnerFixture f;
        f.runner.start(test::endlessStudy());
        QVERIFY(!f.runner.timeLeft_s());
        QVERIFY(f.someAreFlown());
        QVERIFY(f.runner.isRunning());
        QVERIFY(f.runner.flown() < f.runner.count());
        QVERIFY(*f.runner.timeLeft_s() > 0);
        f.runner.cancel();
        QVERIFY(f.ends());
    }

    void cancelKeepsAndCarryOnEnds()
    {
        StudySpec spec = test::quickStudy(4000);
        StudyRunnerFixture f;
        f.runner.start(spec);
        QVERIFY(f.someAreFlown());
        f.runner.cancel();
        QVERIFY(f.ends());
        const std::size_t flownBefore = f.runner.flown();
        QVERIFY(flownBefore > 0);
        const Study before = f.runner.result()->study;
        if (f.runner.isComplete())
            QSKIP("this machine is too fast to cancel it");

        // The rest of a study slightly longer than the part that was flownBefore.
        Study rest = before;
        rest.spec.runs = static_cast<int>(flownBefore / 4 + 3);
        rest.outcomes.resize(missionCount(rest.spec));
        f.runner.show(rest);
        QVERIFY(QTest::qWaitFor(
            [&] { return f.runner.result()->study.spec.runs == rest.spec.runs; }, kPatience_ms));
        QVERIFY(!f.runner.isComplete() && !f.runner.isRunning());
        f.runner.carryOn();
        QVERIFY(f.ends(2));
        QVERIFY(f.runner.isComplete());
        QVERIFY(f.runner.result()->study == flownByCore(rest.spec));
    }

    void newestStartWins()
    {
        StudyRunnerFixture f;
        f.runner.start(test::endlessStudy());
        f.runner.start(test::quickStudy());
        QVERIFY(f.ends());
        QCOMPARE(f.runner.result()->study.spec.name, std::string("Quick study"));
        QVERIFY(f.runner.isComplete());
    }

    void anotherReferenceIsComparedWith()
    {
        StudyRunnerFixture f;
        f.runner.start(test::quickStudy());
        QVERIFY(f.ends());
        f.runner.setReference(3);
        QVERIFY(QTest::qWaitFor([&] { return f.runner.result()->summary.reference == 3; },
                                kPatience_ms));
        QCOMPARE(f.runner.result()->summary.differences[3].relative.mean, 0.0);
        QVERIFY(f.runner.isComplete());
        QCOMPARE(f.finished.count(), 1); // nothing was flown
        f.runner.setReference(99);       // no such setting
        QCOMPARE(f.runner.result()->summary.reference, std::size_t{3});
    }

    void impossibleRunsAreReported()
    {
        StudySpec spec = test::quickStudy();
        spec.scenarios.front().duration_s = -1;
        StudyRunnerFixture f;
        f.runner.start(spec);
        QVERIFY(f.ends());
        QVERIFY(!f.finished.front().front().toString().isEmpty());
        QVERIFY(!f.runner.isRunning());
        QCOMPARE(f.runner.flown(), std::size_t{0});
    }

    void bestOfEachCaseIsCounted()
    {
        const StudyPointer result = test::fourCases();
        // A tie: the first one wins.
        QVERIFY((result->bestByCase == std::vector<std::size_t>{1, 2, 1, 3}));
        QVERIFY((result->bestIn == std::vector<std::size_t>{0, 2, 1, 1}));
    }

    void estimateGrowsWithTheStudy()
    {
        const double one_s = estimatedTime_s(test::quickStudy(1));
        QVERIFY(one_s > 0);
        QVERIFY(std::abs(estimatedTime_s(test::quickStudy(10)) / one_s - 10) < 1e-9);
        StudySpec coverage = test::quickStudy(1);
        coverage.policies.push_back(PolicyKind::Coverage);
        QVERIFY(estimatedTime_s(coverage) > 2 * one_s);
    }

    /** Closing does not wait for the current study. */
    void closesWhileFlying()
    {
        auto runner = std::make_shared<StudyRunner>();
        runner->start(test::endlessStudy());
        QVERIFY(QTest::qWaitFor([&] { return runner->flown() > 0; }, kPatience_ms));
        const std::weak_ptr<StudyRunner> watched = runner;
        runner.reset();
        QVERIFY(watched.expired()); // the thread has ended: the destructor waits for it
    }

    void filesComeBack()
    {
        const QTemporaryDir folder;
        const StudyPointer result = test::fourCases();
        StudyFiles files;
        QSignalSpy written(&files, &StudyFiles::written);
        QSignalSpy saved(&files, &StudyFiles::saved);
        QSignalSpy opened(&files, &StudyFiles::opened);
        QSignalSpy failed(&files, &StudyFiles::failed);
        files.save(result, {}, folder.filePath(u"a.bergstudy"_s));
        files.writeReport(result, 12.0, folder.filePath(u"a.html"_s));
        files.writeTable(result, folder.filePath(u"a.csv"_s));
        QTRY_COMPARE_WITH_TIMEOUT(written.count(), 2, kPatience_ms);
        QCOMPARE(saved.count(), 1); // one after the other
        QVERIFY(loadStudy(folder.filePath(u"a.bergstudy"_s).toStdString()) == result->study);
        QCOMPARE(QString::fromStdString(readFile(folder.filePath(u"a.csv"_s).toStdString()))
                     .count(u'\n'),
                 5); // a header and a row for each setting
        for (const QString& name : {u"a.bergstudy"_s, u"a.html"_s}) { // a report holds its study
            opened.clear();
            files.open(folder.filePath(name));
            QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, kPatience_ms);
            const auto study = opened.front().front().value<std::shared_ptr<const berg::Study>>();
            QVERIFY(*study == result->study);
        }
        files.open(folder.filePath(u"none.bergstudy"_s));
        QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, kPatience_ms);
        QVERIFY(failed.front().front().toString().contains(u"none.bergstudy"_s));
    }
};

QTEST_MAIN(TestStudyRunner)
#include "tst_study_runner.moc"
