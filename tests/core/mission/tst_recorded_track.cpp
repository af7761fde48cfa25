#include "core/checks/validate.h"
#include "core/io/files/run_json.h"
#include "core/io/files/scenario_json.h"
#include "core/mission/mission_instant.h"
#include "core/mission/visits.h"
#include "core/presets/presets.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/flight/scenario_builder.h"

#include <QtTest>

#include <cmath>

using namespace berg;
using namespace berg::test;

namespace {

const RecordedTrack kTrack{.time_s = {10, 100, 160, 400},
                           .position_m = {{3000, 0}, {3090, 0}, {3090, 120}, {2850, 360}}};

/** A sea with noise whose second iceberg follows the track. */
Scenario seaWithTrack(double duration_s = 500)
{
    Scenario scenario = randomScenario(5, {.icebergs = 6});
    scenario.duration_s = duration_s;
    scenario.icebergs[1].position_m = {2980, 10};
    scenario.icebergs[1].velocity_mps = {0.3, 0.1};
    scenario.icebergs[1].track = kTrack;
    return scenario;
}

} // namespace

/** An iceberg with a recorded track is where the record says, while its estimate is not. */
class TestRecordedTrack : public QObject
{
    Q_OBJECT

private slots:
    /** Exported visits are at positions on the track. */
    void flownVisitsLieOnTheTrack()
    {
        Mission mission(seaWithTrack());
        mission.advance(500);
        int met = 0;
        for (const Visit& visit : flownVisits(mission))
            if (visit.iceberg == IcebergIndex(1)) {
                QVERIFY(visit.position_m == kTrack.at(visit.time_s));
                ++met;
            }
        QVERIFY(met > 0);
    }

    void icebergIsWhereTheTrackSays_data()
    {
        QTest::addColumn<double>("time_s");
        QTest::addColumn<double>("east_m");
        QTest::addColumn<double>("north_m");
        QTest::newRow("held before") << 0.0 << 3000.0 << 0.0;
        QTest::newRow("at an entry") << 100.0 << 3090.0 << 0.0;
        QTest::newRow("between") << 130.0 << 3090.0 << 60.0;
        QTest::newRow("at the last") << 400.0 << 2850.0 << 360.0;
        QTest::newRow("held after") << 450.0 << 2850.0 << 360.0;
    }

    void icebergIsWhereTheTrackSays()
    {
        QFETCH(double, time_s);
        QFETCH(double, east_m);
        QFETCH(double, north_m);
        const Point expected_m(east_m, north_m);
        QVERIFY(kTrack.at(time_s) == expected_m);
        Mission mission(seaWithTrack());
        mission.advance(time_s);
        QVERIFY((mission.simulation().truth_m(1) - expected_m).norm() < 1e-9); // rounding of steps
    }

    /** Other icebergs have the same noise as without a track. */
    void othersAreUndisturbed()
    {
        Scenario plain = seaWithTrack();
        plain.icebergs[1].track = {};
        Mission with(seaWithTrack(20));
        plain.duration_s = 20;
        Mission without(plain);
        with.advance(20);
        without.advance(20);
        for (const IcebergIndex iceberg : IcebergList{0, 2, 3, 4, 5})
            QVERIFY(with.simulation().truth_m(iceberg) == without.simulation().truth_m(iceberg));
    }

    void estimateFollowsTheKnownVelocity()
    {
        Scenario scenario = emptySea(300);
        Iceberg& iceberg = addIceberg(scenario, 50'000, 0); // never in view
        iceberg.velocity_mps = {0.5, 0};
        scenario.current_mps = {0, 0.25};
        iceberg.track = {.time_s = {0, 300}, .position_m = {{50'000, 0}, {50'000, -900}}};
        Mission mission(scenario);
        mission.advance(200);
        const Simulation& world = mission.simulation();
        QVERIFY((world.observer().estimate_m(0) - Point(50'100, 50)).norm() < 1e-6);
        QVERIFY((world.truth_m(0) - Point(50'000, -600)).norm() < 1e-6); // includes the current
        QVERIFY(world.track(0).sigma_m2 > 0);
    }

    void inViewTheEstimateIsTheTruth()
    {
        Scenario scenario = emptySea(60);
        Iceberg& iceberg = addIceberg(scenario, 1000, 0);
        iceberg.velocity_mps = {-1, 0};
        iceberg.track = {.time_s = {0, 60}, .position_m = {{900, 30}, {1500, 30}}};
        Mission mission(scenario);
        QVERIFY(mission.simulation().truth_m(0) == Point(900, 30));
        bool seen = false;
        for (int second = 1; second <= 60; ++second) {
            mission.advance(second);
            const Simulation& world = mission.simulation();
            if (!world.track(0).inView)
                continue;
            seen = true;
            QVERIFY(world.observer().estimate_m(0) == world.truth_m(0));
            QCOMPARE(world.track(0).sigma_m2, 0.0);
        }
        QVERIFY(seen);
    }

    void lookingBackIsExact()
    {
        Mission mission(seaWithTrack(), {.keyframeInterval_s = 60});
        mission.advance(500);
        for (const double time_s : {0.0, 59.9, 100.0, 123.4, 399.9, 500.0}) {
            Mission then(seaWithTrack());
            then.advance(time_s);
            const MissionInstant instant = instantAt(mission, time_s);
            QVERIFY(instant.simulation.state() == then.simulation().state());
            QVERIFY(instant.simulation.truth_m(1) == then.simulation().truth_m(1));
        }
    }

    void runFileRepeats()
    {
        Mission mission(seaWithTrack(200));
        mission.advance(200);
        const RunFile run = runOf(mission);
        const RunFile read = runFromJson(runToJson(run), "run");
        QVERIFY(read == run);
        QVERIFY(read.scenario.icebergs[1].track == kTrack);
        QVERIFY(compareRun(read, runOf(replay(read))).empty());
    }

    void icebergAddedInFlightFollowsItsTrack()
    {
        Scenario scenario = seaWithTrack();
        Iceberg added = scenario.icebergs[1];
        added.id = "later";
        Mission mission(seaWithTrack());
        mission.advance(130);
        mission.intervene({.appears = added});
        QVERIFY((mission.simulation().truth_m(6) - Point(3090, 60)).norm() < 1e-9);
    }

    void fileKeepsIt()
    {
        Scenario scenario = seaWithTrack();
        scenario.icebergs[1].trackExtraJson = R"({"beacon":"7001"})";
        const Scenario read = scenarioFromJson(scenarioToJson(scenario), "text");
        QVERIFY(read == scenario);
    }

    void faultyTracksAreReported_data()
    {
        QTest::addColumn<QByteArray>("track");
        QTest::addColumn<QByteArray>("field");
        const auto row = [](const char* name, const char* track, const char* field) {
            QTest::newRow(name) << QByteArray(track) << QByteArray("icebergs[0].track") + field;
        };
        row("no object", "3", "");
        row("no times", R"({"position_m": [[0,0],[1,1]]})", ".time_s");
        row("no positions", R"({"time_s": [0,1]})", ".position_m");
        row("empty", R"({"time_s": [], "position_m": []})", ".time_s");
        row("one entry", R"({"time_s": [0], "position_m": [[0,0]]})", ".time_s");
        row("unequal", R"({"time_s": [0,1,2], "position_m": [[0,0],[1,1]]})", ".position_m");
        row("equal times", R"({"time_s": [0,1,1], "position_m": [[0,0],[1,1],[2,2]]})",
            ".time_s[2]");
        row("falling times", R"({"time_s": [0,-1], "position_m": [[0,0],[1,1]]})", ".time_s[1]");
        row("a text", R"({"time_s": [0,"1"], "position_m": [[0,0],[1,1]]})", ".time_s[1]");
        row("half a point", R"({"time_s": [0,1], "position_m": [[0,0],[1]]})", ".position_m[1]");
        row("far off", R"({"time_s": [0,1], "position_m": [[0,0],[1,2e6]]})", ".position_m[1][1]");
        row("a late time", R"({"time_s": [0,1e10], "position_m": [[0,0],[1,1]]})", ".time_s[1]");
    }

    void faultyTracksAreReported()
    {
        QFETCH(QByteArray, track);
        QFETCH(QByteArray, field);
        const std::string text = R"({"format": "bergwatch-scenario", "version": 1,
            "uavs": [{"position_m": [0, 0]}],
            "icebergs": [{"position_m": [0, 0], "track": )" +
                                 track.toStdString() + "}]}";
        const std::optional<Error> error = errorOf([&] { (void)scenarioFromJson(text, "text"); });
        QVERIFY(error && error->code() == ErrorCode::InvalidInput);
        QVERIFY2(names(error->issues(), field.toStdString()), error->what());
        QCOMPARE(error->issues().size(), std::size_t{1});
    }

    void trackWithTooManyPointsIsReported()
    {
        Scenario scenario = seaWithTrack();
        RecordedTrack& track = scenario.icebergs[1].track;
        track = {};
        for (std::size_t i = 0; i <= kMostTrackPoints; ++i) {
            track.time_s.push_back(static_cast<double>(i));
            track.position_m.emplace_back(0, 0);
        }
        QVERIFY(names(validate(scenario), "icebergs[1].track.time_s"));
        track.time_s.pop_back();
        track.position_m.pop_back();
        QVERIFY(!hasErrors(validate(scenario)));
    }
};

QTEST_APPLESS_MAIN(TestRecordedTrack)
#include "tst_recorded_track.moc"
