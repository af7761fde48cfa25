#include "core/scenario/presets.h"
#include "widgets/model/flight_record.h"
#include "widgets/model/mission_runner.h"

#include <QSignalSpy>
#include <QtTest>

using namespace berg;

namespace {

constexpr int kPatience_ms = 30000; // against a slow machine; nothing is measured

/** Takes snapshots into a record until one satisfies `wanted`. */
template <class Wanted>
bool follow(MissionRunner& runner, FlightRecord& record, const Wanted& wanted)
{
    return QTest::qWaitFor(
        [&] {
            if (std::optional<MissionSnapshot> snapshot = runner.takeSnapshot())
                record.take(std::move(*snapshot));
            return wanted(record);
        },
        kPatience_ms);
}

bool inPhase(MissionRunner& runner, FlightRecord& record, RunPhase phase)
{
    return follow(runner, record, [phase](const FlightRecord& r) { return r.now.phase == phase; });
}

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
        QVERIFY(record.now.plan.has_value());
        QCOMPARE(record.now.plan->order, planFromStart(scenario).order);
        QCOMPARE(record.now.time_s, 0.0);
    }

    /** The window's zeta is the command line's, to the last digit, however the time is sliced. */
    void fliesAsTheCoreDoes()
    {
        for (const std::int64_t seed : {5, 6}) {
            MissionRunner runner;
            FlightRecord record;
            const Scenario scenario = randomScenario(seed);
            runner.setScenario(scenario);
            runner.fly(seed == 5 ? 0 : 20000); // as fast as possible, or by the clock
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
        QCOMPARE(record.now.plan->order, planFromStart(scenario).order);
    }

    void oldGenerationsAreNotHandedOut()
    {
        MissionRunner runner;
        QSignalSpy updated(&runner, &MissionRunner::updated);
        runner.setScenario(randomScenario(8));
        QTRY_VERIFY_WITH_TIMEOUT(updated.count() > 0, kPatience_ms);
        runner.setScenario(randomScenario(9)); // the snapshot that waits is of the one before
        while (const auto snapshot = runner.takeSnapshot())
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
            runner.intervene({.tau = 0.1 * i}); // a drag: only some of these are flown
        runner.stepBy(100);
        Iceberg added;
        added.id = "added";
        added.position_m = {2000, 6000};
        runner.intervene({.appears = added});
        runner.fly(0);
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
