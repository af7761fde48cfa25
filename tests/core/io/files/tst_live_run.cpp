#include "core/io/files/run_json.h"
#include "core/mission/mission_instant.h"
#include "tests/support/expect_error.h"
#include "tests/support/flight/scenario_builder.h"

#include <QtTest>

#include <algorithm>

using namespace berg;
using namespace berg::test;

namespace {

constexpr double kSpeed_mps = 30; ///< unlike the 22 m/s of the scenario

/** Two icebergs; the real aircraft passes over the second one only. */
Scenario twoIcebergs()
{
    Scenario scenario = emptySea(200);
    addIceberg(scenario, 3000, 3000);
    addIceberg(scenario, 1500, 0);
    return scenario;
}

PoseFix fixAt(double time_s)
{
    return {.time_s = time_s, .pose = {.position_m = {kSpeed_mps * time_s, 0}}};
}

/** Flies 90 s along fixes at 4 Hz, as they come; those from `lost_s` on are predicted. */
Mission liveFlight(double lost_s = 1e9)
{
    Mission mission(twoIcebergs(), {.keyframeInterval_s = 20});
    for (double time_s = 0.25; time_s < 90; time_s += 0.25) {
        PoseFix fix = fixAt(time_s);
        fix.isMeasured = time_s < lost_s;
        mission.addFix(fix);
        mission.advance(std::floor(*mission.poseTracks().knownUntil_s() * 10) / 10);
    }
    return mission;
}

/**
 * Flies along fixes up to `end_s`, without view from 45 s to 55 s, and simulated from 60 s to 75 s.
 * Keyframes at 50 s, 60 s and 70 s begin in these parts.
 */
Mission interruptedFlight(double end_s)
{
    Mission mission(twoIcebergs(), {.keyframeInterval_s = 10});
    const auto fly = [&](double from_s, double to_s) {
        for (double time_s = from_s + 0.25; time_s <= to_s; time_s += 0.25) {
            PoseFix fix = fixAt(time_s);
            fix.isMeasured = time_s < 45 || time_s > 55;
            mission.addFix(fix);
        }
        mission.advance(std::min(to_s, end_s));
    };
    fly(0, 60);
    mission.advance(std::min(75.0, end_s));
    fly(75, 90);
    return mission;
}

std::ptrdiff_t sightingsOf(const Mission& mission, IcebergIndex iceberg)
{
    return std::ranges::count_if(mission.events(), [iceberg](const MissionEvent& event) {
        return event.kind == EventKind::Sighted && event.iceberg == iceberg;
    });
}

std::string textOf(const RunFile& run)
{
    std::string text;
    writeRun(run, [&text](std::string_view piece) { text += piece; });
    return text;
}

} // namespace

class TestLiveRun : public QObject
{
    Q_OBJECT

private slots:
    void recordFollowsTheAircraft()
    {
        const Mission mission = liveFlight();
        QCOMPARE(mission.simulation().time_s(), 89.7);
        const Point place_m = mission.simulation().uav(0).pose.position_m;
        QVERIFY((place_m - Point(kSpeed_mps * 89.7, 0)).norm() < 1e-6);
        QCOMPARE(sightingsOf(mission, 1), std::ptrdiff_t{1});
        QCOMPARE(sightingsOf(mission, 0), std::ptrdiff_t{0});
        QVERIFY(mission.simulation().track(0).sigma_m2 > mission.simulation().track(1).sigma_m2);
        // It was simulated for two steps and jumped to the path in the third, at 22 m/s.
        QVERIFY(std::abs(mission.metrics().flown_m - 22 * 0.3 - kSpeed_mps * 89.4) < 1e-6);
    }

    /** A pass over home, at the origin after 20 s, is no landing. */
    void aircraftLandsWhereItStands_data()
    {
        QTest::addColumn<double>("end_m");
        QTest::addColumn<int>("landings");
        QTest::newRow("passes") << 1e9 << 0;
        QTest::newRow("stands") << 0.0 << 1;
        QTest::newRow("stands elsewhere") << 100.0 << 0;
    }

    void aircraftLandsWhereItStands()
    {
        QFETCH(double, end_m);
        QFETCH(int, landings);
        Mission mission(twoIcebergs(), {});
        mission.intervene(
            {.commanded = UavCommand{.uav = "uav-1", .order = FlightOrder::ReturnNow}});
        for (double time_s = 0.05; time_s < 40; time_s += 0.25)
            mission.addFix(
                {.time_s = time_s,
                 .pose = {.position_m = {std::min(kSpeed_mps * (time_s - 20), end_m), 0}}});
        mission.advance(39);
        QCOMPARE(std::ranges::count(mission.events(), EventKind::Landed, &MissionEvent::kind),
                 std::ptrdiff_t{landings});
    }

    /** A predicted aircraft passes over the iceberg at 50 s, but sends no pictures. */
    void nothingIsSeenWithoutContact()
    {
        const Mission mission = liveFlight(30);
        QCOMPARE(sightingsOf(mission, 1), std::ptrdiff_t{0});
        QVERIFY(mission.simulation().zeta_m2s() > liveFlight().simulation().zeta_m2s());
    }

    void earlierInstantEqualsTheFlight()
    {
        const Mission mission = liveFlight();
        Mission then = liveFlight();
        const MissionInstant instant = instantAt(mission, 45);
        QVERIFY((instant.simulation.uav(0).pose.position_m - Point(kSpeed_mps * 45, 0)).norm() <
                1e-6);
        QVERIFY(instantAt(mission, 89.7).simulation.state() == then.simulation().state());
    }

    /** The aircraft has no view when it passes over the iceberg, and is simulated for a while. */
    void earlierInstantsOfAnInterruptedFlight_data()
    {
        QTest::addColumn<double>("time_s");
        QTest::newRow("without view") << 52.0;
        QTest::newRow("with view again") << 58.0;
        QTest::newRow("simulated") << 65.0;
        QTest::newRow("jump to the path") << 75.3;
        QTest::newRow("on the path again") << 80.0;
    }

    void earlierInstantsOfAnInterruptedFlight()
    {
        QFETCH(double, time_s);
        const Mission whole = interruptedFlight(90);
        const Mission part = interruptedFlight(time_s);
        QCOMPARE(part.simulation().time_s(), time_s);
        QVERIFY(instantAt(whole, time_s).simulation.state() == part.simulation().state());
    }

    void runFileRepeatsTheFlight()
    {
        Mission mission = liveFlight();
        mission.advance(120); // the aircraft is silent, so the rest is simulated
        const RunFile run = runOf(mission);
        QCOMPARE(run.fixes.size(), std::size_t{359});
        const RunFile read = runFromJson(textOf(run), "text");
        QVERIFY(read == run);
        RunFile shorter = run;
        shorter.fixes.pop_back();
        QVERIFY(!(shorter == run));
        QCOMPARE(textOf(read), textOf(run));
        const Mission again = replay(read);
        QVERIFY(again.simulation().state() == mission.simulation().state());
        QVERIFY(compareRun(read, runOf(again)).empty());
    }

    void faultyFixesAreReported()
    {
        const std::string good = textOf(runOf(liveFlight()));
        const auto faultOf = [&](const std::string& from, const std::string& to) {
            std::string text = good;
            text.replace(text.find(from), from.size(), to);
            try {
                static_cast<void>(runFromJson(text, "text"));
            } catch (const Error& error) {
                return error.issues().front().field;
            }
            return std::string("none");
        };
        QCOMPARE(faultOf(R"("time_s": 0.5, "position)", R"("time_s": 0.1, "position)"),
                 std::string("fixes[1].time_s"));
        QCOMPARE(faultOf(R"("time_s": 0.5, "position)", R"("time_s": 0.5, "uav": 1, "position)"),
                 std::string("fixes[1].uav"));
        QCOMPARE(faultOf(R"(, "first": true)", ""), std::string("fixes[0].first"));
        QCOMPARE(
            faultOf(R"("time_s": 0.5, "position_m": [)", R"("time_s": 0.5, "position_m": [100000)"),
            std::string("fixes[1].position_m[0]"));
    }
};

QTEST_APPLESS_MAIN(TestLiveRun)
#include "tst_live_run.moc"
