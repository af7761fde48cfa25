#include "core/link/logs/telemetry_log.h"
#include "tests/support/approx.h"
#include "tests/support/flight/link_scene.h"

#include <array>
#include <malloc.h>
#include <numbers>
#include <set>

using namespace berg;
using namespace berg::test;

namespace {

constexpr LinkAddress kUav{.system = 1, .component = 1};

const AircraftState& stateOf(const LinkScene& scene)
{
    return scene.session.findVehicle(kUav)->state;
}

LinkMessage heartbeat(int type, int autopilot)
{
    return LinkMessage(MessageId::Heartbeat).with("type", type).with("autopilot", autopilot);
}

/** Returns the result of a command once it has ended; -1 for no answer, -2 if it is not sent. */
int resultOf(LinkScene& scene, const LinkCommand& command)
{
    const std::optional<int> number = scene.session.sendCommand(kUav, command);
    if (!number)
        return -2;
    const auto ended = [&] {
        return std::find_if(scene.events.begin(), scene.events.end(), [&](const LinkEvent& event) {
            return event.kind == LinkEvent::Kind::CommandEnded && event.value == *number;
        });
    };
    scene.runUntil([&] { return ended() != scene.events.end(); }, 60);
    return ended()->command->result.value_or(-1);
}

} // namespace

class TestLinkSession : public QObject
{
    Q_OBJECT

private slots:
    void kinds_data()
    {
        QTest::addColumn<bool>("isPx4");
        QTest::newRow("ArduPilot") << false;
        QTest::newRow("PX4") << true;
    }

    /** The peer counts bytes: none is sent, whatever arrives. */
    void nothingIsSentWhileSendingIsOff()
    {
        LinkScene scene(AutopilotKind::Px4);
        scene.run(60);
        QVERIFY(stateOf(scene).position.has_value());
        QVERIFY(!scene.session.startSync(kUav, {{.items = someMission(4)}},
                                         MissionSync::Task::UploadAndCompare));
        QVERIFY(!scene.session.sendCommand(
            kUav, {.command = LinkCommandId::kSetCurrentItem, .params = {1, 0, 0, 0, 0, 0, 0}}));
        QCOMPARE(scene.filtered.sent(), 0);

        scene.session.setSending(true);
        scene.run(5);
        QVERIFY(scene.session.startSync(kUav, {{.items = someMission(14)}},
                                        MissionSync::Task::UploadAndCompare));
        scene.step();
        scene.session.setSending(false);
        const int before = scene.filtered.sent();
        QVERIFY(before > 5); // heartbeats, requests and the beginning of an upload
        scene.run(20);
        QCOMPARE(scene.filtered.sent(), before);
        QVERIFY(!scene.session.findVehicle(kUav)->sync);
    }

    void telemetryIsAskedForAndFollowed_data() { kinds_data(); }

    void telemetryIsAskedForAndFollowed()
    {
        QFETCH(bool, isPx4);
        LinkScene scene(isPx4 ? AutopilotKind::Px4 : AutopilotKind::ArduPilot);
        QVERIFY(scene.meet());
        scene.run(5);
        const AircraftState& state = stateOf(scene);
        QVERIFY(state.position && state.attitude && state.wind && state.battery && state.home);
        COMPARE_NEAR(state.position->place.latitude_deg, 47.0053, 1e-7);
        COMPARE_NEAR(state.position->place.longitude_deg, -47.9912, 1e-7);
        COMPARE_NEAR(state.position->altitude_m, 121.5, 1e-3);
        COMPARE_NEAR(state.position->aboveHome_m, 120, 1e-3);
        COMPARE_NEAR(state.position->east_mps, -15, 0.01);
        COMPARE_NEAR(*state.position->heading_rad, 5.5, 1e-4); // hundredths of degrees
        COMPARE_NEAR(state.attitude->heading_rad, 5.5, 1e-6);
        COMPARE_NEAR(state.wind->north_mps, 3, 1e-5);
        COMPARE_NEAR(state.wind->meanEast_mps, -4, 1e-5);
        COMPARE_NEAR(state.wind->scatter_mps, 0, 1e-4);
        COMPARE_NEAR(*state.battery->remaining, 0.72, 1e-9);
        QCOMPARE(state.battery->timeRemaining_s, std::optional(3600.0));
        COMPARE_NEAR(*state.airspeed_mps, 22, 1e-5);
        COMPARE_NEAR(*state.homeAltitude_m, 1.5, 1e-3);
        QCOMPARE(state.isFlying, std::optional(true));
        QVERIFY(state.position->received_s > scene.time_s - 0.4); // several times a second
        QCOMPARE(scene.session.findVehicle(kUav)->mode, 10U);
    }

    void oldAutopilotsAreAskedForWholeStreams()
    {
        LinkScene scene(AutopilotKind::ArduPilot);
        std::set<int> streams;
        scene.filtered.setFilter([&](const LinkMessage& message) {
            if (message.id() == MessageId::RequestDataStream)
                streams.insert(static_cast<int>(message.integer("req_stream_id")));
            if (message.id() != MessageId::CommandLong || message.integer("command") != 511)
                return true;
            scene.hub.send(
                0, frameBytes(
                       LinkMessage(MessageId::CommandAck).with("command", 511).with("result", 3),
                       kUav, 0));
            return false;
        });
        QVERIFY(scene.meet());
        scene.run(5);
        QVERIFY((streams == std::set<int>{2, 6, 10, 11, 12}));
        QVERIFY(stateOf(scene).position.has_value());
    }

    /**
     * The link is cut for a minute: the vehicle is lost once and returns once, and telemetry
     * continues.
     */
    void cutLinkIsNoticed()
    {
        LinkScene scene(AutopilotKind::ArduPilot);
        QVERIFY(scene.meet());
        scene.run(10);
        const double contact_s = scene.time_s;
        scene.impaired.setImpairment({.loss = 1});
        QVERIFY(scene.runUntil([&] { return scene.count(LinkEvent::Kind::VehicleLost) == 1; }, 5));
        QVERIFY(scene.time_s - contact_s > 1.9 && scene.time_s - contact_s < 3.2);
        scene.run(57);
        QVERIFY(stateOf(scene).position->received_s <= contact_s);
        scene.impaired.setImpairment({});
        scene.run(5);
        QCOMPARE(scene.count(LinkEvent::Kind::VehicleReturned), 1);
        QCOMPARE(scene.count(LinkEvent::Kind::VehicleLost), 1);
        QVERIFY(stateOf(scene).position->received_s > scene.time_s - 1);
    }

    /** About 2500 frames at 20 %: the gaps give the share lost within five standard deviations. */
    void lossIsCounted()
    {
        LinkScene scene(AutopilotKind::Px4, {.loss = 0.2, .seed = 8});
        scene.run(150);
        const SenderLoss& loss = scene.session.senders().at(kUav);
        const double all = static_cast<double>(loss.received + loss.lost);
        QVERIFY(all > 2000);
        COMPARE_NEAR(static_cast<double>(loss.lost) / all, 0.2, 5 * std::sqrt(0.16 / all));
    }

    void commandsAreSentUntilAnswered()
    {
        LinkScene scene(AutopilotKind::ArduPilot, {.loss = 0.2, .seed = 5});
        QVERIFY(scene.meet());
        scene.run(3);
        QCOMPARE(
            resultOf(scene, {.command = LinkCommandId::kSetMode, .params = {1, 15, 0, 0, 0, 0, 0}}),
            0);
        QCOMPARE(scene.orders.back().kind, VehicleOrder::Kind::SetMode);
        QCOMPARE(scene.orders.back().mode, 15U);
        QCOMPARE(resultOf(scene, {.command = LinkCommandId::kReposition,
                                  .params = {-1, 1, 300, 0, 470'053'000, -479'912'000, 120},
                                  .frame = ItemFrame::AboveHome}),
                 0);
        const VehicleOrder& order = scene.orders.back();
        QCOMPARE(order.kind, VehicleOrder::Kind::Reposition);
        COMPARE_NEAR(order.place.longitude_deg, -47.9912, 1e-7);
        QCOMPARE(order.altitude_m, 120.0);
        QCOMPARE(order.radius_m, 300.0);
        // Requires COMMAND_INT.
        QCOMPARE(resultOf(scene, {.command = LinkCommandId::kReposition}), 8);
    }

    void commandsWithoutAnswerEnd()
    {
        LinkScene scene(AutopilotKind::Px4);
        int sends = 0;
        int lastConfirmation = -1;
        QVERIFY(scene.meet());
        scene.run(5);
        scene.filtered.setFilter([&](const LinkMessage& message) {
            if (message.id() != MessageId::CommandLong)
                return true;
            ++sends;
            lastConfirmation = static_cast<int>(message.integer("confirmation"));
            return false;
        });
        const double start_s = scene.time_s;
        QCOMPARE(resultOf(scene, {.command = LinkCommandId::kSetCurrentItem}), -1);
        QCOMPARE(sends, 4);
        QCOMPARE(lastConfirmation, 3);
        COMPARE_NEAR(scene.time_s - start_s, 4, 0.3);
    }

    /** Sending never arms, takes off, lands, changes parameters or terminates. */
    void dangerousCommandsAreRefused()
    {
        LinkScene scene(AutopilotKind::ArduPilot);
        QVERIFY(scene.meet());
        for (const std::uint16_t command :
             std::to_array<std::uint16_t>({21, 22, 84, 85, 180, 183, 185, 246, 300, 400}))
            QCOMPARE(resultOf(scene, {.command = command}), -2);
        for (int mode : {0, 2, 13, 20, 26}) // MANUAL, STABILIZE, TAKEOFF, QLAND, AUTOLAND
            QCOMPARE(resultOf(scene, {.command = LinkCommandId::kSetMode,
                                      .params = {1, static_cast<double>(mode), 0, 0, 0, 0, 0}}),
                     -2);
        const LinkCommand takeOff{.command = LinkCommandId::kSetMode,
                                  .params = {1, 4, 2, 0, 0, 0, 0}};
        QVERIFY(!isPermitted(takeOff, AutopilotKind::Px4));
        const LinkCommand mission{.command = LinkCommandId::kSetMode,
                                  .params = {1, 4, 4, 0, 0, 0, 0}};
        QVERIFY(isPermitted(mission, AutopilotKind::Px4));
        CommandQueue queue(kUav, AutopilotKind::ArduPilot);
        QVERIFY_THROWS_EXCEPTION(std::logic_error, queue.add({.command = 400}));
    }

    void busyVehiclesGetMoreTime()
    {
        CommandQueue queue(kUav, AutopilotKind::Px4);
        queue.add({.command = LinkCommandId::kOrbit});
        QCOMPARE(queue.advance(0).size(), std::size_t{1});
        LinkMessage ack(MessageId::CommandAck);
        queue.receive(ack.with("command", LinkCommandId::kOrbit).with("result", 5), 0.5);
        QVERIFY(queue.advance(9).empty());
        queue.receive(ack.with("result", 0), 9.5);
        QCOMPARE(queue.takeResults().at(0).result, std::optional(0));
        QVERIFY(queue.takeResults().empty());
    }

    void anotherStationWithOurIdSilencesUs()
    {
        LinkScene scene(AutopilotKind::Px4);
        QVERIFY(scene.meet());
        scene.hub.send(0, frameBytes(heartbeat(6, 8), {.system = 254, .component = 190}, 0));
        scene.run(1);
        QVERIFY(scene.session.isSending());
        scene.hub.send(0, frameBytes(heartbeat(6, 8), {.system = 255, .component = 190}, 0));
        scene.run(1);
        QVERIFY(!scene.session.isSending());
        QCOMPARE(scene.count(LinkEvent::Kind::SameIdHeard), 1);
        QCOMPARE(scene.session.vehicles().size(), std::size_t{1}); // stations are not vehicles
    }

    void textsComeInChunks()
    {
        LinkScene scene(AutopilotKind::Px4);
        QVERIFY(scene.meet());
        const auto chunk = [](int id, int number, const std::string& text) {
            return frameBytes(LinkMessage(MessageId::StatusText)
                                  .with("severity", 4)
                                  .with("id", id)
                                  .with("chunk_seq", number)
                                  .withText("text", text),
                              kUav, 0);
        };
        const std::string first(50, 'a');
        scene.hub.send(0, chunk(7, 0, first));
        scene.hub.send(0, chunk(7, 1, "end"));
        scene.hub.send(0, chunk(0, 0, "alone <b>"));
        for (int i = 0; i < 100; ++i) // never ends
            scene.hub.send(0, chunk(9, i, first));
        scene.step();
        std::vector<std::string> texts;
        for (const LinkEvent& event : scene.events)
            if (event.kind == LinkEvent::Kind::Text)
                texts.push_back(event.text);
        QCOMPARE(texts.at(0), first + "end");
        QCOMPARE(texts.at(1), "alone <b>");
        for (const std::string& text : texts)
            QVERIFY(text.size() <= 1000);
    }

    void floodsAreCutAndSendersBounded()
    {
        LinkScene scene(AutopilotKind::Px4);
        QVERIFY(scene.meet());
        for (int system = 2; system < 256; ++system)
            scene.hub.send(
                0, frameBytes(heartbeat(1, 3),
                              {.system = static_cast<std::uint8_t>(system), .component = 1}, 0));
        scene.step();
        QCOMPARE(scene.session.vehicles().size(), std::size_t{32});
        QVERIFY(scene.session.senders().size() <= 256);
        const std::vector<std::uint8_t> big(1400, 0xFD);
        for (int i = 0; i < 1000; ++i)
            scene.hub.send(0, big);
        scene.step();
        QVERIFY(scene.session.exchange().dropped_bytes() > 900'000);
        scene.run(3); // then everything is as before
        QVERIFY(stateOf(scene).position->received_s > scene.time_s - 1);
    }

    void signedLinksIgnoreOthers()
    {
        SigningKey key{};
        key.fill(7);
        auto [near, far] = MemoryLink::pair();
        LinkSession session(near, {.key = key});
        VehicleSide vehicle(far, {.self = {.system = 3, .component = 1}, .key = key});
        VehicleSide stranger(far, {.self = {.system = 4, .component = 1}});
        session.setSending(true);
        for (int i = 1; i < 100; ++i) {
            const LinkTime now = linkTime(0.05 * i);
            (void)vehicle.advance(now, flyingReadings());
            (void)stranger.advance(now, flyingReadings());
            (void)session.advance(now);
        }
        QCOMPARE(session.vehicles().size(), std::size_t{1});
        QCOMPARE(session.vehicles().front().address.system, std::uint8_t{3});
        QCOMPARE(session.vehicles().front().signature, SignatureVerdict::Valid);
        // It has received our requests.
        QVERIFY(session.vehicles().front().state.position.has_value());
        QVERIFY(session.exchange().unverified() > 3);
    }

    /** Reading the log of a session gives the same states. */
    void logIsReadBackAsARecordedFlight()
    {
        HubLink hub;
        const std::unique_ptr<MemoryLink> station = hub.addPeer();
        std::vector<std::uint8_t> log;
        const auto write = [&](LinkTime now, std::span<const std::uint8_t> frame) {
            const std::vector<std::uint8_t> record = logRecord(now.unix_us, frame);
            log.insert(log.end(), record.begin(), record.end());
        };
        LinkSession session(*station, {.log = write});
        VehicleSide vehicle(hub, {.autopilot = AutopilotKind::Px4});
        session.setSending(true);
        VehicleReadings readings = flyingReadings();
        for (int i = 1; i < 400; ++i) {
            readings.place.latitude_deg += 1e-5;
            (void)vehicle.advance(linkTime(0.05 * i), readings);
            (void)session.advance(linkTime(0.05 * i));
        }
        TelemetryLogReader reader;
        std::vector<LoggedFrame> frames = reader.feed(log);
        for (LoggedFrame& frame : reader.finish())
            frames.push_back(std::move(frame));
        QCOMPARE(reader.skipped_bytes(), std::uint64_t{0});
        AircraftState replayed;
        bool hasOurs = false;
        for (const LoggedFrame& logged : frames) {
            hasOurs = hasOurs || logged.frame.sender.system == 255;
            const double time_s = static_cast<double>(logged.unix_us - linkTime(0).unix_us) / 1e6;
            if (logged.frame.sender == kUav)
                updateState(replayed, *logged.frame.message, time_s);
        }
        QVERIFY(hasOurs);
        const AircraftState& live = session.findVehicle(kUav)->state;
        QVERIFY(replayed.position->place == live.position->place);
        COMPARE_NEAR(replayed.position->received_s, live.position->received_s, 1e-6);
        COMPARE_NEAR(replayed.wind->meanEast_mps, live.wind->meanEast_mps, 1e-6);
    }

    /**
     * Many hours cost no more memory than one: 20 kB are far below a byte for each frame. ctest
     * listens for a day as well.
     */
    void memoryStaysFlat()
    {
        if (::mallinfo2().uordblks == 0)
            QSKIP("the allocator of a sanitizer does not count");
        const int hours = qEnvironmentVariableIntValue("BERGWATCH_LINK_HOURS");
        const double end_s = 3600 * (hours > 0 ? hours : 3);
        HubLink hub;
        const std::unique_ptr<MemoryLink> station = hub.addPeer();
        LinkSession session(*station, {});
        VehicleSide vehicle(hub, {.autopilot = AutopilotKind::Px4});
        const VehicleReadings readings = flyingReadings();
        std::uint64_t frames = 0;
        std::size_t afterAnHour = 0;
        for (double time_s = 0.2; time_s < end_s; time_s += 0.2) {
            (void)vehicle.advance(linkTime(time_s), readings);
            frames += session.advance(linkTime(time_s)).frames.size();
            if (afterAnHour == 0 && time_s > 3600)
                afterAnHour = ::mallinfo2().uordblks;
        }
        const std::size_t atTheEnd = ::mallinfo2().uordblks;
        QVERIFY2(static_cast<double>(frames) > 10 * end_s, std::to_string(frames).c_str());
        QVERIFY2(atTheEnd <= afterAnHour + 20'000, std::to_string(atTheEnd).c_str());
    }

    /** After ten seconds, its peer's number may belong to another sender. */
    void nothingIsSentToASilentVehicle()
    {
        LinkScene scene(AutopilotKind::ArduPilot);
        QVERIFY(scene.meet());
        scene.run(5);
        int sent = 0;
        scene.filtered.setFilter([&](const LinkMessage& message) {
            sent += message.id() == MessageId::Heartbeat ? 0 : 1;
            return true;
        });
        const LinkCommand command{.command = LinkCommandId::kSetCurrentItem, .params = {1}};
        scene.vehicle.reboot(linkTime(scene.time_s), 1000);
        scene.run(5);
        QCOMPARE(resultOf(scene, command), -1); // it may hear although it is not heard
        QVERIFY(sent > 0);
        scene.run(10);
        sent = 0;
        QCOMPARE(resultOf(scene, command), -1);
        QVERIFY(scene.session.startSync(kUav, {{.items = someMission(4)}},
                                        MissionSync::Task::UploadAndCompare));
        QVERIFY(scene.runUntil([&] { return scene.count(LinkEvent::Kind::SyncEnded) > 0; }, 600));
        QCOMPARE(sent, 0);
    }

    /** Telemetry for hours of a predicted flight would take seconds of work. */
    void noTelemetryIsMadeForNobody()
    {
        HubLink hub;
        VehicleSide vehicle(hub, {.autopilot = AutopilotKind::Px4});
        for (int second = 1; second < 100; ++second)
            (void)vehicle.advance(linkTime(second), flyingReadings());
        const std::unique_ptr<MemoryLink> station = hub.addPeer();
        (void)vehicle.advance(linkTime(100), flyingReadings());
        const std::optional<LinkPacket> packet = station->receive();
        QVERIFY(packet.has_value());
        FrameParser parser;
        QCOMPARE(static_cast<int>(parser.feedDatagram(packet->bytes).at(0).sequence), 0);
    }

    /** Vehicles on one link receive the same frames, so one of them logs these. */
    void receivedFramesAreLoggedOnce()
    {
        HubLink hub;
        const std::unique_ptr<MemoryLink> station = hub.addPeer();
        int logged = 0;
        VehicleSide vehicle(hub, {.log = [&](LinkTime, std::span<const std::uint8_t>) { ++logged; },
                                  .logsReceived = false});
        FrameWriter writer({.system = 255, .component = 190});
        station->send(0, writer.write(heartbeat(6, 8), 1));
        (void)vehicle.advance(linkTime(1), flyingReadings());
        QCOMPARE(logged, 1); // its own heartbeat
    }

    /** ArduPilot reports where the wind comes from; the scatter is that of the values. */
    void windAndItsScatter()
    {
        AircraftState state;
        LinkMessage wind(MessageId::Wind);
        updateState(state, wind.withReal("direction", 270).withReal("speed", 8.5), 0);
        COMPARE_NEAR(state.wind->east_mps, 8.5, 1e-5);
        COMPARE_NEAR(state.wind->north_mps, 0, 1e-5);
        // Values of 8 and 12 m/s in turn: mean 10, standard deviation 2. After ten time constants
        // the start is forgotten; the last values weigh 1/60 each.
        for (int i = 1; i <= 600; ++i)
            updateState(state, wind.withReal("speed", i % 2 == 0 ? 8 : 12), i);
        COMPARE_NEAR(state.wind->meanEast_mps, 10, 0.05);
        COMPARE_NEAR(state.wind->scatter_mps, 2, 0.05);
        updateState(state, LinkMessage(MessageId::WindCov).withReal("wind_x", std::nan("")), 700);
        COMPARE_NEAR(state.wind->received_s, 600, 0);
    }

    /** Any content of any message leaves a state of finite numbers. */
    void anyTelemetryMayCome()
    {
        Random random(4);
        AircraftState state;
        for (int i = 0; i < 20'000; ++i) {
            const std::span<const MessageSpec> specs = messageSpecs();
            const MessageSpec& spec = specs[random.below(specs.size())];
            std::vector<std::uint8_t> payload(spec.fullLength);
            for (std::uint8_t& byte : payload)
                byte = static_cast<std::uint8_t>(random.below(256));
            updateState(state, LinkMessage(spec, payload), i);
        }
        QVERIFY(std::abs(state.position->place.latitude_deg) <= 90);
        QVERIFY(std::isfinite(state.attitude->heading_rad));
        QVERIFY(!state.wind || std::isfinite(state.wind->scatter_mps));
    }
};

QTEST_APPLESS_MAIN(TestLinkSession)
#include "tst_link_session.moc"
