#include "core/link/link_session.h"
#include "core/link/logs/log_replay.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <sys/stat.h>

using namespace berg;

namespace {

constexpr std::int64_t kStart_us = 1'790'000'000'000'000;
constexpr LinkAddress kVehicle{.system = 1, .component = 1};

/** A record with a heartbeat of a vehicle. */
std::vector<std::uint8_t> heartbeat(std::int64_t time_us, std::uint8_t number = 0)
{
    return logRecord(time_us, frameBytes(LinkMessage(MessageId::Heartbeat)
                                             .with("type", 1)
                                             .with("autopilot", 3)
                                             .with("custom_mode", number),
                                         kVehicle, number));
}

class LogFolder
{
public:
    /** Writes a log and returns its path. */
    std::string file(const std::vector<std::uint8_t>& bytes)
    {
        const QString path = m_folder.filePath(QStringLiteral("a.tlog"));
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly))
            qFatal("no file");
        file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<qint64>(bytes.size()));
        return path.toStdString();
    }
    std::string path(const char* name)
    {
        return m_folder.filePath(QString::fromLatin1(name)).toStdString();
    }

private:
    QTemporaryDir m_folder;
};

void append(std::vector<std::uint8_t>& log, const std::vector<std::uint8_t>& bytes)
{
    log.insert(log.end(), bytes.begin(), bytes.end());
}

int received(LogReplay& replay)
{
    int count = 0;
    while (replay.receive())
        ++count;
    return count;
}

std::unique_ptr<LogReplay> opened(const std::string& path)
{
    auto result = LogReplay::open(path);
    if (auto* replay = std::get_if<std::unique_ptr<LogReplay>>(&result))
        return std::move(*replay);
    return nullptr;
}

std::optional<LogFault> faultOf(const std::string& path)
{
    auto result = LogReplay::open(path);
    const LogFault* fault = std::get_if<LogFault>(&result);
    return fault != nullptr ? std::optional(*fault) : std::nullopt;
}

} // namespace

class TestLogReplay : public QObject
{
    Q_OBJECT

private slots:
    void framesComeAtTheirTimes()
    {
        LogFolder folder;
        std::vector<std::uint8_t> log;
        for (int i = 0; i < 10; ++i)
            append(log, heartbeat(kStart_us + i * 500'000, static_cast<std::uint8_t>(i)));
        const auto replay = opened(folder.file(log));
        QVERIFY(replay != nullptr);
        QCOMPARE(received(*replay), 1); // the first one
        QCOMPARE(replay->time().unix_us, kStart_us);
        QCOMPARE(replay->time().monotonic_s, LogReplay::kStart_s);
        replay->advance(0.4);
        QCOMPARE(received(*replay), 0);
        replay->advance(0.7);
        QCOMPARE(received(*replay), 2);
        QVERIFY(std::abs(replay->part() - 0.3) < 0.01); // 3 of 10 frames
        QCOMPARE(replay->time().unix_us, kStart_us + 1'100'000);
        QVERIFY(!replay->isAtEnd());
        replay->advance(100);
        QCOMPARE(received(*replay), 7);
        QVERIFY(replay->isAtEnd());
        QCOMPARE(replay->part(), 1.0);
        QCOMPARE(replay->played_s(), 4.5); // the clock stops with the last frame
        QCOMPARE(replay->time().unix_us, kStart_us + 4'500'000);
    }

    /** A clock that is set during the flight neither stops the replay nor makes it rush. */
    void jumpsOfTheClockCostNoTime()
    {
        LogFolder folder;
        std::vector<std::uint8_t> log;
        const std::int64_t year_us = 365 * std::int64_t{86'400'000'000};
        append(log, heartbeat(0, 0)); // not set yet: 1970
        append(log, heartbeat(1'000'000, 1));
        append(log, heartbeat(kStart_us, 2));
        append(log, heartbeat(kStart_us + 1'000'000, 3));
        append(log, heartbeat(kStart_us - year_us, 4));
        append(log, heartbeat(kStart_us - year_us + 1'000'000, 5));
        const auto replay = opened(folder.file(log));
        QVERIFY(replay != nullptr);
        int count = received(*replay);
        for (int i = 0; i < 31; ++i) {
            replay->advance(0.1);
            count += received(*replay);
        }
        QCOMPARE(count, 6);
        QCOMPARE(replay->played_s(), 3.0);
        QCOMPARE(replay->time().unix_us, kStart_us - year_us + 1'000'000);
    }

    void mixedFramesKeepTheTime()
    {
        LogFolder folder;
        std::vector<std::uint8_t> log;
        for (int i = 0; i < 100; ++i) { // pairs in the wrong order
            append(log, heartbeat(kStart_us + i * 100'000 + 5'000));
            append(log, heartbeat(kStart_us + i * 100'000));
        }
        const auto replay = opened(folder.file(log));
        QVERIFY(replay != nullptr);
        replay->advance(1000);
        QCOMPARE(received(*replay), 200);
        QVERIFY(std::abs(replay->played_s() - 9.9) < 0.01);
    }

    void damageIsSkipped()
    {
        LogFolder folder;
        std::vector<std::uint8_t> log = heartbeat(kStart_us);
        log.insert(log.end(), std::size_t{3} << 20U, 0xFD); // more than is read at once
        append(log, heartbeat(kStart_us + 1'000'000, 1));
        log.insert(log.end(), 20, 7);
        const auto replay = opened(folder.file(log));
        QVERIFY(replay != nullptr);
        int count = received(*replay);
        for (int i = 0; i < 20 && !replay->isAtEnd(); ++i) {
            replay->advance(1);
            count += received(*replay);
        }
        QCOMPARE(count, 2);
        QVERIFY(replay->isAtEnd());
        QCOMPARE(replay->skipped_bytes(), (std::uint64_t{3} << 20U) + 20);
    }

    void othersAreNoLogs()
    {
        LogFolder folder;
        QCOMPARE(faultOf(folder.path("missing")).value().kind, LogFault::Kind::Unreadable);
        QVERIFY(!faultOf(folder.path("missing"))->reason.empty());
        QCOMPARE(faultOf(folder.path("."))->kind, LogFault::Kind::Unreadable);
        QCOMPARE(faultOf(folder.file({})).value().kind, LogFault::Kind::NotALog);
        const std::vector<std::uint8_t> text(5'000'000, 'x');
        QCOMPARE(faultOf(folder.file(text)).value().kind, LogFault::Kind::NotALog);
        const std::string pipe = folder.path("pipe"); // opening it would wait for a writer
        QCOMPARE(::mkfifo(pipe.c_str(), 0600), 0);
        QCOMPARE(faultOf(pipe).value().kind, LogFault::Kind::Unreadable);
    }

    /** A session hears the vehicle of the log, and nothing can be sent to it. */
    void sessionHearsTheVehicle()
    {
        LogFolder folder;
        std::vector<std::uint8_t> log;
        for (int i = 0; i < 5; ++i)
            append(log, heartbeat(kStart_us + i * 1'000'000));
        const auto replay = opened(folder.file(log));
        QVERIFY(replay != nullptr);
        LinkSession session(*replay, {.self = {}});
        static_cast<void>(session.advance(replay->time()));
        QVERIFY(session.findVehicle(kVehicle) != nullptr);
        for (int i = 0; i < 100; ++i) {
            replay->advance(0.25);
            static_cast<void>(session.advance(replay->time()));
        }
        QVERIFY(!session.findVehicle(kVehicle)->isLost); // the clock stops with the log
        QVERIFY(replay->peers().empty());
    }
};

QTEST_APPLESS_MAIN(TestLogReplay)
#include "tst_log_replay.moc"
