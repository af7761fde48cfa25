#include "tests/support/flight/link_scene.h"

#include <QtTest>

using namespace berg;
using namespace berg::test;

namespace {

MissionPart recheckPart(int count)
{
    return {.type = MissionType::Mission, .items = someMission(count)};
}

} // namespace

/** Changes of the mission on board by others, as far as they can be noticed. */
class TestMissionRecheck : public QObject
{
    Q_OBJECT

private slots:
    /** ArduPilot reports the number of items only: reading back finds the other item. */
    void anotherItemIsFound()
    {
        LinkScene scene(AutopilotKind::ArduPilot);
        QVERIFY(scene.meet());
        QCOMPARE(scene.sync({recheckPart(8)}).phase, SyncPhase::Equal);
        const SyncStatus same = scene.sync({recheckPart(8)}, MissionSync::Task::Recheck);
        QCOMPARE(same.phase, SyncPhase::Equal);
        QVERIFY(same.isRecheck);
        std::vector<LinkMissionItem> changed = someMission(8);
        changed[4].x += 10; // a metre
        scene.vehicle.load(MissionType::Mission, changed);
        QCOMPARE(scene.sync({recheckPart(8)}, MissionSync::Task::Recheck).phase,
                 SyncPhase::Different);
    }

    void recheckGivesWay()
    {
        LinkScene scene(AutopilotKind::Px4, {.delay_s = 0.3});
        QVERIFY(scene.meet());
        QCOMPARE(scene.sync({recheckPart(8)}).phase, SyncPhase::Equal);
        QVERIFY(scene.session.startSync(LinkScene::address, {recheckPart(8)},
                                        MissionSync::Task::Recheck));
        scene.run(1);
        QVERIFY(!scene.session.startSync(LinkScene::address, {recheckPart(8)},
                                         MissionSync::Task::Recheck));
        const SyncStatus uploaded = scene.sync({recheckPart(5)});
        QCOMPARE(uploaded.phase, SyncPhase::Equal);
        QVERIFY(!uploaded.isRecheck);
        QCOMPARE(scene.vehicle.missions().items(MissionType::Mission).size(), std::size_t{5});
        QVERIFY(scene.session.startSync(LinkScene::address, {recheckPart(8)},
                                        MissionSync::Task::Compare));
        QVERIFY(!scene.session.startSync(LinkScene::address, {recheckPart(8)},
                                         MissionSync::Task::Recheck)); // it must wait
    }

    /** Answers to another ground station that a router passes on to us. */
    void othersUploadIsHeard()
    {
        LinkScene scene(AutopilotKind::ArduPilot);
        QVERIFY(scene.meet());
        QCOMPARE(scene.sync({recheckPart(4)}).phase, SyncPhase::Equal);
        const auto heard_s = [&] {
            return scene.session.findVehicle(LinkScene::address)->othersUpload_s;
        };
        QVERIFY(!heard_s()); // our own upload does not count
        FrameWriter vehicle(LinkScene::address);
        const auto request = [&](int system) {
            scene.hub.send(0, vehicle.write(LinkMessage(MessageId::MissionRequest)
                                                .with("seq", 1)
                                                .with("target_system", system)
                                                .with("target_component", 190),
                                            0));
            scene.run(0.2);
        };
        request(255);
        QVERIFY(!heard_s());
        request(254);
        QVERIFY(heard_s());
        QVERIFY(scene.time_s - *heard_s() < 0.3);
    }
};

QTEST_APPLESS_MAIN(TestMissionRecheck)
#include "tst_mission_recheck.moc"
