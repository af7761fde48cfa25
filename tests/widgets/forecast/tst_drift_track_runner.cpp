#include "core/presets/presets.h"
#include "tests/support/window/panel_test.h"
#include "tests/support/window/patience.h"
#include "widgets/forecast/drift_track_runner.h"

#include <QSignalSpy>

using namespace berg;
using test::kPatience_ms;

namespace {

constexpr double kEvery_s = 10800;

bool isKnown(const DriftTrackRunner& runner)
{
    return QTest::qWaitFor([&] { return runner.tracks() != nullptr; }, kPatience_ms);
}

} // namespace

class TestDriftTrackRunner : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void tracksAreThoseOfTheCore()
    {
        const Scenario scenario = randomScenario(2, {.icebergs = 3});
        DriftTrackRunner runner;
        runner.setScenario(scenario, kEvery_s);
        QVERIFY(!runner.tracks());
        QVERIFY(isKnown(runner));
        const std::vector<DriftTrack> expected = driftTracks(scenario, {.every_s = kEvery_s});
        QCOMPARE(runner.tracks()->size(), expected.size());
        QCOMPARE(runner.tracks()->at(2).points.back().position_m,
                 expected[2].points.back().position_m);
    }

    void onlyChangesOfTheDriftMatter()
    {
        Scenario scenario = randomScenario(2, {.icebergs = 3});
        DriftTrackRunner runner;
        runner.setScenario(scenario, kEvery_s);
        QVERIFY(isKnown(runner));
        QSignalSpy updated(&runner, &DriftTrackRunner::updated);
        scenario.name = "another";
        scenario.planner.tau = 2;
        runner.setScenario(scenario, kEvery_s);
        QCOMPARE(updated.count(), 0);
        scenario.current_mps = {0.5, 0};
        runner.setScenario(scenario, kEvery_s);
        QCOMPARE(updated.count(), 1); // dropped
        QVERIFY(!runner.tracks());
        QVERIFY(isKnown(runner));
        runner.clear();
        QVERIFY(!runner.tracks());
    }

    /** The map shows something at all times of a flight, and the newest instant in the end. */
    void tracksStayUntilThoseOfTheNewestInstantAreKnown()
    {
        const Scenario scenario = randomScenario(2, {.icebergs = 3});
        DriftTrackRunner runner;
        runner.setScenario(scenario, kEvery_s);
        QVERIFY(isKnown(runner));
        DriftInstant instant{.icebergs = scenario.icebergs, .tracks = {}};
        for (const Iceberg& iceberg : scenario.icebergs)
            instant.tracks.emplace_back(initialTrack(iceberg, scenario.observer.model));
        for (const double time_s : {10.0, 20.0, 30.0, 40.0}) {
            instant.time_s = time_s;
            runner.setInstant(scenario, instant, kEvery_s);
            QVERIFY(runner.tracks());
        }
        QTRY_COMPARE_WITH_TIMEOUT(runner.tracks()->front().points.front().time_s, 40.0,
                                  kPatience_ms);
        runner.setScenario(scenario, kEvery_s);
        QVERIFY(!runner.tracks());
        QVERIFY(isKnown(runner));
        QCOMPARE(runner.tracks()->front().points.front().time_s, 0.0);
    }
};

QTEST_GUILESS_MAIN(TestDriftTrackRunner)
#include "tst_drift_track_runner.moc"
