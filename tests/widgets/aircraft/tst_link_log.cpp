#include "core/link/logs/telemetry_log.h"
#include "widgets/aircraft/link_log.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

constexpr std::int64_t kTime_us = 1'790'000'000'000'000;

std::vector<std::uint8_t> someFrame()
{
    return frameBytes(LinkMessage(MessageId::Heartbeat).with("autopilot", 3),
                      {.system = 1, .component = 1}, 0);
}

} // namespace

class TestLinkLog : public QObject
{
    Q_OBJECT

private slots:
    void recordsAreReadBack()
    {
        const QTemporaryDir folder;
        const QString path = LinkLog::newPathIn(folder.filePath(u"new/logs"_s));
        QVERIFY(path.endsWith(u".tlog"_s));
        {
            LinkLog log(path);
            QVERIFY(!QFile::exists(path)); // created with the first frame
            log.add({.unix_us = kTime_us}, someFrame());
            log.flush();
            QVERIFY(log.report().fault.empty());
            QCOMPARE(QString::fromStdString(log.report().path), path);
            QCOMPARE(log.report().bytes, static_cast<std::uint64_t>(QFile(path).size()));
        }
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        TelemetryLogReader reader;
        std::vector<LoggedFrame> frames =
            reader.feed({reinterpret_cast<const std::uint8_t*>(bytes.constData()),
                         static_cast<std::size_t>(bytes.size())});
        for (LoggedFrame& last : reader.finish())
            frames.push_back(std::move(last));
        QCOMPARE(frames.size(), std::size_t{1});
        QCOMPARE(frames.front().unix_us, kTime_us);
        QVERIFY(frames.front().frame.bytes == someFrame());
    }

    void fullDiskEndsTheLog()
    {
        LinkLog log(u"/dev/full"_s); // opens, but has no room
        log.add({.unix_us = kTime_us}, someFrame());
        log.flush();
        QVERIFY(!log.report().fault.empty());
        const std::uint64_t bytes = log.report().bytes;
        log.add({.unix_us = kTime_us}, someFrame());
        QCOMPARE(log.report().bytes, bytes);
    }

    void folderThatCannotBeMadeIsReported()
    {
        LinkLog log(u"/dev/null/logs/a.tlog"_s);
        log.add({.unix_us = kTime_us}, someFrame());
        QVERIFY(!log.report().fault.empty());
        QCOMPARE(log.report().bytes, std::uint64_t{0});
    }

    void namesDiffer()
    {
        const QTemporaryDir folder;
        const QString first = LinkLog::newPathIn(folder.path());
        QFile file(first);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QVERIFY(LinkLog::newPathIn(folder.path()) != first);
    }
};

QTEST_GUILESS_MAIN(TestLinkLog)
#include "tst_link_log.moc"
