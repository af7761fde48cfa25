#include "core/base/random.h"
#include "core/link/message/link_frame.h"
#include "tests/support/flight/known_frames.h"

#include <QtTest>

#include <cmath>
#include <cstdlib>

using namespace berg;
using namespace berg::test;

namespace {

constexpr double kFloat = 1e-6; ///< Tolerance of values near 1 in single precision.

LinkFrame only(const std::vector<std::uint8_t>& bytes)
{
    FrameParser parser;
    std::vector<LinkFrame> frames = parser.feedDatagram(bytes);
    return frames.size() == 1 ? frames.front() : LinkFrame{};
}

LinkMessage decoded(std::string_view name)
{
    const LinkFrame frame = only(knownFrame(name));
    return frame.message.value_or(LinkMessage(MessageId::Ping));
}

void compareFields(const LinkMessage& message,
                   const std::vector<std::pair<std::string, double>>& fields)
{
    for (const auto& [name, value] : fields)
        QVERIFY2(std::abs(message.real(name) - value) <= kFloat * std::max(1.0, std::abs(value)),
                 (name + ' ' + std::to_string(message.real(name))).c_str());
}

/** A frame with an unknown id and any checksum. */
std::vector<std::uint8_t> unknownFrame(std::uint8_t sequence)
{
    std::vector<std::uint8_t> bytes{0xFD, 8, 0, 0, sequence, 1, 1, 0x1B, 0, 0};
    bytes.insert(bytes.end(), {1, 2, 3, 4, 5, 6, 7, 8, 0x55, 0xAA});
    return bytes;
}

std::vector<std::uint8_t> joined(std::initializer_list<std::vector<std::uint8_t>> parts)
{
    std::vector<std::uint8_t> all;
    for (const std::vector<std::uint8_t>& part : parts)
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

} // namespace

class TestLinkFrame : public QObject
{
    Q_OBJECT

private slots:
    /** Each text is one frame, and writing its message gives the same bytes. */
    void knownFramesAreReadAndWritten()
    {
        QCOMPARE(std::size(kKnownFrames), std::size_t{25});
        for (const KnownFrame& known : kKnownFrames) {
            const std::vector<std::uint8_t> bytes = bytesOfHex(known.hex);
            const LinkFrame frame = only(bytes);
            QVERIFY2(frame.message.has_value(), known.name.data());
            QVERIFY(frame.bytes == bytes);
            const bool isSigned = frame.signature.has_value();
            std::vector<std::uint8_t> again =
                frameBytes(*frame.message, frame.sender, frame.sequence, isSigned ? 1 : 0);
            if (isSigned)
                again.insert(again.end(), bytes.end() - 13, bytes.end());
            QVERIFY2(again == bytes, known.name.data());
        }
    }

    void valuesOfKnownFrames()
    {
        const LinkFrame heartbeat = only(knownFrame("HEARTBEAT_plane"));
        QVERIFY((heartbeat.sender == LinkAddress{.system = 1, .component = 1}));
        QCOMPARE(heartbeat.sequence, std::uint8_t{7});
        compareFields(*heartbeat.message, {{"type", 1},
                                           {"autopilot", 3},
                                           {"base_mode", 157},
                                           {"custom_mode", 10},
                                           {"system_status", 4}});
        compareFields(decoded("MISSION_COUNT"), {{"count", 14}, {"mission_type", 0}});
        const LinkMessage item = decoded("MISSION_ITEM_INT");
        compareFields(item, {{"seq", 1},
                             {"frame", 3},
                             {"command", 16},
                             {"param2", 25},
                             {"x", 470053000},
                             {"y", -479912000},
                             {"z", 120},
                             {"current", 0},
                             {"autocontinue", 1}});
        QVERIFY(std::isnan(item.real("param4")));
        compareFields(decoded("MISSION_ACK_nospace_fence"), {{"type", 4}, {"mission_type", 1}});
        compareFields(decoded("MISSION_CURRENT"), {{"seq", 2},
                                                   {"total", 14},
                                                   {"mission_state", 3},
                                                   {"mission_mode", 1},
                                                   {"mission_id", 0x12345678}});
        compareFields(decoded("GLOBAL_POSITION_INT"), {{"time_boot_ms", 123456},
                                                       {"alt", 121500},
                                                       {"relative_alt", 120000},
                                                       {"vx", -1500},
                                                       {"vy", 1600},
                                                       {"vz", -20},
                                                       {"hdg", 31416}});
        compareFields(decoded("ATTITUDE"),
                      {{"roll", 0.1}, {"pitch", -0.05}, {"yaw", 1.5707964}, {"yawspeed", 0.2}});
        compareFields(decoded("VFR_HUD"), {{"airspeed", 22.5},
                                           {"groundspeed", 24.25},
                                           {"alt", 121.5},
                                           {"climb", -0.25},
                                           {"heading", 90},
                                           {"throttle", 55}});
        compareFields(decoded("WIND"), {{"direction", 270}, {"speed", 8.5}, {"speed_z", 0}});
        compareFields(decoded("COMMAND_INT_DO_REPOSITION"), {{"command", 192},
                                                             {"param1", -1},
                                                             {"param2", 1},
                                                             {"param3", 300},
                                                             {"frame", 3},
                                                             {"z", 120}});
        compareFields(decoded("COMMAND_LONG_SET_MESSAGE_INTERVAL"),
                      {{"command", 511}, {"param1", 33}, {"param2", 500000}});
        compareFields(decoded("SET_POSITION_TARGET_GLOBAL_INT"),
                      {{"type_mask", 0x0FF8}, {"coordinate_frame", 6}, {"alt", 120}});
    }

    void arraysAndTextsOfKnownFrames()
    {
        const LinkMessage battery = decoded("BATTERY_STATUS");
        compareFields(battery, {{"current_battery", 1250},
                                {"current_consumed", 3100},
                                {"battery_remaining", 72},
                                {"time_remaining", 3600},
                                {"charge_state", 1}});
        QCOMPARE(battery.integer("voltages", 0), std::int64_t{4100});
        QCOMPARE(battery.integer("voltages", 5), std::int64_t{4095});
        QCOMPARE(battery.integer("voltages", 6), std::int64_t{65535}); // no cell
        const LinkMessage text = decoded("STATUSTEXT");
        QCOMPARE(text.integer("severity"), std::int64_t{6});
        QCOMPARE(text.text("text"), "Reached waypoint #2 dist 24m");
        const LinkFrame isSigned = only(knownFrame("SIGNED_MISSION_ITEM_REACHED"));
        QCOMPARE(isSigned.signature->linkId, std::uint8_t{5});
        QCOMPARE(isSigned.signature->time_10us, std::uint64_t{123456789});
    }

    void framesThatMustHold()
    {
        for (const char* hex : {"fd0800000a01012f0000ffbe0000000000005690", // zeros not trimmed
                                "fd0300000a01012f0000ffbe0072ef"}) {        // base length only
            const LinkFrame frame = only(bytesOfHex(hex));
            QVERIFY(frame.message && frame.message->id() == MessageId::MissionAck);
            QCOMPARE(frame.message->integer("type"), std::int64_t{0});
        }
        const LinkFrame longer =
            only(bytesOfHex("fd0c000001ffbe2c00000e0001010000000000010203e67b"));
        QVERIFY(longer.message && longer.message->id() == MessageId::MissionCount);
        QCOMPARE(longer.message->integer("count"), std::int64_t{14});

        FrameParser parser;
        QVERIFY(parser.feedDatagram(bytesOfHex("fd0200000a01012f0000ffbe65a1")).empty());
        QCOMPARE(parser.counts().badChecksums, std::uint64_t{1});
        QVERIFY(parser.feedDatagram(bytesOfHex("fd0102000d01012e0000029d50")).empty());
        QCOMPARE(parser.counts().unknownFlags, std::uint64_t{1});

        const LinkFrame old = only(bytesOfHex("fe09070101000a00000001039d04030d3c"));
        QCOMPARE(old.version, 1);
        QVERIFY(old.message == only(knownFrame("HEARTBEAT_plane")).message);
    }

    void streamsArriveInAnyPieces()
    {
        std::vector<std::uint8_t> stream;
        for (const KnownFrame& known : kKnownFrames)
            for (std::uint8_t byte : bytesOfHex(known.hex))
                stream.push_back(byte);
        for (std::size_t piece : {1U, 2U, 7U, 300U}) {
            FrameParser parser;
            std::size_t found = 0;
            for (std::size_t at = 0; at < stream.size(); at += piece)
                found +=
                    parser.feed(std::span(stream).subspan(at, std::min(piece, stream.size() - at)))
                        .size();
            QCOMPARE(found, std::size(kKnownFrames));
            QCOMPARE(parser.counts().noise_bytes, std::uint64_t{0});
        }
    }

    /** An incomplete frame must not hide the next one. */
    void cutFramesHideNothing()
    {
        const std::vector<std::uint8_t> whole = knownFrame("MISSION_ITEM_INT");
        for (std::size_t length = 1; length < whole.size(); ++length) {
            std::vector<std::uint8_t> stream(whole.begin(),
                                             whole.begin() + static_cast<std::ptrdiff_t>(length));
            const std::vector<std::uint8_t> next = knownFrame("ATTITUDE");
            stream.insert(stream.end(), next.begin(), next.end());
            FrameParser parser;
            QCOMPARE(parser.feedDatagram(stream).size(), std::size_t{1});
        }
    }

    void unknownMessagesOfKnownSendersAreFrames()
    {
        FrameParser parser;
        QVERIFY(parser.feedDatagram(unknownFrame(6)).empty()); // its sender is unknown
        const std::vector<LinkFrame> frames =
            parser.feedDatagram(joined({knownFrame("HEARTBEAT_plane"), unknownFrame(8),
                                        unknownFrame(9), knownFrame("ATTITUDE")}));
        QCOMPARE(frames.size(), std::size_t{4});
        QVERIFY(!frames[1].message && !frames[2].message);
        QCOMPARE(frames[2].messageId, 27U);
        QCOMPARE(frames[2].sequence, std::uint8_t{9});
        QCOMPARE(parser.counts().unknown, std::uint64_t{2});

        // In a stream it counts only if the next frame begins at its end.
        FrameParser stream;
        QCOMPARE(stream.feed(knownFrame("HEARTBEAT_plane")).size(), std::size_t{1});
        QVERIFY(stream.feed(unknownFrame(8)).empty());
        QCOMPARE(stream.feed(knownFrame("ATTITUDE")).size(), std::size_t{2});
        QVERIFY(stream.feed(unknownFrame(9)).empty());
        QVERIFY(stream.feed(std::vector<std::uint8_t>{0x00}).empty());
        QCOMPARE(stream.counts().unknown, std::uint64_t{1});
    }

    /** BERGWATCH_LINK_BYTES sets the number of bytes (the slow test takes ten million). */
    void everyFrameIsFoundInNoise()
    {
        const char* wish = std::getenv("BERGWATCH_LINK_BYTES");
        const std::size_t wanted = wish != nullptr ? std::strtoull(wish, nullptr, 10) : 300'000;
        Random random(53);
        FrameParser parser;
        std::size_t sent_bytes = 0;
        std::size_t sent = 0;
        std::size_t found = 0;
        std::vector<std::vector<std::uint8_t>> expected;
        const auto take = [&](const std::vector<LinkFrame>& frames) {
            for (const LinkFrame& frame : frames) {
                if (frame.message && found < expected.size() && frame.bytes == expected[found])
                    ++found;
            }
        };
        while (sent_bytes < wanted) {
            std::vector<std::uint8_t> chunk(random.below(400));
            for (std::uint8_t& byte : chunk) { // start bytes more often than by chance
                byte = static_cast<std::uint8_t>(random.bits() & 0xFFU);
                if (random.below(20) == 0)
                    byte = random.below(2) == 0 ? 0xFD : 0xFE;
            }
            sent_bytes += chunk.size();
            for (std::uint64_t count = random.below(4); count > 0; --count) {
                const KnownFrame& known = kKnownFrames[random.below(std::size(kKnownFrames))];
                expected.push_back(bytesOfHex(known.hex));
                chunk.insert(chunk.end(), expected.back().begin(), expected.back().end());
                ++sent;
            }
            take(parser.feed(chunk));
        }
        take(parser.finish());
        QVERIFY(sent > wanted / 400);
        QCOMPARE(found, sent);
        QCOMPARE(parser.counts().frames - parser.counts().unknown, std::uint64_t{sent});
    }

    void valuesOutsideAFieldAreCutToIt()
    {
        LinkMessage message(MessageId::GlobalPositionInt);
        message.with("vx", 100'000).with("vy", -100'000).with("hdg", -5);
        QCOMPARE(message.integer("vx"), std::int64_t{32767});
        QCOMPARE(message.integer("vy"), std::int64_t{-32768});
        QCOMPARE(message.integer("hdg"), std::int64_t{0});
        LinkMessage text(MessageId::StatusText);
        text.withText("text", std::string(60, 'x'));
        QCOMPARE(text.text("text"), std::string(50, 'x'));
        QVERIFY_THROWS_EXCEPTION(std::logic_error, (void)text.integer("nothing"));
        QVERIFY_THROWS_EXCEPTION(std::logic_error, (void)text.integer("severity", 1));
    }
};

QTEST_APPLESS_MAIN(TestLinkFrame)
#include "tst_link_frame.moc"
