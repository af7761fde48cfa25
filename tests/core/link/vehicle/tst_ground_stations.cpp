// The vehicle's side against ground stations of others.

#include "tests/support/approx.h"
#include "tests/support/flight/station_scene.h"

using namespace berg;
using namespace berg::test;

namespace {

AutopilotKind stationKind(bool isPx4)
{
    return isPx4 ? AutopilotKind::Px4 : AutopilotKind::ArduPilot;
}

bool areEqual(const std::vector<LinkMissionItem>& a, const std::vector<LinkMissionItem>& b)
{
    return missionDifferences(a, b).empty();
}

} // namespace

class TestGroundStations : public QObject
{
    Q_OBJECT

private slots:
    void kinds_data()
    {
        QTest::addColumn<bool>("isPx4");
        QTest::newRow("ArduPilot") << false;
        QTest::newRow("PX4") << true;
    }

    /** MAVProxy asks for all streams at 4 Hz; its first telemetry is what a user sees. */
    void allStreamsAreSent_data() { kinds_data(); }

    void allStreamsAreSent()
    {
        QFETCH(bool, isPx4);
        StationScene scene(stationKind(isPx4));
        scene.send(toVehicle(MessageId::RequestDataStream)
                       .with("req_stream_id", 0)
                       .with("req_message_rate", 4)
                       .with("start_stop", 1));
        scene.heard.clear();
        scene.run(10);
        for (const MessageId id :
             {MessageId::GlobalPositionInt, MessageId::Attitude, MessageId::VfrHud,
              MessageId::SysStatus, MessageId::GpsRawInt, MessageId::MissionCurrent,
              MessageId::SystemTime, MessageId::BatteryStatus}) {
            const auto count = std::ranges::count(scene.heard, id, &LinkMessage::id);
            QVERIFY2(count >= 30 && count <= 42, std::to_string(static_cast<int>(id)).c_str());
        }
        QVERIFY(std::ranges::count(scene.heard, MessageId::Heartbeat, &LinkMessage::id) >= 9);
    }

    /** Only these flags make MAVProxy transfer fences and rally points by the mission protocol. */
    void versionAndHomeAreRequested()
    {
        StationScene scene(AutopilotKind::ArduPilot);
        for (const LinkMessage& request : {commandLong(512, {148, 1}), commandLong(520, {1, 1})}) {
            const LinkMessage version = scene.answer(request, MessageId::AutopilotVersion);
            QCOMPARE(version.id(), MessageId::AutopilotVersion);
            QCOMPARE(version.integer("capabilities") & (16384 | 32768), 16384 | 32768);
            QCOMPARE(scene.result(request), 0);
        }
        const LinkMessage home = scene.answer(commandLong(410), MessageId::HomePosition);
        QCOMPARE(home.integer("latitude"), 470'000'000);
        QCOMPARE(home.integer("altitude"), 1500);
    }

    void parametersAreFetched()
    {
        StationScene scene(AutopilotKind::ArduPilot);
        std::set<int> indices;
        for (const LinkMessage& each : scene.answers(toVehicle(MessageId::ParamRequestList)))
            if (each.id() == MessageId::ParamValue) {
                QCOMPARE(each.integer("param_count"), 3);
                indices.insert(static_cast<int>(each.integer("param_index")));
            }
        QVERIFY((indices == std::set<int>{0, 1, 2}));
        LinkMessage one = toVehicle(MessageId::ParamRequestRead).with("param_index", 1);
        QCOMPARE(scene.answer(one, MessageId::ParamValue).text("param_id"), "WP_RADIUS");
        one.with("param_index", -1).withText("param_id", "FENCE");
        QCOMPARE(scene.answer(one, MessageId::ParamValue).integer("param_index"), 2);
        const LinkMessage set = toVehicle(MessageId::ParamSet)
                                    .withText("param_id", "WP_RADIUS")
                                    .withReal("param_value", 7);
        COMPARE_NEAR(scene.answer(set, MessageId::ParamValue).real("param_value"), 50, 0);
    }

    void listsAreRead_data() { kinds_data(); }

    void listsAreRead()
    {
        QFETCH(bool, isPx4);
        StationScene scene(stationKind(isPx4));
        scene.vehicle.load(MissionType::Mission, someMission(14));
        scene.vehicle.load(MissionType::Fence, someFence());
        scene.vehicle.load(MissionType::Rally, someRally());
        std::vector<LinkMissionItem> mission = scene.list(MissionType::Mission);
        if (!isPx4) { // home is item 0
            QCOMPARE(mission.size(), std::size_t{15});
            QCOMPARE(mission.front().x, 470'000'000);
            COMPARE_NEAR(static_cast<double>(mission.front().z), 1.5, 1e-6);
        }
        QVERIFY(areEqual(someMission(14),
                         itemsReadBack(mission, MissionType::Mission, stationKind(isPx4))));
        QVERIFY(areEqual(someFence(), scene.list(MissionType::Fence)));
        QVERIFY(areEqual(someRally(), scene.list(MissionType::Rally)));
        QCOMPARE(scene.list(MissionType::Rally).size(), std::size_t{1}); // once more
    }

    /** The station neither repeats its count nor answers MISSION_REQUEST_INT. */
    void listsAreWritten_data() { kinds_data(); }

    void listsAreWritten()
    {
        QFETCH(bool, isPx4);
        StationScene scene(stationKind(isPx4));
        const std::vector<LinkMissionItem> mission =
            itemsToSend(someMission(14), MissionType::Mission, stationKind(isPx4));
        QCOMPARE(scene.load(MissionType::Mission, mission), 0);
        QCOMPARE(scene.load(MissionType::Fence, someFence()), 0);
        QCOMPARE(scene.load(MissionType::Rally, someRally()), 0);
        const VehicleMissions& missions = scene.vehicle.missions();
        QVERIFY(areEqual(someMission(14), missions.items(MissionType::Mission)));
        QVERIFY(areEqual(someFence(), missions.items(MissionType::Fence)));
        QVERIFY(areEqual(someRally(), missions.items(MissionType::Rally)));

        for (const MissionType type : {MissionType::Fence, MissionType::Mission}) {
            const LinkMessage cleared = scene.answer(
                toVehicle(MessageId::MissionClearAll).with("mission_type", static_cast<int>(type)),
                MessageId::MissionAck);
            QCOMPARE(cleared.integer("type"), 0);
            QCOMPARE(cleared.integer("mission_type"), static_cast<int>(type));
            QVERIFY(missions.items(type).empty());
        }
        QCOMPARE(missions.items(MissionType::Rally).size(), std::size_t{1});
    }

    /** "wp move", "wp param" and "wp changealt" write one part of a list. */
    void partsOfListsAreWritten()
    {
        StationScene scene(AutopilotKind::ArduPilot);
        scene.vehicle.load(MissionType::Mission, someMission(8));
        std::vector<LinkMissionItem> wire =
            itemsToSend(someMission(8), MissionType::Mission, AutopilotKind::ArduPilot);
        wire[3].x += 5000;
        wire[4].z = 90;
        const auto partial = [](int first, int last) {
            return toVehicle(MessageId::MissionWritePartialList)
                .with("start_index", first)
                .with("end_index", last);
        };
        QCOMPARE(scene.load(partial(3, 3), wire), 0);
        QCOMPARE(scene.load(partial(3, 4), wire), 0);
        QVERIFY(areEqual(itemsReadBack(wire, MissionType::Mission, AutopilotKind::ArduPilot),
                         scene.vehicle.missions().items(MissionType::Mission)));
        QCOMPARE(scene.load(partial(4, 3), wire), 1);
        QCOMPARE(scene.load(partial(3, 30), wire), 1);
        QCOMPARE(scene.load(partial(-1, 3), wire), 1);
        QCOMPARE(scene.vehicle.missions().items(MissionType::Mission).size(), std::size_t{8});
    }

    void anUploadIsClearedByItsStationOnly()
    {
        StationScene scene(AutopilotKind::ArduPilot);
        scene.vehicle.load(MissionType::Mission, someMission(8));
        const std::unique_ptr<MemoryLink> other = scene.hub.addPeer();
        FrameWriter writer({.system = 254, .component = 190});
        const LinkMessage clear = toVehicle(MessageId::MissionClearAll);
        scene.send(toVehicle(MessageId::MissionCount).with("count", 9));
        scene.run(0.2);
        other->send(0, writer.write(clear, 0));
        scene.run(0.2);
        QVERIFY(!scene.vehicle.missions().items(MissionType::Mission).empty());
        QCOMPARE(scene.answer(clear, MessageId::MissionAck).integer("type"), 0);
        QVERIFY(scene.vehicle.missions().items(MissionType::Mission).empty());
        scene.heard.clear();
        scene.run(3); // nothing is requested any more
        QVERIFY(std::ranges::count(scene.heard, MessageId::MissionRequest, &LinkMessage::id) == 0);
    }

    /** Some stations read home although there is no mission. */
    void homeIsReadWithoutAMission()
    {
        StationScene scene(AutopilotKind::ArduPilot);
        const LinkMessage item =
            scene.answer(toVehicle(MessageId::MissionRequest), MessageId::MissionItem);
        QCOMPARE(item.id(), MessageId::MissionItem);
        COMPARE_NEAR(item.real("x"), 47, 1e-5); // a float
        QCOMPARE(scene
                     .answer(toVehicle(MessageId::MissionRequestInt).with("seq", 1),
                             MessageId::MissionAck)
                     .integer("type"),
                 1);
    }

    /** Commands of pymavlink for `mode` in MAVProxy, and the message of its older versions. */
    void modesAreSet()
    {
        StationScene plane(AutopilotKind::ArduPilot);
        QCOMPARE(plane.result(commandLong(176, {1, 12})), 0);
        QCOMPARE(plane.readings.mode, 12U);
        LinkMessage old(MessageId::SetMode);
        old.with("target_system", 1).with("base_mode", 1).with("custom_mode", 10);
        const LinkMessage ack = plane.answer(old, MessageId::CommandAck);
        QCOMPARE(ack.integer("command"), 11);
        QCOMPARE(ack.integer("result"), 0);
        QCOMPARE(plane.readings.mode, 10U);
        QCOMPARE(plane.result(commandLong(176, {1, 99})), 4);
        QCOMPARE(plane.result(commandLong(176, {0, 12})), 2); // not a custom mode
        QCOMPARE(plane.readings.mode, 10U);

        StationScene px4(AutopilotKind::Px4);
        constexpr double kBaseMode = 1 + 4 + 8 + 16; // of pymavlink's table of PX4's modes
        QCOMPARE(px4.result(commandLong(176, {kBaseMode, 4, 5})), 0);
        QCOMPARE(px4.readings.mode, 0x05040000U);
        QCOMPARE(px4.result(commandLong(176, {1 + 64, 1, 0})), 0);
        QCOMPARE(px4.readings.mode, 0x00010000U);
        QCOMPARE(px4.result(commandLong(176, {kBaseMode, 4, 0})), 4);
        QCOMPARE(px4.result(commandLong(176, {kBaseMode, 9, 0})), 4);
    }

    /** pymavlink names a mode of PX4 only with these flags, else it is "UNKNOWN". */
    void heartbeatsHaveTheFlagsOfTheirMode()
    {
        constexpr int kAutomatic = 4 + 8 + 16;
        constexpr int kManual = 64;
        const auto flags = [](StationScene& scene, std::uint32_t mode) {
            scene.readings.mode = mode;
            scene.run(1.1);
            const auto last =
                std::find_if(scene.heard.rbegin(), scene.heard.rend(), [](const LinkMessage& each) {
                    return each.id() == MessageId::Heartbeat;
                });
            return static_cast<int>(last->integer("base_mode"));
        };
        StationScene px4(AutopilotKind::Px4);
        for (const std::uint32_t mode : {0x03040000U, 0x04040000U, 0x05040000U}) {
            QCOMPARE(flags(px4, mode) & (kAutomatic | kManual), kAutomatic);
            QCOMPARE(flags(px4, mode) & 129, 129); // armed, custom mode
        }
        for (const std::uint32_t mode : {0x00010000U, 0x00020000U, 0x00070000U})
            QCOMPARE(flags(px4, mode) & kManual, kManual);
        StationScene plane(AutopilotKind::ArduPilot);
        QCOMPARE(flags(plane, 10), 157); // as the frame that the C library has written
        QCOMPARE(flags(plane, 0) & (kAutomatic | kManual), kManual);
        QCOMPARE(flags(plane, 5) & (kAutomatic | kManual), 16);
    }

    void itemsAreSelected_data() { kinds_data(); }

    void itemsAreSelected()
    {
        QFETCH(bool, isPx4);
        StationScene scene(stationKind(isPx4));
        const int offset = isPx4 ? 0 : 1;
        QCOMPARE(scene.result(commandLong(224, {1})), 4); // no mission
        scene.vehicle.load(MissionType::Mission, someMission(6));
        scene.orders.clear();
        QCOMPARE(scene.result(commandLong(224, {3})), 0);
        QCOMPARE(scene.orders.size(), std::size_t{1});
        QCOMPARE(scene.orders.back().item, 3 - offset);
        // The number in MISSION_CURRENT acknowledges the older message.
        const LinkMessage set = toVehicle(MessageId::MissionSetCurrent).with("seq", 5);
        bool isAcknowledged = false;
        for (const LinkMessage& each : scene.answers(set))
            isAcknowledged = isAcknowledged ||
                             (each.id() == MessageId::MissionCurrent && each.integer("seq") == 5);
        QVERIFY(isAcknowledged);
        QCOMPARE(scene.orders.back().item, 5 - offset);
        QCOMPARE(scene.result(commandLong(224, {6.0 + offset})), 4);
        QCOMPARE(scene.result(commandLong(224, {-1})), 4);
        QCOMPARE(scene.orders.size(), std::size_t{2});
    }

    /** `guided` of MAVProxy: a command, or in older versions an item with `current` 2. */
    void guidedFlight()
    {
        StationScene scene(AutopilotKind::ArduPilot);
        LinkMessage command = toVehicle(MessageId::CommandInt)
                                  .with("command", LinkCommandId::kReposition)
                                  .with("frame", 3)
                                  .with("x", 470'100'000)
                                  .with("y", -480'100'000)
                                  .withReal("param1", -1)
                                  .withReal("z", 110);
        QCOMPARE(scene.result(command), 2); // in AUTO only with the flag that changes the mode
        QVERIFY(scene.orders.empty());
        QCOMPARE(scene.result(command.withReal("param2", 1)), 0);
        QCOMPARE(scene.orders.back().kind, VehicleOrder::Kind::Reposition);

        LinkMessage item = toVehicle(MessageId::MissionItemInt)
                               .with("command", LinkCommandId::kWaypoint)
                               .with("frame", 3)
                               .with("current", 2)
                               .with("x", 470'200'000)
                               .with("y", -480'200'000)
                               .withReal("z", 90);
        QCOMPARE(scene.answer(item, MessageId::MissionAck).integer("type"), 1); // not in GUIDED
        scene.readings.mode = 15;
        const LinkMessage ack = scene.answer(item, MessageId::MissionAck);
        QCOMPARE(ack.integer("type"), 0);
        QCOMPARE(ack.integer("target_component"), int{kMavproxy.component});
        QCOMPARE(scene.orders.back().kind, VehicleOrder::Kind::Reposition);
        COMPARE_NEAR(scene.orders.back().place.latitude_deg, 47.02, 1e-9);
        QCOMPARE(scene.orders.back().altitude_m, 90.0);
        QVERIFY(scene.vehicle.missions().items(MissionType::Mission).empty());

        StationScene px4(AutopilotKind::Px4);
        QCOMPARE(px4.result(command), 0);
        QCOMPARE(px4.orders.back().frame, ItemFrame::Global); // whatever the station says
        px4.orders.clear();
        QCOMPARE(px4.answers(item).empty(), false);
        QVERIFY(px4.orders.empty());
    }

    void addressesAreObeyed()
    {
        StationScene scene(AutopilotKind::ArduPilot);
        const auto addressed = [](LinkAddress target) {
            return LinkMessage(MessageId::CommandLong)
                .with("command", 410)
                .with("target_system", target.system)
                .with("target_component", target.component);
        };
        QCOMPARE(scene.result(addressed({.system = 0, .component = 0})), 0);
        QCOMPARE(scene.result(addressed({.system = 1, .component = 1})), 0);
        QCOMPARE(scene.result(addressed({.system = 2, .component = 1})), -1);
        QCOMPARE(scene.result(addressed({.system = 1, .component = 154})), -1); // a gimbal
    }

    /** Every command has an answer, so that no station waits. */
    void otherCommandsAreRefused()
    {
        StationScene scene(AutopilotKind::ArduPilot);
        for (const std::uint16_t command :
             std::to_array<std::uint16_t>({176, 207, 209, 241, 246, 300, 400, 512, 2500, 31000}))
            QVERIFY2(scene.result(commandLong(command, {0, 0})) > 0,
                     std::to_string(command).c_str());
        QCOMPARE(scene.result(commandLong(31000)), 3);
        QCOMPARE(scene.result(commandLong(400, {1})), 2);
        QVERIFY(scene.orders.empty());
    }

    /** The interval 0 asks for the default: PX4 sends by itself, ArduPilot does not. */
    void intervalsAreSet_data() { kinds_data(); }

    void intervalsAreSet()
    {
        QFETCH(bool, isPx4);
        StationScene scene(stationKind(isPx4));
        const auto heardIn = [&](double interval_us) {
            (void)scene.result(commandLong(511, {33, interval_us}));
            scene.heard.clear();
            scene.run(10);
            return std::ranges::count(scene.heard, MessageId::GlobalPositionInt, &LinkMessage::id);
        };
        const auto often = heardIn(100'000); // every second or third step
        QVERIFY2(often > 60 && often < 105, std::to_string(often).c_str());
        QCOMPARE(heardIn(-1), 0);
        const auto byDefault = heardIn(0);
        QVERIFY2(isPx4 ? byDefault > 35 && byDefault < 55 : byDefault == 0,
                 std::to_string(byDefault).c_str());
        QCOMPARE(scene.result(commandLong(511, {30000, 1e6})), 3);
    }

    /** A station that begins with MAVLink 1 is answered, too. */
    void oldFramesAreAnswered()
    {
        StationScene scene(AutopilotKind::ArduPilot);
        scene.vehicle.load(MissionType::Mission, someMission(3));
        scene.heard.clear();
        scene.link->send(0, oldFrame(toVehicle(MessageId::MissionRequestList), kMavproxy));
        scene.run(0.5);
        const auto count =
            std::ranges::find(scene.heard, MessageId::MissionCount, &LinkMessage::id);
        QVERIFY(count != scene.heard.end());
        QCOMPARE(count->integer("count"), 4);
    }
};

QTEST_APPLESS_MAIN(TestGroundStations)
#include "tst_ground_stations.moc"
