#include "core/base/random.h"
#include "core/link/logs/telemetry_log.h"
#include "tests/support/flight/known_frames.h"

#include <QtTest>

using namespace berg;
using namespace berg::test;

namespace {

constexpr std::int64_t kStart_us = 1'790'000'000'000'000;

std::vector<std::uint8_t> logOfKnownFrames()
{
    std::vector<std::uint8_t> log;
    std::int64_t time_us = kStart_us;
    for (const KnownFrame& known : kKnownFrames) {
        const std::vector<std::uint8_t> record = logRecord(time_us, bytesOfHex(known.hex));
        log.insert(log.end(), record.begin(), record.end());
        time_us += 100'000;
    }
    return log;
}

std::vector<LoggedFrame> read(TelemetryLogReader& reader, std::span<const std::uint8_t> log,
                              std::size_t piece)
{
    std::vector<LoggedFrame> all;
    const auto append = [&](std::vector<LoggedFrame> some) {
        all.insert(all.end(), some.begin(), some.end());
    };
    for (std::size_t at = 0; at < log.size(); at += piece)
        append(reader.feed(log.subspan(at, std::min(piece, log.size() - at))));
    append(reader.finish());
    return all;
}

} // namespace

class TestTelemetryLog : public QObject
{
    Q_OBJECT

private slots:
    /** pymavlink's mavutil writes struct.pack('>Q', microseconds), then the frame. */
    void recordIsTimeAndFrame()
    {
        const std::vector<std::uint8_t> expected =
            bytesOfHex("00065bfe8a2b1234fd0100001701012c000000fbe3");
        QVERIFY(logRecord(0x00065bfe8a2b1234, knownFrame("MISSION_COUNT_zero")) == expected);
    }

    void whatWasWrittenIsReadBack()
    {
        const std::vector<std::uint8_t> log = logOfKnownFrames();
        for (std::size_t piece : {std::size_t{1}, std::size_t{64}, log.size()}) {
            TelemetryLogReader reader;
            const std::vector<LoggedFrame> found = read(reader, log, piece);
            QCOMPARE(found.size(), std::size(kKnownFrames));
            QCOMPARE(reader.skipped_bytes(), std::uint64_t{0});
            for (std::size_t i = 0; i < found.size(); ++i) {
                QCOMPARE(found[i].unix_us, kStart_us + 100'000 * static_cast<std::int64_t>(i));
                QVERIFY(found[i].frame.bytes == bytesOfHex(kKnownFrames[i].hex));
            }
        }
    }

    void damageCostsTheDamagedRecordsOnly()
    {
        const std::vector<std::uint8_t> log = logOfKnownFrames();
        Random random(9);
        for (int round = 0; round < 50; ++round) {
            std::vector<std::uint8_t> damaged = log;
            damaged[random.below(damaged.size())] ^= 0x10U;
            TelemetryLogReader reader;
            // One record is lost, or none if a bit of a time stamp has changed.
            const std::size_t found = read(reader, damaged, damaged.size()).size();
            QVERIFY2(found >= std::size(kKnownFrames) - 1, std::to_string(found).c_str());
        }
        const std::span<const std::uint8_t> cut = std::span(log).first(log.size() - 3);
        TelemetryLogReader reader;
        QCOMPARE(read(reader, cut, cut.size()).size(), std::size(kKnownFrames) - 1);
        QVERIFY(reader.skipped_bytes() > 0);
    }
};

QTEST_APPLESS_MAIN(TestTelemetryLog)
#include "tst_telemetry_log.moc"
