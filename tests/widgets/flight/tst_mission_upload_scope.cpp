#include "core/io/export/content/export_content.h"
#include "core/io/export/missions/mission_upload.h"
#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/patience.h"
#include "widgets/flight/flight_record.h"
#include "widgets/flight/mission_runner.h"

#include <QSignalSpy>
#include <QtTest>

using namespace berg;
using test::kPatience_ms;

namespace {

/** Takes snapshots into a record until one satisfies `wanted`. */
template <class Wanted>
bool followUntil(MissionRunner& runner, FlightRecord& record, const Wanted& wanted)
{
    return QTest::qWaitFor(
        [&] {
            if (std::optional<MissionSnapshot> snapshot = runner.acceptSnapshot())
                record.accept(std::move(*snapshot));
            return wanted(record);
        },
        kPatience_ms);
}

/** Two UAVs among icebergs; a plan takes a minute, so that interim plans are flown meanwhile. */
Scenario slowPlanning()
{
    Scenario scenario = test::emptySea(3000);
    scenario.planner.policy = PolicyKind::Coverage;
    scenario.planningTime_s = 60;
    scenario.uavs.push_back(scenario.uavs.front());
    scenario.uavs.back().id = "uav-2";
    scenario.uavs.back().position_m = {0, 500};
    for (const auto& [east_m, north_m] :
         {std::pair(1500, 800), {-2500, 1500}, {2500, -2000}, {-1500, -2500}, {3500, 2500}})
        test::addIceberg(scenario, east_m, north_m);
    return scenario;
}

} // namespace

class TestMissionUploadScope : public QObject
{
    Q_OBJECT

private slots:
    /** While the next plan is being made, uploads still follow the aimed legs. */
    void interimPlansKeepThePath()
    {
        const Scenario scenario = slowPlanning();
        Mission mission(scenario);
        double time_s = 0;
        const auto isInterim = [&] {
            const Plan* newest = mission.plans().empty() ? nullptr : mission.plans().back().get();
            return newest != nullptr && newest->interim && newest->uavs.front().legs.empty();
        };
        while (!isInterim() && time_s < scenario.duration_s)
            static_cast<void>(mission.advance(++time_s));
        QVERIFY(isInterim());

        MissionRunner runner;
        FlightRecord record;
        runner.setScenario(scenario);
        QVERIFY(followUntil(runner, record,
                            [](const FlightRecord& r) { return r.now.phase == RunPhase::Ready; }));
        runner.stepBy(time_s);
        QVERIFY(followUntil(runner, record, [&](const FlightRecord& r) {
            return r.now.phase == RunPhase::Paused && r.now.time_s > time_s - scenario.dt_s / 2;
        }));
        std::shared_ptr<const std::vector<UavMission>> missions;
        connect(&runner, &MissionRunner::missionsReady, this,
                [&](const auto& sent) { missions = sent; });
        runner.requestMissions();
        QTRY_VERIFY_WITH_TIMEOUT(missions != nullptr, kPatience_ms);

        const ExportContent path = exportContent(
            {.scenario = scenario, .plan = *mission.plans().front(), .mission = &mission},
            {.what = ExportScope::Path, .returnHome = true});
        QCOMPARE(missions->size(), path.uavs.size());
        for (std::size_t i = 0; i < path.uavs.size(); ++i) {
            const std::vector<MissionPart> expected = missionParts(path, path.uavs[i]);
            const std::vector<MissionPart>& sent = missions->at(i).parts;
            QCOMPARE(sent.size(), expected.size());
            for (std::size_t part = 0; part < expected.size(); ++part)
                QVERIFY(missionDifferences(expected[part].items, sent[part].items).empty());
        }
    }

    /** Comparisons count the icebergs of this sortie, not of later ones. */
    void ordersEndWithTheSortie()
    {
        Scenario scenario = test::emptySea(3000);
        scenario.uavs.front().spec.endurance_s = 300;
        for (const auto& [east_m, north_m] :
             {std::pair(1000, 300), {-900, 1200}, {1800, -1500}, {-1800, -1200}})
            test::addIceberg(scenario, east_m, north_m);
        MissionRunner runner;
        FlightRecord record;
        runner.setScenario(scenario);
        QVERIFY(followUntil(runner, record,
                            [](const FlightRecord& r) { return r.now.phase == RunPhase::Ready; }));
        const UavPlan& plan = *planOf(record.now, 0);
        QVERIFY(plan.thisSortie && *plan.thisSortie > 0);
        QVERIFY(*plan.thisSortie < static_cast<int>(plan.order.size()));
        const std::vector<std::string> sortie = sortieIcebergs(record.now, 0);
        QCOMPARE(sortie.size(), static_cast<std::size_t>(*plan.thisSortie));
        std::shared_ptr<const std::vector<UavMission>> missions;
        connect(&runner, &MissionRunner::missionsReady, this,
                [&](const auto& sent) { missions = sent; });
        runner.requestMissions();
        QTRY_VERIFY_WITH_TIMEOUT(missions != nullptr, kPatience_ms);
        QVERIFY(missions->front().order == sortie);
    }

    /** A request that is refused is answered, too. */
    void refusedMissionsAreAnswered()
    {
        MissionRunner runner;
        QSignalSpy refused(&runner, &MissionRunner::commandRefused);
        std::shared_ptr<const std::vector<UavMission>> missions;
        connect(&runner, &MissionRunner::missionsReady, this,
                [&](const auto& sent) { missions = sent; });
        runner.requestMissions(); // there is no scenario
        QTRY_VERIFY_WITH_TIMEOUT(missions != nullptr, kPatience_ms);
        QVERIFY(missions->empty());
        QCOMPARE(refused.count(), 1);
    }

    /** A flight at the pace of aircraft is neither stepped nor begun after the end. */
    void liveFlightsSayWhatTheyRefuse()
    {
        Scenario scenario = test::emptySea(2);
        test::addIceberg(scenario, 1000, 0);
        MissionRunner runner;
        FlightRecord record;
        QSignalSpy refused(&runner, &MissionRunner::commandRefused);
        runner.setScenario(scenario);
        runner.flyLive(100);
        QVERIFY(followUntil(runner, record, [](const FlightRecord& r) { return r.now.isLive; }));
        runner.stepBy(1);
        QTRY_COMPARE_WITH_TIMEOUT(refused.count(), 1, kPatience_ms);
        runner.pause();
        QVERIFY(followUntil(runner, record,
                            [](const FlightRecord& r) { return r.now.phase == RunPhase::Paused; }));
        QVERIFY(record.now.isLive);
        QCOMPARE(record.now.time_s, 0.0);
        runner.restart();
        runner.stepBy(5);
        QVERIFY(followUntil(runner, record, [](const FlightRecord& r) {
            return r.now.phase == RunPhase::Finished;
        }));
        runner.flyLive(100);
        QTRY_COMPARE_WITH_TIMEOUT(refused.count(), 2, kPatience_ms);
    }
};

QTEST_GUILESS_MAIN(TestMissionUploadScope)
#include "tst_mission_upload_scope.moc"
