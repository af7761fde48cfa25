#include "core/link/message/frame_signing.h"
#include "tests/support/flight/known_frames.h"

#include <QtTest>

#include <numeric>

using namespace berg;
using namespace berg::test;

namespace {

SigningKey countingKey()
{
    SigningKey key{};
    std::iota(key.begin(), key.end(), std::uint8_t{0});
    return key;
}

LinkFrame frameOf(const std::vector<std::uint8_t>& bytes)
{
    FrameParser parser;
    return parser.feedDatagram(bytes).at(0);
}

constexpr std::int64_t kEpoch_us = 1'420'070'400'000'000;
constexpr LinkAddress kVehicle{.system = 1, .component = 1};

} // namespace

class TestFrameSigning : public QObject
{
    Q_OBJECT

private slots:
    /** A frame signed by MAVLink's C library equals ours byte for byte. */
    void signedFrameOfTheLibrary()
    {
        const std::vector<std::uint8_t> expected = knownFrame("SIGNED_MISSION_ITEM_REACHED");
        FrameWriter writer(kVehicle, countingKey(), 5);
        LinkMessage message(MessageId::MissionItemReached);
        std::vector<std::uint8_t> bytes;
        // The frame has number 24; time stamps increase by themselves.
        for (int i = 0; i <= 24; ++i)
            bytes = writer.write(message.with("seq", 2),
                                 kEpoch_us + 10 * (std::int64_t{123456789} - 24 + i));
        QVERIFY(bytes == expected);
        SignatureChecker checker(countingKey());
        QCOMPARE(checker.check(frameOf(expected)), SignatureVerdict::Valid);
    }

    void changedAndRepeatedFramesAreRefused()
    {
        SignatureChecker checker(countingKey());
        FrameWriter writer(kVehicle, countingKey());
        const LinkMessage message(MessageId::Heartbeat);
        const std::vector<std::uint8_t> first = writer.write(message, kEpoch_us);
        // The clock has not advanced.
        const std::vector<std::uint8_t> second = writer.write(message, kEpoch_us);
        QCOMPARE(checker.check(frameOf(first)), SignatureVerdict::Valid);
        QCOMPARE(checker.check(frameOf(second)), SignatureVerdict::Valid);
        QCOMPARE(checker.check(frameOf(second)), SignatureVerdict::TooOld);
        QCOMPARE(checker.check(frameOf(first)), SignatureVerdict::TooOld);
        std::vector<std::uint8_t> changed = writer.write(message, kEpoch_us + 1000);
        changed.back() ^= 1U;
        QCOMPARE(checker.check(frameOf(changed)), SignatureVerdict::WrongTag);
        SigningKey other = countingKey();
        other[0] = 7;
        QCOMPARE(SignatureChecker(other).check(frameOf(first)), SignatureVerdict::WrongTag);
        QCOMPARE(SignatureChecker(std::nullopt).check(frameOf(first)), SignatureVerdict::NoKey);
        QCOMPARE(checker.check(frameOf(knownFrame("ATTITUDE"))), SignatureVerdict::Unsigned);
    }

    void newStreamsMayBeAMinuteBehind()
    {
        SignatureChecker checker(countingKey());
        const LinkMessage message(MessageId::Heartbeat);
        const auto verdictOf = [&](std::uint8_t link, std::int64_t time_s) {
            FrameWriter writer(kVehicle, countingKey(), link);
            return checker.check(frameOf(writer.write(message, kEpoch_us + 1'000'000 * time_s)));
        };
        QCOMPARE(verdictOf(0, 100), SignatureVerdict::Valid);
        QCOMPARE(verdictOf(1, 41), SignatureVerdict::Valid);
        QCOMPARE(verdictOf(2, 39), SignatureVerdict::TooOld);
    }

    void streamsAreLimited()
    {
        SignatureChecker checker(countingKey());
        const LinkMessage message(MessageId::Heartbeat);
        int refused = 0;
        for (int link = 0; link < 256; ++link)
            for (std::uint8_t system : {std::uint8_t{1}, std::uint8_t{2}}) {
                FrameWriter writer({.system = system, .component = 1}, countingKey(),
                                   static_cast<std::uint8_t>(link));
                const SignatureVerdict verdict =
                    checker.check(frameOf(writer.write(message, kEpoch_us + 1'000'000)));
                refused += verdict == SignatureVerdict::TooManyStreams ? 1 : 0;
            }
        QCOMPARE(refused, 256);
    }
};

QTEST_APPLESS_MAIN(TestFrameSigning)
#include "tst_frame_signing.moc"
