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
};

QTEST_GUILESS_MAIN(TestDriftTrackRunner)
#include "tst_drift_track_runner.moc"
