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

    void runFileRepeatsTheFlight()
    {
        Mission mission = liveFlight();
        mission.advance(120); // the aircraft is silent, so the rest is simulated
        const RunFile run = runOf(mission);
        QCOMPARE(run.fixes.size(), std::size_t{359});
        const RunFile read = runFromJson(textOf(run), "text");
        QVERIFY(read == run);
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
    }
};

QTEST_APPLESS_MAIN(TestLiveRun)
#include "tst_live_run.moc"
