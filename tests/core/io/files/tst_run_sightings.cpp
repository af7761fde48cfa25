#include "core/io/files/run_json.h"
#include "core/presets/presets.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/flight/scenario_builder.h"

#include <QTest>

#include <regex>

using namespace berg;
using namespace berg::test;

/** Tests of what older run files lack and of what run files may contradict. */
class TestRunSightings : public QObject
{
    Q_OBJECT

private slots:
    /**
     * If velocities change, the anchor of an estimate is not a sighting, so files record both.
     * Older files have the anchor only, and only that is compared.
     */
    void lastSightingsAreReadBack()
    {
        Scenario scenario = randomScenario(4);
        test::letVelocitiesChange(scenario);
        Mission mission(scenario, {.workLimit = 50'000, .keyframeInterval_s = 50});
        mission.advance(200);
        RunFile run = runOf(mission);
        std::string text = runToJson(run);
        QVERIFY(runFromJson(text, "text") == run);
        Track& track = run.keyframes[2].tracks[1];
        QVERIFY(track.seen_s < track.anchor_s);
        track.seen_s += 1;
        const std::vector<Issue> issues = compareRun(run, runOf(mission));
        QCOMPARE(issues.size(), std::size_t{1});
        QCOMPARE(QString::fromStdString(issues[0].field),
                 QStringLiteral("keyframes[2].tracks[1][17]"));

        const std::regex last("(\\[(?:[^\\[\\],]+,){17})[^\\[\\],]+\\]");
        std::string older = std::regex_replace(text, last, "$1]");
        for (std::size_t at = 0; (at = older.find(",]", at)) != std::string::npos;)
            older.erase(at, 1);
        QVERIFY(older.size() < text.size());
        const RunFile read = runFromJson(older, "text");
        QVERIFY(compareRun(read, runOf(mission)).empty());
    }

    /** If target and order of a file contradict each other, the target is what was flown to. */
    void theTargetIsFirstInTheOrder()
    {
        Mission mission(randomScenario(3));
        mission.advance(60);
        const RunFile run = runOf(mission);
        std::string text = runToJson(run);
        const IcebergList& order = run.plans[0]->uavs[0].order;
        const std::string target = "\"target\": ";
        const std::size_t at = text.find(target + std::to_string(order[0].number()));
        QVERIFY(at != std::string::npos);
        text.replace(at + target.size(), std::to_string(order[0].number()).size(),
                     std::to_string(order[1].number()));
        const RunFile read = runFromJson(text, "text");
        QCOMPARE(read.plans[0]->uavs[0].target(), std::optional(order[1]));
        QCOMPARE(read.plans[0]->uavs[0].order.size(), order.size());
        QCOMPARE(compareRun(read, run)[0].field, std::string("plans[0].target"));
    }
};

QTEST_APPLESS_MAIN(TestRunSightings)
#include "tst_run_sightings.moc"
