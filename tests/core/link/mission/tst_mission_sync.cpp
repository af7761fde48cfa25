#include "tests/support/flight/link_scene.h"

#include <QtTest>

using namespace berg;
using namespace berg::test;

namespace {

MissionPart missionPart(int count, int shift = 0)
{
    return {.type = MissionType::Mission, .items = someMission(count, shift)};
}

bool isOnBoard(const LinkScene& scene, const MissionPart& part)
{
    return missionDifferences(part.items, scene.vehicle.missions().items(part.type)).empty();
}

AutopilotKind kindOf(bool isPx4)
{
    return isPx4 ? AutopilotKind::Px4 : AutopilotKind::ArduPilot;
}

void kindRows()
{
    QTest::addColumn<bool>("isPx4");
    QTest::newRow("ArduPilot") << false;
    QTest::newRow("PX4") << true;
}

} // namespace

class TestMissionSync : public QObject
{
    Q_OBJECT

private slots:
    void uploadReadBackAndUploadAgain_data()
    {
        QTest::addColumn<bool>("isPx4");
        QTest::addColumn<double>("loss");
        QTest::addColumn<double>("delay_s");
        QTest::addColumn<int>("seed");
        for (bool isPx4 : {false, true}) {
            const char* name = isPx4 ? "PX4" : "ArduPilot";
            for (double loss : {0.0, 0.05, 0.2})
                for (int seed = 1; seed <= (loss > 0 ? 10 : 1); ++seed)
                    QTest::addRow("%s, %.0f %% lost, %d", name, 100 * loss, seed)
                        << isPx4 << loss << 0.05 << seed;
            QTest::addRow("%s, 1.5 s there and back", name) << isPx4 << 0.0 << 0.75 << 1;
            QTest::addRow("%s, 1.5 s each way", name) << isPx4 << 0.0 << 1.5 << 1;
            QTest::addRow("%s, 5 %% lost and 0.75 s each way", name) << isPx4 << 0.05 << 0.75 << 1;
        }
    }

    void uploadReadBackAndUploadAgain()
    {
        QFETCH(bool, isPx4);
        QFETCH(double, loss);
        QFETCH(double, delay_s);
        QFETCH(int, seed);
        LinkScene scene(
            kindOf(isPx4),
            {.loss = loss, .delay_s = delay_s, .seed = static_cast<std::uint64_t>(seed)});
        QVERIFY(scene.meet());
        const MissionPart fence{.type = MissionType::Fence, .items = someFence()};
        const MissionPart rally{.type = MissionType::Rally, .items = someRally()};
        const SyncStatus first = scene.sync({missionPart(14), fence, rally});
        QVERIFY2(first.phase == SyncPhase::Equal,
                 QByteArray::number(static_cast<int>(first.transfer.failure)) + " result " +
                     QByteArray::number(first.transfer.result) + " item " +
                     QByteArray::number(first.transfer.item.value_or(-1)));
        QVERIFY(isOnBoard(scene, missionPart(14)) && isOnBoard(scene, fence) &&
                isOnBoard(scene, rally));
        QCOMPARE(scene.session.onBoard(LinkScene::address).size(), std::size_t{3});

        QCOMPARE(scene.sync({missionPart(9, 5)}).phase, SyncPhase::Equal);
        QVERIFY(isOnBoard(scene, missionPart(9, 5)));
        QCOMPARE(scene.sync({missionPart(9, 5)}, MissionSync::Task::Compare).phase,
                 SyncPhase::Equal);
        const SyncStatus other = scene.sync({missionPart(9, 6)}, MissionSync::Task::Compare);
        QCOMPARE(other.phase, SyncPhase::Different);
        QVERIFY((other.differences.front() == ItemDifference{.index = 0, .field = "x"}));
    }

    void anEmptyListClears_data() { kindRows(); }

    void anEmptyListClears()
    {
        QFETCH(bool, isPx4);
        LinkScene scene(kindOf(isPx4));
        QVERIFY(scene.meet());
        const MissionPart fence{.type = MissionType::Fence, .items = someFence()};
        QCOMPARE(scene.sync({fence}).phase, SyncPhase::Equal);
        QCOMPARE(scene.sync({{.type = MissionType::Fence, .items = {}}}).phase, SyncPhase::Equal);
        QVERIFY(scene.vehicle.missions().items(MissionType::Fence).empty());
    }

    /** ArduPilot counts home as item 0, so the vehicle's jump must have a target one higher. */
    void jumpsMoveWithHome()
    {
        LinkScene scene(AutopilotKind::ArduPilot);
        QVERIFY(scene.meet());
        QCOMPARE(scene.sync({missionPart(6)}).phase, SyncPhase::Equal);
        const std::vector<LinkMissionItem> wire =
            itemsToSend(someMission(6), MissionType::Mission, AutopilotKind::ArduPilot);
        QCOMPARE(wire.size(), std::size_t{7});
        QCOMPARE(wire.back().params[0], 3.0F);
        QCOMPARE(scene.vehicle.missions().items(MissionType::Mission).back().params[0], 2.0F);
    }

    void lostAcknowledgementIsMadeUpForByReadingBack_data() { kindRows(); }

    void lostAcknowledgementIsMadeUpForByReadingBack()
    {
        QFETCH(bool, isPx4);
        LinkScene scene(kindOf(isPx4));
        QVERIFY(scene.meet());
        int dropped = 0;
        scene.vehicleFilter.setFilter([&](const LinkMessage& message) {
            const bool isAck = message.id() == MessageId::MissionAck;
            dropped += isAck ? 1 : 0;
            return !isAck;
        });
        QCOMPARE(scene.sync({missionPart(5)}).phase, SyncPhase::Equal);
        QVERIFY(dropped > 0);
    }

    /** The vehicle is away for six seconds in the middle; the upload restarts and succeeds. */
    void rebootInMidTransfer_data() { kindRows(); }

    void rebootInMidTransfer()
    {
        QFETCH(bool, isPx4);
        LinkScene scene(kindOf(isPx4), {.delay_s = 0.1});
        QVERIFY(scene.meet());
        QVERIFY(scene.session.startSync(LinkScene::address, {missionPart(14)},
                                        MissionSync::Task::UploadAndCompare));
        QVERIFY(scene.runUntil(
            [&] { return scene.session.findVehicle(LinkScene::address)->sync->transfer.done >= 6; },
            30));
        scene.vehicle.reboot(linkTime(scene.time_s), 6);
        QVERIFY(scene.runUntil([&] { return scene.count(LinkEvent::Kind::SyncEnded) > 0; }, 120));
        QCOMPARE(scene.session.findVehicle(LinkScene::address)->sync->phase, SyncPhase::Equal);
        QCOMPARE(scene.count(LinkEvent::Kind::VehicleLost), 1);
        QCOMPARE(scene.count(LinkEvent::Kind::VehicleReturned), 1);
        QVERIFY(isOnBoard(scene, missionPart(14)));
    }

    /** A cut link ends the transfer with a reason and the last item requested. */
    void cutLinkIsReported_data() { kindRows(); }

    void cutLinkIsReported()
    {
        QFETCH(bool, isPx4);
        LinkScene scene(kindOf(isPx4));
        QVERIFY(scene.meet());
        QCOMPARE(scene.sync({missionPart(4)}).phase, SyncPhase::Equal);
        QVERIFY(scene.session.startSync(LinkScene::address, {missionPart(14, 3)},
                                        MissionSync::Task::UploadAndCompare));
        QVERIFY(scene.runUntil(
            [&] { return scene.session.findVehicle(LinkScene::address)->sync->transfer.done >= 6; },
            30));
        scene.impaired.setImpairment({.loss = 1});
        QVERIFY(scene.runUntil([&] { return scene.count(LinkEvent::Kind::SyncEnded) > 1; }, 120));
        const SyncStatus status = *scene.session.findVehicle(LinkScene::address)->sync;
        QCOMPARE(status.phase, SyncPhase::Failed);
        QCOMPARE(status.transfer.failure, TransferFailure::GaveUp);
        // PX4 keeps the old mission until the new one is complete; ArduPilot is left with a
        // mixture.
        QCOMPARE(isOnBoard(scene, missionPart(4)), isPx4);
        scene.impaired.setImpairment({});
        scene.run(10);
        const SyncStatus read = scene.sync({missionPart(4)}, MissionSync::Task::Compare);
        QCOMPARE(read.phase, isPx4 ? SyncPhase::Equal : SyncPhase::Different);
    }

    /** The first items came, so the vehicle did answer. */
    void cutLinkWhileReadingIsReported()
    {
        LinkScene scene(AutopilotKind::Px4);
        QVERIFY(scene.meet());
        QCOMPARE(scene.sync({missionPart(14)}).phase, SyncPhase::Equal);
        QVERIFY(scene.session.startSync(LinkScene::address, {missionPart(14)},
                                        MissionSync::Task::Compare));
        QVERIFY(scene.runUntil(
            [&] { return scene.session.findVehicle(LinkScene::address)->sync->transfer.done >= 6; },
            30));
        scene.impaired.setImpairment({.loss = 1});
        QVERIFY(scene.runUntil([&] { return scene.count(LinkEvent::Kind::SyncEnded) > 1; }, 120));
        const SyncStatus status = *scene.session.findVehicle(LinkScene::address)->sync;
        QCOMPARE(status.phase, SyncPhase::Failed);
        QCOMPARE(status.transfer.failure, TransferFailure::GaveUp);
    }

    void switchingOnAgainKeepsTheTransfer()
    {
        LinkScene scene(AutopilotKind::Px4);
        QVERIFY(scene.meet());
        QVERIFY(scene.session.startSync(LinkScene::address, {missionPart(14)},
                                        MissionSync::Task::UploadAndCompare));
        scene.run(0.5);
        scene.session.setSending(true);
        QVERIFY(scene.runUntil([&] { return scene.count(LinkEvent::Kind::SyncEnded) > 0; }, 120));
        QCOMPARE(scene.session.findVehicle(LinkScene::address)->sync->phase, SyncPhase::Equal);
    }

    void anotherGroundStationIsUploading_data() { kindRows(); }

    void anotherGroundStationIsUploading()
    {
        QFETCH(bool, isPx4);
        LinkScene scene(kindOf(isPx4));
        const std::unique_ptr<MemoryLink> otherLink = scene.hub.addPeer();
        FrameWriter other({.system = 254, .component = 190});
        QVERIFY(scene.meet());
        scene.eachStep = [&] { // restarts again and again without answering requests
            otherLink->send(0, other.write(LinkMessage(MessageId::MissionCount)
                                               .with("count", 3)
                                               .with("target_system", 1)
                                               .with("target_component", 1),
                                           0));
        };
        scene.run(0.2);
        const SyncStatus refused = scene.sync({missionPart(5)});
        QCOMPARE(refused.phase, SyncPhase::Failed);
        QCOMPARE(refused.transfer.failure, TransferFailure::Refused);
        QCOMPARE(refused.transfer.result, isPx4 ? 1 : 14);
        scene.eachStep = {};
        scene.run(12); // the other station has gone
        QCOMPARE(scene.sync({missionPart(5)}).phase, SyncPhase::Equal);

        // Comparison reveals the change made by another station.
        otherLink->send(0, other.write(LinkMessage(MessageId::MissionClearAll)
                                           .with("target_system", 1)
                                           .with("target_component", 1),
                                       0));
        scene.run(0.2);
        QCOMPARE(scene.sync({missionPart(5)}, MissionSync::Task::Compare).phase,
                 SyncPhase::Different);
    }

    void refusalsAreReported_data() { kindRows(); }

    void refusalsAreReported()
    {
        QFETCH(bool, isPx4);
        LinkScene scene(kindOf(isPx4));
        QVERIFY(scene.meet());
        const SyncStatus tooMany = scene.sync({missionPart(800)});
        QCOMPARE(tooMany.transfer.failure, TransferFailure::Refused);
        QCOMPARE(tooMany.transfer.result, 4);
        MissionPart wrong = missionPart(5);
        wrong.items[2].x = 950'000'000;
        const SyncStatus invalid = scene.sync({wrong});
        QCOMPARE(invalid.transfer.failure, TransferFailure::Refused);
        QCOMPARE(invalid.transfer.result, 10);
        QCOMPARE(invalid.transfer.item, std::optional(isPx4 ? 2 : 3));
        MissionPart misplaced{.type = MissionType::Mission, .items = someFence()};
        QCOMPARE(scene.sync({misplaced}).phase, SyncPhase::Failed);
    }

    void vehiclesThatDoNotAnswer()
    {
        LinkScene scene(AutopilotKind::Px4);
        QVERIFY(scene.meet());
        scene.filtered.setFilter(
            [](const LinkMessage& message) { return message.id() != MessageId::MissionCount; });
        const SyncStatus status = scene.sync({missionPart(5)});
        QCOMPARE(status.transfer.failure, TransferFailure::NoAnswer);
        scene.filtered.setFilter([](const LinkMessage& message) {
            return message.id() != MessageId::MissionRequestList;
        });
        const SyncStatus read = scene.sync({missionPart(5)}, MissionSync::Task::Compare);
        QCOMPARE(read.transfer.failure, TransferFailure::NoAnswer);
    }

    /** Messages with 300 random values cause no crash, and the upload ends. */
    void anyMessageMayCome()
    {
        Random random(11);
        for (int round = 0; round < 50; ++round) {
            MissionUpload upload(someMission(5), MissionType::Mission, LinkScene::address);
            MissionDownload download(MissionType::Mission, LinkScene::address);
            double time_s = 0;
            for (int i = 0; i < 300; ++i) {
                time_s += random.uniform(0, 2);
                (void)upload.advance(time_s);
                (void)download.advance(time_s);
                const std::span<const MessageSpec> specs = messageSpecs();
                const MessageSpec& spec = specs[random.below(specs.size())];
                std::vector<std::uint8_t> payload(spec.fullLength);
                for (std::uint8_t& byte : payload)
                    byte = static_cast<std::uint8_t>(random.below(3) == 0 ? random.below(256) : 0);
                const LinkMessage message(spec, payload);
                (void)upload.receive(message, time_s);
                (void)download.receive(message, time_s);
            }
            QVERIFY(upload.status().state != TransferState::Running);
            QVERIFY(download.status().state != TransferState::Running);
        }
    }
};

QTEST_APPLESS_MAIN(TestMissionSync)
#include "tst_mission_sync.moc"
