// The window's session against simulated aircraft, with a clock of the test: nothing waits.

#include "core/sim/steering.h"
#include "tests/support/window/link_worker_scene.h"

#include <QtTest>

#include <malloc.h>

using namespace berg;
using namespace berg::test;

namespace {

MissionPart missionPart(int count, int shift = 0)
{
    return {.type = MissionType::Mission, .items = someMission(count, shift)};
}

MissionPart fencePart()
{
    return {.type = MissionType::Fence, .items = someFence()};
}

/** A mission that takes minutes. */
MissionPart longMission()
{
    MissionPart part;
    for (int i = 1; i < 6; ++i)
        part.items.push_back({.params = {0, 40, 0, 0},
                              .x = 470'000'000 + 90'000 * i,
                              .y = -480'000'000 + 60'000 * (i % 3),
                              .z = 100});
    return part;
}

bool isOnBoard(const LinkWorkerScene& scene, const MissionPart& part, std::size_t i = 0)
{
    return missionDifferences(part.items, scene.onBoard(part.type, i)).empty();
}

AutopilotKind kindOf(bool isPx4)
{
    return isPx4 ? AutopilotKind::Px4 : AutopilotKind::ArduPilot;
}

bool hasTransferred(const LinkWorkerScene& scene, int items)
{
    const std::optional<SyncStatus>& sync = scene.vehicle()->sync;
    return sync && sync->phase == SyncPhase::Uploading && sync->transfer.done >= items;
}

} // namespace

class TestLinkWorker : public QObject
{
    Q_OBJECT

private slots:
    void kinds_data()
    {
        QTest::addColumn<bool>("isPx4");
        QTest::newRow("ArduPilot") << false;
        QTest::newRow("PX4") << true;
    }

    void uploadReadBackAndUploadAgain_data()
    {
        QTest::addColumn<bool>("isPx4");
        QTest::addColumn<double>("loss");
        QTest::addColumn<double>("delay_s");
        QTest::addColumn<int>("seed");
        for (const bool isPx4 : {false, true}) {
            const char* name = isPx4 ? "PX4" : "ArduPilot";
            for (const double loss : {0.0, 0.05, 0.2})
                for (int seed = 1; seed <= (loss > 0 ? 4 : 1); ++seed)
                    QTest::addRow("%s, %.0f %% lost, %d", name, 100 * loss, seed)
                        << isPx4 << loss << 0.05 << seed;
            QTest::addRow("%s, 1.5 s there and back", name) << isPx4 << 0.0 << 0.75 << 1;
            QTest::addRow("%s, 1.5 s each way", name) << isPx4 << 0.0 << 1.5 << 1;
        }
    }

    void uploadReadBackAndUploadAgain()
    {
        QFETCH(bool, isPx4);
        QFETCH(double, loss);
        QFETCH(double, delay_s);
        QFETCH(int, seed);
        LinkWorkerScene scene(
            {kindOf(isPx4)},
            {.loss = loss, .delay_s = delay_s, .seed = static_cast<std::uint64_t>(100 * seed)});
        QVERIFY(scene.meet());
        const MissionPart rally{.type = MissionType::Rally, .items = someRally()};
        QCOMPARE(scene.sync({missionPart(14), fencePart(), rally}).phase, SyncPhase::Equal);
        QVERIFY(isOnBoard(scene, missionPart(14)) && isOnBoard(scene, fencePart()) &&
                isOnBoard(scene, rally));
        QCOMPARE(scene.status.onBoard.at(LinkWorkerScene::address(0)).size(), std::size_t{3});

        QCOMPARE(scene.sync({missionPart(9, 5)}).phase, SyncPhase::Equal);
        QVERIFY(isOnBoard(scene, missionPart(9, 5)));
        QCOMPARE(scene.sync({missionPart(9, 5)}, MissionSync::Task::Compare).phase,
                 SyncPhase::Equal);
        const SyncStatus other = scene.sync({missionPart(9, 6)}, MissionSync::Task::Compare);
        QCOMPARE(other.phase, SyncPhase::Different);
        QVERIFY((other.differences.front() == ItemDifference{.index = 0, .field = "x"}));
    }

    void lostAcknowledgement_data() { kinds_data(); }

    void lostAcknowledgement()
    {
        QFETCH(bool, isPx4);
        LinkWorkerScene scene({kindOf(isPx4)});
        QVERIFY(scene.meet());
        int lost = 0;
        scene.aircraft[0]->filter.setFilter([&](const LinkMessage& message) {
            const bool isAck = message.id() == MessageId::MissionAck;
            lost += isAck ? 1 : 0;
            return !isAck;
        });
        QCOMPARE(scene.sync({missionPart(5)}).phase, SyncPhase::Equal);
        QVERIFY(lost > 0);
    }

    void rebootInMidTransfer_data() { kinds_data(); }

    void rebootInMidTransfer()
    {
        QFETCH(bool, isPx4);
        LinkWorkerScene scene({kindOf(isPx4)}, {.delay_s = 0.1});
        QVERIFY(scene.meet());
        scene.worker.startSync(LinkWorkerScene::address(0), {missionPart(14)},
                               MissionSync::Task::UploadAndCompare);
        QVERIFY(scene.runUntil([&] { return hasTransferred(scene, 6); }, 30));
        scene.aircraft[0]->vehicle.reboot(6);
        QVERIFY(scene.runUntil([&] { return scene.count(LinkEvent::Kind::SyncEnded) > 0; }, 120));
        QCOMPARE(scene.vehicle()->sync->phase, SyncPhase::Equal);
        QVERIFY(isOnBoard(scene, missionPart(14)));
        QCOMPARE(scene.count(LinkEvent::Kind::VehicleLost), 1);
        QCOMPARE(scene.count(LinkEvent::Kind::VehicleReturned), 1);
    }

    void anotherStationUploads_data() { kinds_data(); }

    /** Its upload is not disturbed, ours is refused, and what it changes is noticed. */
    void anotherStationUploads()
    {
        QFETCH(bool, isPx4);
        LinkWorkerScene scene({kindOf(isPx4)});
        const std::unique_ptr<MemoryLink> link = scene.aircraft[0]->stations.addPeer();
        LinkSession other(*link, {.self = {.system = 254, .component = 190}});
        other.setSending(true);
        scene.eachStep = [&] { (void)other.advance(linkTime(scene.time_s)); };
        QVERIFY(scene.meet());
        scene.run(2); // the other station hears it, too
        QVERIFY(other.startSync(LinkWorkerScene::address(0), {missionPart(400)},
                                MissionSync::Task::UploadAndCompare));
        scene.run(0.5);
        const SyncStatus refused = scene.sync({missionPart(5)});
        QCOMPARE(refused.phase, SyncPhase::Failed);
        QCOMPARE(refused.transfer.failure, TransferFailure::Refused);
        QVERIFY(scene.runUntil(
            [&] {
                return other.findVehicle(LinkWorkerScene::address(0))->sync->phase ==
                       SyncPhase::Equal;
            },
            200));
        QVERIFY(isOnBoard(scene, missionPart(400)));
        scene.run(8); // PX4 is busy until it has the acknowledgement
        QCOMPARE(scene.sync({missionPart(5)}).phase, SyncPhase::Equal);
        QVERIFY(other.startSync(LinkWorkerScene::address(0), {missionPart(5, 3)},
                                MissionSync::Task::UploadAndCompare));
        scene.run(20);
        QCOMPARE(scene.sync({missionPart(5)}, MissionSync::Task::Compare).phase,
                 SyncPhase::Different);
    }

    /** A vehicle cannot distinguish two stations with one id: ours falls silent and says so. */
    void anotherStationWithOurId()
    {
        LinkWorkerScene scene({AutopilotKind::ArduPilot});
        QVERIFY(scene.meet());
        scene.aircraft[0]->stations.send(
            0, frameBytes(LinkMessage(MessageId::Heartbeat).with("type", 6).with("autopilot", 8),
                          {.system = 255, .component = 190}, 0));
        scene.run(1);
        QVERIFY(!scene.status.isSending);
        QVERIFY(std::ranges::any_of(scene.events, [](const LinkEvent& event) {
            return event.kind == LinkEvent::Kind::SameIdHeard;
        }));
        const int before = scene.aircraft[0]->link.received();
        scene.worker.startSync(LinkWorkerScene::address(0), {missionPart(5)},
                               MissionSync::Task::UploadAndCompare);
        scene.run(30);
        QCOMPARE(scene.aircraft[0]->link.received(), before);
    }

    void pilotTakesOver_data() { kinds_data(); }

    void pilotTakesOver()
    {
        QFETCH(bool, isPx4);
        const AutopilotKind kind = kindOf(isPx4);
        const std::uint32_t manual = isPx4 ? 0x00010000 : 0;
        LinkWorkerScene scene({kind});
        QVERIFY(scene.meet());
        QCOMPARE(scene.sync({longMission()}).phase, SyncPhase::Equal);
        Steering steering;
        steering.begin(SteeringKind::Mission, kind, scene.vehicle()->mode);
        QCOMPARE(steering.state(), SteeringState::Waiting);
        scene.worker.sendCommand(LinkWorkerScene::address(0),
                                 modeCommand(kind, steeringMode(SteeringKind::Mission, kind)));
        scene.run(3);
        steering.setMode(scene.vehicle()->mode);
        QCOMPARE(steering.state(), SteeringState::Active);
        scene.aircraft[0]->vehicle.setMode(manual);
        scene.events.clear();
        scene.run(2);
        QCOMPARE(scene.count(LinkEvent::Kind::ModeChanged), 1);
        steering.setMode(scene.vehicle()->mode);
        QCOMPARE(steering.state(), SteeringState::PilotTookOver);
        int commands = 0;
        scene.sent.setFilter([&](const LinkMessage& message) {
            commands += message.id() == MessageId::Heartbeat ? 0 : 1;
            return true;
        });
        scene.run(60);
        QCOMPARE(commands, 0);
        QCOMPARE(scene.aircraft[0]->vehicle.readings().mode, manual);
    }

    void linkIsCutForAMinute_data() { kinds_data(); }

    /** A ghost flies on with the mission on board, and yields to the aircraft when it is back. */
    void linkIsCutForAMinute()
    {
        QFETCH(bool, isPx4);
        LinkWorkerScene scene({kindOf(isPx4)});
        QVERIFY(scene.meet());
        scene.worker.setData({{LinkWorkerScene::address(0), AircraftData{}}});
        const MissionPart mission = longMission();
        QCOMPARE(scene.sync({mission}).phase, SyncPhase::Equal);
        const AutopilotKind kind = kindOf(isPx4);
        scene.worker.sendCommand(LinkWorkerScene::address(0),
                                 modeCommand(kind, steeringMode(SteeringKind::Mission, kind)));
        scene.run(20);
        QVERIFY(scene.status.ghosts.empty());
        scene.worker.startSync(LinkWorkerScene::address(0), {missionPart(14)},
                               MissionSync::Task::Compare);
        scene.aircraft[0]->radio.setImpairment({.loss = 1});
        scene.run(60);
        QVERIFY(scene.vehicle()->isLost);
        QCOMPARE(scene.count(LinkEvent::Kind::VehicleLost), 1);
        QCOMPARE(scene.vehicle()->sync->phase, SyncPhase::Failed); // the comparison under way
        QCOMPARE(scene.status.ghosts.size(), std::size_t{1});
        const GhostReport& ghost = scene.status.ghosts.front();
        QVERIFY(ghost.silentFor_s > 59 && ghost.silentFor_s < 61);
        // Both fly the same mission; the ghost began up to 0.25 s, a telemetry interval, behind.
        const double error_m =
            greatCircle_m(ghost.readings.place, scene.aircraft[0]->vehicle.readings().place);
        QVERIFY2(error_m < 30, std::to_string(error_m).c_str());

        scene.aircraft[0]->radio.setImpairment({});
        scene.run(5);
        QCOMPARE(scene.count(LinkEvent::Kind::VehicleReturned), 1);
        QCOMPARE(scene.count(LinkEvent::Kind::VehicleLost), 1);
        QVERIFY(scene.status.ghosts.empty());
        QVERIFY(scene.vehicle()->state.position->received_s > scene.time_s - 1);
        QCOMPARE(scene.sync({mission}, MissionSync::Task::Compare).phase, SyncPhase::Equal);
    }

    void nothingIsSentWhileSendingIsOff_data() { kinds_data(); }

    /** The aircraft counts what it receives. */
    void nothingIsSentWhileSendingIsOff()
    {
        QFETCH(bool, isPx4);
        LinkWorkerScene scene({kindOf(isPx4)});
        const CountingLink& peer = scene.aircraft[0]->link;
        const LinkAddress address = LinkWorkerScene::address(0);
        scene.run(30);
        QVERIFY(scene.vehicle() != nullptr);
        scene.worker.startSync(address, {missionPart(5)}, MissionSync::Task::UploadAndCompare);
        scene.worker.sendCommand(address, itemCommand(kindOf(isPx4), 0));
        scene.run(30);
        QCOMPARE(peer.received(), 0);
        QVERIFY(!scene.vehicle()->sync);

        QVERIFY(scene.meet());
        scene.worker.startSync(address, {missionPart(14)}, MissionSync::Task::UploadAndCompare);
        QVERIFY(scene.runUntil([&] { return hasTransferred(scene, 3); }, 30));
        scene.worker.setSending(false);
        scene.step(); // frames in transit arrive
        const int before = peer.received();
        QVERIFY(before > 5);
        scene.run(60);
        QCOMPARE(peer.received(), before);
        QVERIFY(!scene.status.isSending);
        QVERIFY(!scene.vehicle()->sync); // the items on board are unknown
        scene.worker.close();
        QCOMPARE(peer.received(), before);
    }

    /** A window that hangs must look dead to its aircraft. */
    void hungWindowSendsNothing()
    {
        LinkWorkerScene scene({AutopilotKind::ArduPilot});
        QVERIFY(scene.meet());
        scene.run(5);
        scene.isWindowAlive = false;
        scene.run(3.2);
        const int before = scene.aircraft[0]->link.received();
        scene.run(60);
        QCOMPARE(scene.aircraft[0]->link.received(), before);
        scene.isWindowAlive = true;
        scene.run(5);
        QVERIFY(scene.aircraft[0]->link.received() > before + 3);
        QVERIFY(scene.vehicle()->state.position->received_s > scene.time_s - 1);
    }

    /** Three uploads at once over a bad link, and each aircraft has its own mission. */
    void threeAircraftAtOnce()
    {
        LinkWorkerScene scene(
            {AutopilotKind::ArduPilot, AutopilotKind::Px4, AutopilotKind::ArduPilot},
            {.loss = 0.05, .delay_s = 0.1});
        QVERIFY(scene.meet());
        for (std::size_t i = 0; i < 3; ++i)
            scene.worker.startSync(LinkWorkerScene::address(i),
                                   {missionPart(10, static_cast<int>(7 * i)), fencePart()},
                                   MissionSync::Task::UploadAndCompare);
        const auto isEqual = [&](std::size_t i) {
            const std::optional<SyncStatus>& sync = scene.vehicle(i)->sync;
            return sync && sync->phase == SyncPhase::Equal;
        };
        QVERIFY(scene.runUntil([&] { return isEqual(0) && isEqual(1) && isEqual(2); }, 300));
        for (std::size_t i = 0; i < 3; ++i) {
            QVERIFY(isOnBoard(scene, missionPart(10, static_cast<int>(7 * i)), i));
            QVERIFY(scene.vehicle(i)->state.wind && scene.vehicle(i)->state.battery);
        }
    }

    /**
     * Three aircraft for many hours, one of which is silent now and then. 20 kB more are far below
     * a byte for each frame. ctest listens for a day as well.
     */
    void memoryStaysFlat()
    {
        const int hours = qEnvironmentVariableIntValue("BERGWATCH_LINK_HOURS");
        const double end_s = 3600 * (hours > 0 ? hours : 2);
        LinkWorkerScene scene({AutopilotKind::Px4, AutopilotKind::ArduPilot, AutopilotKind::Px4});
        QVERIFY(scene.meet());
        std::map<LinkAddress, AircraftData> data;
        for (std::size_t i = 0; i < 3; ++i)
            data[LinkWorkerScene::address(i)] = {
                .station = LatLon{.latitude_deg = 47.1, .longitude_deg = -48}, .range_m = 9000};
        scene.worker.setData(data);
        QCOMPARE(scene.sync({missionPart(14)}).phase, SyncPhase::Equal);
        const std::size_t parts = scene.status.onBoard.size();
        std::size_t afterHalfAnHour = 0;
        std::size_t ghosts = 0;
        std::size_t most = 0;
        while (scene.time_s < end_s) {
            scene.aircraft[2]->radio.setImpairment({.loss = 1});
            scene.run(20);
            ghosts += scene.status.ghosts.size();
            scene.aircraft[2]->radio.setImpairment({});
            scene.run(580);
            most = std::max(most, scene.events.size());
            scene.events = {};
            if (scene.time_s > 1800 && afterHalfAnHour == 0)
                afterHalfAnHour = ::mallinfo2().uordblks;
        }
        const std::size_t atTheEnd = ::mallinfo2().uordblks; // zero under sanitizers
        qInfo("%zu bytes after half an hour, %zu at the end, %zu ghosts, %zu events at once",
              afterHalfAnHour, atTheEnd, ghosts, most);
        QVERIFY(ghosts > 5);
        QVERIFY(most < 200);
        QCOMPARE(scene.status.onBoard.size(), parts);
        QVERIFY2(atTheEnd <= afterHalfAnHour + 20'000, std::to_string(atTheEnd).c_str());
    }
};

QTEST_GUILESS_MAIN(TestLinkWorker)
#include "tst_link_worker.moc"
