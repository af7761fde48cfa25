#include "core/io/export/content/export_content.h"
#include "core/presets/presets.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/window/patience.h"
#include "widgets/flight/flight_record.h"
#include "widgets/flight/mission_runner.h"

#include <QSignalSpy>
#include <QtTest>

#include <atomic>

using namespace berg;
using test::kPatience_ms;

namespace {

/** Takes snapshots into a record until one satisfies `wanted`. */
template <class Wanted>
bool follow(MissionRunner& runner, FlightRecord& record, const Wanted& wanted)
{
    return QTest::qWaitFor(
        [&] {
            if (std::optional<MissionSnapshot> snapshot = runner.acceptSnapshot())
                record.accept(std::move(*snapshot));
            return wanted(record);
        },
        kPatience_ms);
}

bool inPhase(MissionRunner& runner, FlightRecord& record, RunPhase phase)
{
    return follow(runner, record, [phase](const FlightRecord& r) { return r.now.phase == phase; });
}

/** Pages whose painting waits until the test releases it. */
struct SlowPaint
{
    std::atomic<bool> isLetGo{false};
    std::atomic<int> begun{0};

    void letGo()
    {
        isLetGo = true;
        isLetGo.notify_all();
    }

    [[nodiscard]] ExportPaint paint()
    {
        const auto wait = [this] {
            ++begun;
            isLetGo.wait(false);
        };
        const ExportPainting painting{.file =
                                          [wait] {
                                              wait();
                                              return std::string("page");
                                          },
                                      .image =
                                          [wait] {
                                              wait();
                                              return QImage(1, 1, QImage::Format_RGB32);
                                          }};
        return {.file = {}, .prepare = [painting](const ExportFormat&, const ExportContent&) {
                    return painting;
                }};
    }
};

/** Releases the paint even if the test fails before. */
struct Release
{
    explicit Release(SlowPaint& paint) : page(paint) {}
    ~Release() { page.letGo(); }
    Release(const Release&) = delete;
    Release& operator=(const Release&) = delete;
    SlowPaint& page;
};

} // namespace

class TestMissionRunner : public QObject
{
    Q_OBJECT

private slots:
    void plansWhatItIsGiven()
    {
        MissionRunner runner;
        FlightRecord record;
        const Scenario scenario = randomScenario(4);
        runner.setScenario(scenario);
        QVERIFY(inPhase(runner, record, RunPhase::Ready));
        QVERIFY(record.now.plan != nullptr);
        QCOMPARE(record.now.plan->uavs[0].order, planFromStart(scenario).uavs[0].order);
        QCOMPARE(record.now.time_s, 0.0);
    }

    /**
     * The window's zeta equals the command line's to the last digit, however the time is sliced.
     */
    void fliesAsTheCoreDoes()
    {
        for (const std::int64_t seed : {5, 6}) {
            MissionRunner runner;
            FlightRecord record;
            const Scenario scenario = randomScenario(seed);
            runner.setScenario(scenario);
            runner.fly(seed == 5 ? kFastestRate : FlightRate(20000));
            QVERIFY(inPhase(runner, record, RunPhase::Finished));

            Mission mission(scenario);
            mission.advance(scenario.duration_s);
            QVERIFY(record.now.metrics == mission.metrics());
            QVERIFY(record.now.world == mission.simulation().state());
            QCOMPARE(record.history.samples.size(), mission.recorder().samples().size());
            QCOMPARE(record.history.rows.size(), record.history.samples.size());
            for (std::size_t i = 0; i < record.history.samples.size(); ++i)
                QCOMPARE(record.history.samples[i].zeta_m2s,
                         mission.recorder().samples()[i].zeta_m2s);
        }
    }

    void newestScenarioWins()
    {
        MissionRunner runner;
        FlightRecord record;
        Scenario scenario = randomScenario(7);
        for (int i = 0; i < 200; ++i) {
            scenario.planner.tau = 0.01 * i;
            runner.setScenario(scenario);
        }
        QVERIFY(follow(runner, record, [&](const FlightRecord& r) {
            return r.now.generation == runner.generation() && r.now.phase == RunPhase::Ready;
        }));
        QCOMPARE(record.now.planner.tau, 0.01 * 199);
        QCOMPARE(record.now.plan->uavs[0].order, planFromStart(scenario).uavs[0].order);
    }

    void oldGenerationsAreNotReturned()
    {
        MissionRunner runner;
        QSignalSpy updated(&runner, &MissionRunner::updated);
        runner.setScenario(randomScenario(8));
        QTRY_VERIFY_WITH_TIMEOUT(updated.count() > 0, kPatience_ms);
        // The waiting snapshot belongs to the scenario before.
        runner.setScenario(randomScenario(9));
        while (const auto snapshot = runner.acceptSnapshot())
            QCOMPARE(snapshot->generation, runner.generation());
    }

    void pausesStepsAndRestarts()
    {
        MissionRunner runner;
        FlightRecord record;
        runner.setScenario(randomScenario(10));
        runner.fly(200);
        QVERIFY(follow(runner, record, [](const FlightRecord& r) { return r.now.time_s > 5; }));
        runner.pause();
        QVERIFY(inPhase(runner, record, RunPhase::Paused));
        const double paused_s = record.now.time_s;
        runner.stepBy(1);
        QVERIFY(follow(runner, record, [&](const FlightRecord& r) {
            return std::abs(r.now.time_s - paused_s - 1) < 1e-6;
        }));
        runner.restart();
        QVERIFY(inPhase(runner, record, RunPhase::Ready));
        QCOMPARE(record.now.time_s, 0.0);
        QCOMPARE(record.history.samples.size(), 1U);
    }

    /** A flight with interventions is saved as a run that replays bit for bit. */
    void interventionsReplay()
    {
        MissionRunner runner;
        FlightRecord record;
        runner.setScenario(randomScenario(11));
        runner.stepBy(100);
        for (int i = 0; i <= 30; ++i)
            runner.intervene({.tau = 0.1 * i}); // a drag: only some of these values are flown
        runner.stepBy(100);
        Iceberg added;
        added.id = "added";
        added.position_m = {2000, 6000};
        runner.intervene({.appears = added});
        runner.fly(kFastestRate);
        QVERIFY(inPhase(runner, record, RunPhase::Finished));
        QCOMPARE(record.now.icebergs.size(), 13U);
        QCOMPARE(record.now.planner.tau, 3.0);

        std::shared_ptr<const RunFile> run;
        connect(
            &runner, &MissionRunner::runReady, this,
            [&run](const QString&, const std::shared_ptr<const RunFile>& ready) { run = ready; });
        runner.requestRun();
        QTRY_VERIFY_WITH_TIMEOUT(run != nullptr, kPatience_ms);
        const RunFile read = runFromJson(runToJson(*run), "run");
        const Mission replayed = replay(read);
        QVERIFY(compareRun(read, runOf(replayed)).empty());
        QVERIFY(replayed.metrics() == record.now.metrics);
    }

    /** A busy thread handles several requests as one; the stored flight still comes back. */
    void storedFlightIsRestoredByABusyThread()
    {
        SlowPaint page;
        MissionRunner runner;
        const Release release(page);
        FlightRecord record;
        runner.setExportPaint(
            {.file = {}, .prepare = [&](const ExportFormat&, const ExportContent&) {
                 ++page.begun;
                 page.isLetGo.wait(false); // on the mission thread
                 return ExportPainting{.file = [] { return std::string(); }, .image = {}};
             }});
        const Scenario scenario = randomScenario(4);
        runner.setScenario(scenario);
        runner.stepBy(50);
        QVERIFY(follow(runner, record, [](const FlightRecord& r) { return r.now.time_s >= 50; }));
        const auto isBack = [&] {
            return follow(runner, record,
                          [&](const FlightRecord& r) {
                              return r.now.generation == runner.generation() &&
                                     r.now.phase != RunPhase::Planning;
                          }) &&
                   record.now.time_s >= 50;
        };
        runner.requestExport({.formatId = "map-png"});
        QTRY_COMPARE_WITH_TIMEOUT(page.begun.load(), 1, kPatience_ms);
        runner.restart(true);
        runner.setScenario(randomScenario(5));
        runner.restoreFlight(scenario, false);
        page.letGo();
        QVERIFY(isBack());
        runner.restart(true); // and once more, because it is stored only once
        runner.restoreFlight(scenario, true);
        QVERIFY(isBack());
    }

    /** The flight is stopped before the user has seen its continuation from an earlier time. */
    void unseenContinuationKeepsTheFlight()
    {
        MissionRunner runner;
        FlightRecord record;
        const Scenario scenario = randomScenario(4);
        runner.setScenario(scenario);
        runner.stepBy(50);
        QVERIFY(follow(runner, record, [](const FlightRecord& r) { return r.now.time_s >= 50; }));
        const QSignalSpy updated(&runner, &MissionRunner::updated);
        runner.continueFrom({.time_s = 20, .seenUntil_s = 50});
        QTRY_COMPARE_WITH_TIMEOUT(updated.count(), 1, kPatience_ms);
        runner.restart(true);
        QVERIFY(inPhase(runner, record, RunPhase::Ready));
        runner.restoreFlight(scenario, false);
        QVERIFY(inPhase(runner, record, RunPhase::Paused));
        QVERIFY(record.now.time_s >= 50);
    }

    void refusesWhatTheMissionRefuses()
    {
        MissionRunner runner;
        FlightRecord record;
        runner.setScenario(randomScenario(12));
        QSignalSpy refused(&runner, &MissionRunner::commandRefused);
        Iceberg twin;
        twin.id = "berg-1";
        runner.intervene({.appears = twin});
        QTRY_COMPARE_WITH_TIMEOUT(refused.count(), 1, kPatience_ms);
    }

    void aBrokenScenarioFailsWithItsError()
    {
        MissionRunner runner;
        FlightRecord record;
        Scenario scenario = randomScenario(13);
        scenario.icebergs[0].q_m2ps = -1;
        runner.setScenario(scenario);
        QVERIFY(inPhase(runner, record, RunPhase::Failed));
        QVERIFY(record.now.error.has_value());
        QCOMPARE(record.now.error->code(), ErrorCode::InvalidInput);
        runner.setScenario(randomScenario(13));
        QVERIFY(inPhase(runner, record, RunPhase::Ready));
    }

    /** An export writes the plan on screen without solving anything. */
    void exportsThePlanThereIs()
    {
        MissionRunner runner;
        FlightRecord record;
        const Scenario scenario = randomScenario(4, {.icebergs = 40});
        runner.setScenario(scenario, {.workLimit = 1});
        QVERIFY(inPhase(runner, record, RunPhase::Ready));
        const IcebergList order = record.now.plan->uavs[0].order;
        QVERIFY(order != planFromStart(scenario).uavs[0].order); // this plan would be better
        QSignalSpy ready(&runner, &MissionRunner::exportReady);
        runner.requestExport({.formatId = "csv"});
        QTRY_COMPARE_WITH_TIMEOUT(ready.count(), 1, kPatience_ms);
        Plan plan;
        plan.uavs.emplace_back().order = order;
        const auto files = ready.front().front().value<std::vector<ExportFile>>();
        QCOMPARE(files.front().content,
                 findExportFormat("csv")->write({.scenario = scenario, .plan = plan}));
    }

    /** After the scenario was replaced, neither the old plan nor the new one is exported. */
    void exportOfAScenarioThatWasReplaced()
    {
        MissionRunner runner;
        FlightRecord record;
        runner.setScenario(randomScenario(4));
        QVERIFY(inPhase(runner, record, RunPhase::Ready));
        QSignalSpy ready(&runner, &MissionRunner::exportReady);
        QSignalSpy previewed(&runner, &MissionRunner::exportPreviewReady);
        QSignalSpy refused(&runner, &MissionRunner::commandRefused);
        runner.requestExportPreview({.formatId = "csv"});
        runner.requestExport({.formatId = "csv"});
        runner.setScenario(randomScenario(5));
        QTRY_COMPARE_WITH_TIMEOUT(refused.count(), 1, kPatience_ms);
        QVERIFY(inPhase(runner, record, RunPhase::Ready));
        QCOMPARE(ready.count(), 0);
        QCOMPARE(previewed.count(), 0);
    }

    void fliesWhileAPageIsPainted()
    {
        SlowPaint page;
        MissionRunner runner;
        const Release release(page);
        FlightRecord record;
        runner.setExportPaint(page.paint());
        runner.setScenario(randomScenario(4));
        QSignalSpy ready(&runner, &MissionRunner::exportReady);
        runner.requestExport({.formatId = "map-png"});
        QTRY_COMPARE_WITH_TIMEOUT(page.begun.load(), 1, kPatience_ms);
        runner.stepBy(5);
        QVERIFY(follow(runner, record, [](const FlightRecord& r) { return r.now.time_s >= 5; }));
        QSignalSpy instants(&runner, &MissionRunner::instantUpdated);
        runner.requestInstant(2);
        QTRY_COMPARE_WITH_TIMEOUT(instants.count(), 1, kPatience_ms);
        QCOMPARE(ready.count(), 0);
        page.letGo();
        QTRY_COMPARE_WITH_TIMEOUT(ready.count(), 1, kPatience_ms);
    }

    void previewNobodyWantsAnyMore()
    {
        SlowPaint page;
        MissionRunner runner;
        const Release release(page);
        runner.setExportPaint(page.paint());
        runner.setScenario(randomScenario(4));
        QSignalSpy previewed(&runner, &MissionRunner::exportPreviewReady);
        runner.requestExportPreview({.formatId = "map-png"});
        QTRY_COMPARE_WITH_TIMEOUT(page.begun.load(), 1, kPatience_ms);
        runner.requestExportPreview({.formatId = "map-svg"});
        runner.cancelExportPreview();
        page.letGo();
        runner.requestExportPreview({.formatId = "map-pdf"}); // comes after all the others
        QTRY_COMPARE_WITH_TIMEOUT(previewed.count(), 1, kPatience_ms);
        const auto preview =
            previewed.front().front().value<std::shared_ptr<const berg::ExportPreview>>();
        QCOMPARE(preview->request.formatId, std::string("map-pdf"));
    }

    /** An exception on a thread does not end the program. */
    void paintThatFails()
    {
        MissionRunner runner;
        FlightRecord record;
        bool inTime = false;
        const auto noMemory = []() -> std::string { throw std::bad_alloc(); };
        runner.setExportPaint(
            {.file = {}, .prepare = [&](const ExportFormat&, const ExportContent&) {
                 if (inTime)
                     throw std::runtime_error("no paint");
                 return ExportPainting{.file = noMemory, .image = {}};
             }});
        runner.setScenario(randomScenario(4));
        QVERIFY(inPhase(runner, record, RunPhase::Ready));
        QSignalSpy refused(&runner, &MissionRunner::commandRefused);
        runner.requestExport({.formatId = "map-png"});
        QTRY_COMPARE_WITH_TIMEOUT(refused.count(), 1, kPatience_ms);
        QVERIFY(refused.takeFirst().front().toString().contains(QStringLiteral("memory")));
        inTime = true;
        runner.requestExport({.formatId = "map-png"});
        QTRY_COMPARE_WITH_TIMEOUT(refused.count(), 1, kPatience_ms);
        QVERIFY(refused.takeFirst().front().toString().contains(QStringLiteral("no paint")));
        runner.stepBy(1); // and the flight continues
        QVERIFY(follow(runner, record, [](const FlightRecord& r) { return r.now.time_s >= 1; }));
    }

    /** Closing does not wait for a solve: the stop token ends it. */
    void closesDuringASolve()
    {
        auto runner = std::make_shared<MissionRunner>();
        Scenario scenario = randomScenario(14, {.icebergs = 120, .size_m = {60000, 60000}});
        runner->setScenario(scenario);
        QSignalSpy updated(runner.get(), &MissionRunner::updated);
        QTRY_VERIFY_WITH_TIMEOUT(updated.count() > 0, kPatience_ms); // the first incumbent
        const std::weak_ptr<MissionRunner> watched = runner;
        runner.reset();
        QVERIFY(watched.expired()); // the thread has ended: the destructor waits for it
    }
};

QTEST_MAIN(TestMissionRunner)
#include "tst_mission_runner.moc"
